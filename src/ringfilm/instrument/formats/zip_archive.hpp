#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ringfilm::instrument {

/// A zip archive that is read entry by entry, each with a bound on what it may unpack to.
class ZipArchive {
 public:
  /// Throws InputError if the file is not a zip archive or a damaged one. @param path also the name for messages
  explicit ZipArchive(const std::string& path);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// The names of all entries, in the order of the archive.
  std::vector<std::string> names() const;

  /// The unpacked size that the archive states [byte]; nothing if there is no such entry.
  std::optional<std::uint64_t> size(const std::string& name) const;

  /// The whole entry. Throws InputError if it is missing, damaged or larger than `limit` [byte].
  std::string read(const std::string& name, std::uint64_t limit) const;

  /// Hands the entry over piece by piece, `length` bytes in all. Throws InputError if it holds more or fewer.
  void read_pieces(const std::string& name, std::uint64_t length,
                   const std::function<void(std::string_view)>& take) const;

 private:
  struct Handle;
  std::string path_;
  std::unique_ptr<Handle> handle_;
};

/// The bytes of an archive of these entries, not compressed and all with the same date: the same entries, the same
/// bytes.
std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace ringfilm::instrument
