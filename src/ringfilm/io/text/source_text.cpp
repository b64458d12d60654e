#include "ringfilm/io/text/source_text.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "ringfilm/io/storage/digest.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/foreign_file.hpp"
#include "ringfilm/io/text/text_encoding.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const SourceMark& mark, const std::string& message, const std::string& remedy) {
  throw InputError(std::vector<Fault>{{mark, message, remedy}});
}

/// @param shown the file, which may be one of the shipped data
std::string remedy_of_missing(const std::string& shown) {
  const std::string remedy = "check the name and the folder";
  if (!shown.starts_with("data/") || find_shipped_folder()) return remedy;
  const Fault missing = missing_shipped_folder();
  return remedy + "; " + missing.message + ": " + missing.remedy;
}

}  // namespace

std::string read_source_bytes(const std::string& path, const std::string& shown, std::size_t limit) {
  const SourceMark file{shown, 0, 0, ""};
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) refuse(file, "there is no such file", remedy_of_missing(shown));
  if (fs::is_directory(status)) refuse(file, "this is a folder, not a file", "name the file in it");
  // To open a pipe waits for somebody who writes into it.
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuse(file, "this is a device or a pipe, not a file", "put its content into a file first");
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    refuse(file, std::string("the file cannot be read: ") + std::strerror(errno != 0 ? errno : EIO),
           "check who may read it");
  }
  std::string bytes;
  std::string block(1 << 16, '\0');
  while (bytes.size() <= limit && in.read(block.data(), static_cast<std::streamsize>(block.size())).gcount() > 0) {
    bytes.append(block, 0, static_cast<std::size_t>(in.gcount()));
  }
  if (bytes.size() > limit) {
    refuse(file, "the file is larger than " + std::to_string(limit >> 20) + " MB", "is it the right file?");
  }
  return bytes;
}

namespace {

/// Takes the byte-order mark off and brings line ends to "\n".
std::string normalised(std::string_view bytes, bool& has_byte_order_mark) {
  has_byte_order_mark = bytes.starts_with("\xEF\xBB\xBF");
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t i = has_byte_order_mark ? 3 : 0; i < bytes.size(); ++i) {
    if (bytes[i] != '\r') {
      text += bytes[i];
    } else if (i + 1 == bytes.size() || bytes[i + 1] != '\n') {
      text += '\n';
    }
  }
  return text;
}

/// Refuses files of known other kinds where a text is read, before their bytes are searched for what is not text.
void refuse_other_kinds(const SourceMark& file, const std::string& bytes) {
  if (const std::optional<Fault> fault = foreign_file_fault(file, bytes)) throw InputError(std::vector<Fault>{*fault});
  if (!begins_as_netcdf(bytes)) return;
  if (!has_digest_trailer(bytes)) {
    refuse(file, "this is a NetCDF file, not text",
           std::string("is it the right file? If it is another HDF5 file, ") + kHdf5Remedy);
  }
  refuse(file, "this is a NetCDF file that ringfilm wrote, not text",
         "name the file that it was computed from; a web page of a result is drawn by ringfilm report " + file.file +
             " --output X.html");
}

void check_text(const SourceText& source) {
  int line = 1;
  std::size_t line_start = 0;
  for (std::size_t i = 0; i < source.text.size();) {
    const char c = source.text[i];
    const bool control = (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n') || c == '\x7f';
    const SourceMark here{source.path, line, static_cast<int>(i - line_start) + 1, ""};
    if (control) refuse(here, "the file is binary, not text", "is it the right file?");
    const std::size_t length = utf8_length(source.text, i);
    if (length == 0) refuse(here, "the file is not UTF-8 text", "save it as UTF-8");
    i += length;
    if (c == '\n') {
      ++line;
      line_start = i;
    }
  }
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < text.size()) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

}  // namespace

SourceMark SourceText::mark(int line, int column) const {
  const bool known = line >= 1 && line <= static_cast<int>(lines.size());
  return {path, line, column, known ? lines[line - 1] : std::string()};
}

namespace {

SourceText source_of(const std::string& shown, std::string_view text, const std::string& bytes) {
  SourceText source;
  source.path = shown;
  source.sha256 = sha256(bytes);
  source.text = normalised(text, source.has_byte_order_mark);
  check_text(source);
  if (source.text.find_first_not_of(" \t\n") == std::string::npos)
    refuse({shown, 0, 0, ""}, "the file is empty", "is it the right file?");
  source.lines = split_lines(source.text);
  return source;
}

}  // namespace

SourceText read_source_text(const std::string& path, const std::string& shown, std::size_t limit) {
  const std::string bytes = read_source_bytes(path, shown, limit);
  const SourceMark file{shown, 0, 0, ""};
  if (bytes.rfind("\xFF\xFE", 0) == 0 || bytes.rfind("\xFE\xFF", 0) == 0) {
    refuse(file, "the file is UTF-16 text", "save it as UTF-8");
  }
  refuse_other_kinds(file, bytes);
  return source_of(shown, bytes, bytes);
}

SourceText read_table_text(const std::string& path, const std::string& shown, std::size_t limit) {
  const std::string bytes = read_source_bytes(path, shown, limit);
  refuse_other_kinds({shown, 0, 0, ""}, bytes);
  const std::optional<DecodedText> text = decoded(bytes);
  SourceText source = source_of(shown, text ? text->text : bytes, bytes);
  if (text) source.encoding = text->encoding;
  return source;
}

NamedFile locate(const std::string& name, const std::string& folder) {
  const std::string beside = (fs::path(folder) / name).lexically_normal().string();
  std::error_code error;
  if (name.rfind("data/", 0) == 0 && !fs::exists(beside, error)) {
    const std::optional<std::string> shipped = find_shipped_folder();
    if (shipped) {
      const std::string path = (fs::path(*shipped) / name).lexically_normal().string();
      if (fs::exists(path, error)) return {path, name};
    }
  }
  return {beside, beside};
}

}  // namespace ringfilm::io
