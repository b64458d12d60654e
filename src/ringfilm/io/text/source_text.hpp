#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"

/// Text files that people write: read whole, refused early where they are not text.
namespace ringfilm::io {

inline constexpr std::size_t kMaxToml = std::size_t{4} << 20;  ///< [byte]
inline constexpr std::size_t kMaxCsv = std::size_t{64} << 20;  ///< [byte]

/// A file as its lines; line ends of any system are removed.
struct SourceText {
  std::string path;                ///< as the messages name it
  std::string text;                ///< UTF-8 without byte-order mark, line ends "\n"
  std::vector<std::string> lines;  ///< lines of `text`
  std::string sha256;              ///< SHA-256 of the bytes in the file
  std::string encoding;            ///< encoding of a file that is not UTF-8: "UTF-16", "Windows-1252"; else empty
  bool has_byte_order_mark = false;

  /// The place in this file; line and column count from 1.
  SourceMark mark(int line, int column = 0) const;
};

/// Reads the file at `path`, named `shown` in messages. Throws InputError for what is not a such text: missing,
/// unreadable, a directory, larger than `limit` bytes, empty, binary (control characters) or not UTF-8.
SourceText read_source_text(const std::string& path, const std::string& shown, std::size_t limit);

/// Reads the text of a table of numbers, which other programs write: UTF-8, UTF-16 or Windows-1252. Throws InputError
/// otherwise as read_source_text().
SourceText read_table_text(const std::string& path, const std::string& shown, std::size_t limit);

/// The bytes of the file at `path`, named `shown` in messages. Throws InputError: missing, unreadable, a directory, a
/// device, larger than `limit` bytes.
std::string read_source_bytes(const std::string& path, const std::string& shown, std::size_t limit);

/// Where a file lies that another file names, and how to call it.
struct NamedFile {
  std::string path;   ///< to open
  std::string shown;  ///< for people and for the record: as reached from the working folder
};

/// A file name is relative to the folder of the file that names it; "data/..." is looked for in the shipped folder too.
NamedFile locate(const std::string& name, const std::string& folder);

}  // namespace ringfilm::io
