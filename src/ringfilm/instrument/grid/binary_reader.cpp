#include "ringfilm/instrument/grid/binary_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/grid/channel.hpp"

namespace ringfilm::instrument {

namespace fs = std::filesystem;

void refuse(const std::string& file, const std::string& message, const std::string& remedy) {
  throw InputError(std::vector<Fault>{{{file, 0, 0, ""}, message, remedy}});
}

std::string file_bytes(const std::string& path, std::size_t limit) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) refuse(path, "there is no such file", "check the name and the folder");
  if (fs::is_directory(status)) refuse(path, "this is a folder, not a file", "name the file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    refuse(path, "this is a device or a pipe, not a file", "put its content into a file first");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) refuse(path, "the file cannot be read: " + error.message(), "check who may read it");
  if (size == 0) refuse(path, "the file is empty", "copy it again from the instrument");
  if (size > limit) {
    refuse(path, fmt::format("the file has {} bytes, over the limit of {}", size, limit),
           "cut the measurement into parts, or export fewer channels");
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size))) {
    refuse(path, std::string("the file cannot be read: ") + std::strerror(errno != 0 ? errno : EIO),
           "check who may read it");
  }
  return bytes;
}

std::size_t checked_points(const std::string& file, std::uint64_t points_x, std::uint64_t points_y) {
  if (points_x == 0 || points_y == 0 || (points_x == 1 && points_y == 1)) {
    refuse(file, fmt::format("the file states {} x {} points", points_x, points_y), "two or more points are required");
  }
  if (points_x > kMaxPoints || points_y > kMaxPoints / points_x) {
    refuse(file, fmt::format("the file states {} x {} points, over the limit of {}", points_x, points_y, kMaxPoints),
           "if it is that large, cut it into parts; else the header is damaged");
  }
  return static_cast<std::size_t>(points_x * points_y);
}

std::string_view BinaryReader::at(std::size_t offset, std::size_t length, const std::string& what) const {
  if (offset > bytes_.size() || length > bytes_.size() - offset) {
    refuse_at(offset,
              fmt::format("{} needs {} bytes from byte {} on, and there are {}: the file ends after {}", what, length,
                          offset, bytes_.size() - std::min(offset, bytes_.size()), bytes_.size()),
              "the file was cut short or its header is damaged: copy it again from the instrument");
  }
  return bytes_.substr(offset, length);
}

std::string BinaryReader::text(std::size_t offset, std::size_t length, const std::string& what) const {
  std::string_view field = at(offset, length, what);
  field = field.substr(0, field.find('\0'));
  return trimmed(utf8_from(field));
}

void BinaryReader::end_at(std::size_t offset, const std::string& what) const {
  if (offset >= bytes_.size()) return;
  refuse_at(offset, fmt::format("{} ends here, and {} more bytes follow", what, bytes_.size() - offset),
            "the size in the header is smaller than the data: copy or export the file again");
}

void BinaryReader::refuse_at(std::size_t offset, const std::string& message, const std::string& remedy) const {
  refuse(file_, fmt::format("byte {}: {}", offset, message), remedy);
}

namespace {

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t more = first < 0x80 ? 0 : first >= 0xC2 && first < 0xE0 ? 1 : (first & 0xF0) == 0xE0 ? 2 : 9;
    if (more == 9 || i + more >= text.size() + (more == 0)) return false;
    for (std::size_t k = 1; k <= more; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0u) != 0x80u) return false;
    }
    i += more + 1;
  }
  return true;
}

}  // namespace

std::string utf8_from(std::string_view text) {
  const bool latin = !is_utf8(text);
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      result += ' ';
    } else if (latin && byte >= 0x80) {
      result += static_cast<char>(0xC0u | (byte >> 6));
      result += static_cast<char>(0x80u | (byte & 0x3Fu));
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace ringfilm::instrument
