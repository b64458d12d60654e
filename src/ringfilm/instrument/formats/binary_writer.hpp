#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace ringfilm::instrument {

/// Bytes of a file, low byte first on any machine.
class BinaryWriter {
 public:
  explicit BinaryWriter(std::size_t header_size) : bytes_(header_size, '\0') {}

  /// Puts a number into the header.
  template <class Number>
  void number(std::size_t offset, Number value) {
    const std::string bytes = little(value);
    bytes_.replace(offset, bytes.size(), bytes);
  }

  /// Puts a text into a field of the header, cut or filled with blanks.
  void text(std::size_t offset, std::size_t length, std::string_view value) {
    std::string field(value.substr(0, length));
    field.resize(length, ' ');
    bytes_.replace(offset, length, field);
  }

  /// Appends a number.
  template <class Number>
  void append(Number value) {
    bytes_ += little(value);
  }

  std::string take() { return std::move(bytes_); }

 private:
  template <class Number>
  static std::string little(Number value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    constexpr std::uint16_t kOne = 1;
    char first = 0;
    std::memcpy(&first, &kOne, 1);
    return first == 1 ? bytes : std::string(bytes.rbegin(), bytes.rend());
  }

  std::string bytes_;
};

}  // namespace ringfilm::instrument
