#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ringfilm::instrument {

/// Refuses the file as a whole.
[[noreturn]] void refuse(const std::string& file, const std::string& message, const std::string& remedy);

/// The bytes of a regular file. Throws InputError if it is missing, unreadable, empty or larger than `limit` [byte].
std::string file_bytes(const std::string& path, std::size_t limit);

/// points_x * points_y, which must be 2 or more and no more than kMaxPoints. Throws InputError.
std::size_t checked_points(const std::string& file, std::uint64_t points_x, std::uint64_t points_y);

enum class ByteOrder { kLittle, kBig };

/// The number at `bytes`, which has room for it, on a machine of any byte order.
template <class Number>
Number number_at(const char* bytes, ByteOrder order) {
  unsigned char turned[sizeof(Number)];
  constexpr std::uint16_t kOne = 1;
  unsigned char first = 0;
  std::memcpy(&first, &kOne, 1);
  const bool same = (first == 1) == (order == ByteOrder::kLittle);
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    turned[i] = static_cast<unsigned char>(bytes[same ? i : sizeof(Number) - 1 - i]);
  }
  Number value;
  std::memcpy(&value, turned, sizeof value);
  return value;
}

/// Bytes of a file with their bounds: whatever lies past the end is an InputError that names the offset.
class BinaryReader {
 public:
  /// @param bytes must outlive the reader
  BinaryReader(std::string file, std::string_view bytes, ByteOrder order = ByteOrder::kLittle)
      : file_(std::move(file)), bytes_(bytes), order_(order) {}

  const std::string& file() const { return file_; }
  std::size_t size() const { return bytes_.size(); }
  ByteOrder order() const { return order_; }

  /// `length` bytes from `offset`. @param what they are, for the message
  std::string_view at(std::size_t offset, std::size_t length, const std::string& what) const;

  template <class Number>
  Number number(std::size_t offset, const std::string& what) const {
    static_assert(std::is_arithmetic_v<Number>);
    return number_at<Number>(at(offset, sizeof(Number), what).data(), order_);
  }

  /// A text field of fixed length without the blanks and zeros around it; Latin-1 becomes UTF-8.
  std::string text(std::size_t offset, std::size_t length, const std::string& what) const;

  /// Refuses the file if bytes follow `offset`, where `what` ends.
  void end_at(std::size_t offset, const std::string& what) const;

  /// Refuses the file for the content at `offset`.
  [[noreturn]] void refuse_at(std::size_t offset, const std::string& message, const std::string& remedy) const;

 private:
  std::string file_;
  std::string_view bytes_;
  ByteOrder order_;
};

/// The text as UTF-8: taken as it is if it is UTF-8, else read as Latin-1; control characters become blanks.
std::string utf8_from(std::string_view text);

}  // namespace ringfilm::instrument
