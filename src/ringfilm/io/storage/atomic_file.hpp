#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace ringfilm::io {

/// What may exist under the name of an output.
enum class Sink {
  kFile,         ///< a file or nothing yet
  kFileOrDevice  ///< also a device or a pipe, e.g. /dev/stdout
};

/// Can it be written there? Throws InputError if the folder does not exist or is not writable, or if `path` is a folder
/// or otherwise not what `sink` states, if its name is too long, or if it is the device /dev/full: the program asks
/// this before it computes. Changes nothing on the disk.
void check_can_write(const std::string& path, Sink sink);

/// Keeps an output for this process while it computes: of two that compute one file the last would win. Holds an empty
/// file `target`.partial-<process>, locked; what a kill leaves of it is removed by the next one. A device is not
/// claimed.
class OutputClaim {
 public:
  /// Throws InputError where another process, on this machine or, in a shared folder with locks, on another one, holds
  /// a claim to the file; OutputError.
  explicit OutputClaim(const std::string& path);
  OutputClaim(OutputClaim&& other) noexcept;
  OutputClaim& operator=(OutputClaim&&) = delete;
  ~OutputClaim();

 private:
  std::string partial_;
  int file_ = -1;
};

/// A file that appears under its name all at once: filled aside in the same folder (`target`.partial-<process>),
/// flushed to the disk and renamed over an earlier file. A kill leaves the old file and at most the partial
/// one, which the next AsideFile of the same target removes. A symbolic link is followed.
class AsideFile {
 public:
  /// Creates the empty file aside; throws OutputError with path and reason.
  explicit AsideFile(const std::string& target);
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;
  /// Removes the file aside if it was not put in place.
  ~AsideFile();

  /// The name to write to.
  const std::string& path() const { return path_; }

  /// Writes these bytes alone into it and flushes them to the disk, so that it is full before another is put in place;
  /// throws OutputError.
  void fill(std::string_view bytes);

  /// Writes these bytes after those that it has; throws OutputError.
  void append(std::string_view bytes);

  /// Reserves so many bytes on the disk, so that writing them cannot meet a full one; what is not needed is
  /// given back when the file is put in place. Where the file system cannot do that, the free space must suffice.
  /// Throws OutputError with the space that is required.
  void reserve(std::uint64_t bytes);

  /// Flushes and renames; throws OutputError, an earlier file is then untouched.
  void put_in_place();

 private:
  std::string target_;
  std::string path_;
  bool is_reserved_ = false;
};

/// Puts `bytes` into the file `path` through an AsideFile; a device or a pipe is written directly. Throws OutputError.
void write_atomically(const std::string& path, std::string_view bytes);

/// The error of a file that could not be written, with the reason and whether there is a file of that name, which then
/// is what it was before.
[[noreturn]] void fail_to_write(const std::string& path, const std::string& reason);
/// The error of a file that could not be written, with the reason of an errno value.
[[noreturn]] void fail_to_write(const std::string& path, int error_number);

}  // namespace ringfilm::io
