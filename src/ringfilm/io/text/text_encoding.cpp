#include "ringfilm/io/text/text_encoding.hpp"

#include <iconv.h>

#include <algorithm>

namespace ringfilm::io {
namespace {

bool is_control(char c) {
  return (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == '\x7f';
}

/// The descriptor of a conversion of the C library.
class Conversion {
 public:
  explicit Conversion(const char* from) : handle_(iconv_open("UTF-8", from)) {}
  ~Conversion() {
    if (is_open()) iconv_close(handle_);
  }
  Conversion(const Conversion&) = delete;
  Conversion& operator=(const Conversion&) = delete;

  /// The bytes as UTF-8; nothing where the library lacks the encoding, or the bytes are not in it.
  std::optional<std::string> operator()(std::string_view bytes) {
    if (!is_open()) return std::nullopt;
    std::string input(bytes), text(3 * bytes.size() + 4, '\0');  // a unit of two bytes becomes three at the most
    char *in = input.data(), *out = text.data();
    std::size_t n_in = input.size(), n_out = text.size();
    if (iconv(handle_, &in, &n_in, &out, &n_out) == static_cast<std::size_t>(-1)) return std::nullopt;
    text.resize(text.size() - n_out);
    return text;
  }

 private:
  bool is_open() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  iconv_t handle_;
};

/// Text of UTF-16 without its mark: every second byte is zero, and the others are letters. Nothing for other bytes.
const char* unmarked_utf16(std::string_view bytes) {
  constexpr std::size_t kSeen = 4096, kMinUnits = 8;
  constexpr double kZeros = 0.9;  // other high bytes are those of Greek letters and the like
  const std::size_t n_units = std::min(bytes.size(), kSeen) / 2;
  if (n_units < kMinUnits) return nullptr;
  for (const std::size_t high : {std::size_t{1}, std::size_t{0}}) {
    std::size_t n_zeros = 0, n_controls = 0;
    for (std::size_t i = 0; i < n_units; ++i) {
      n_zeros += bytes[2 * i + high] == '\0' ? 1 : 0;
      n_controls += is_control(bytes[2 * i + 1 - high]) ? 1 : 0;
    }
    if (n_controls == 0 && static_cast<double>(n_zeros) >= kZeros * static_cast<double>(n_units)) {
      return high == 1 ? "UTF-16LE" : "UTF-16BE";
    }
  }
  return nullptr;
}

}  // namespace

std::size_t utf8_length(std::string_view s, std::size_t i) {
  const auto byte = [s](std::size_t k) { return k < s.size() ? static_cast<unsigned char>(s[k]) : 0u; };
  const auto follows = [&byte](std::size_t k) { return (byte(k) & 0xC0u) == 0x80u; };
  const unsigned first = byte(i);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(i + 1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool overlong = first == 0xE0 && byte(i + 1) < 0xA0, surrogate = first == 0xED && byte(i + 1) > 0x9F;
    return follows(i + 1) && follows(i + 2) && !overlong && !surrogate ? 3 : 0;
  }
  if (first < 0xF0 || first > 0xF4) return 0;
  const bool overlong = first == 0xF0 && byte(i + 1) < 0x90, too_large = first == 0xF4 && byte(i + 1) > 0x8F;
  return follows(i + 1) && follows(i + 2) && follows(i + 3) && !overlong && !too_large ? 4 : 0;
}

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

std::optional<DecodedText> decoded(std::string_view bytes) {
  const std::string_view mark = bytes.substr(0, 2);
  const bool is_marked = mark == "\xFF\xFE" || mark == "\xFE\xFF";
  const char* const utf16 = is_marked ? (mark == "\xFF\xFE" ? "UTF-16LE" : "UTF-16BE") : unmarked_utf16(bytes);
  if (utf16 != nullptr) {
    if (is_marked) bytes.remove_prefix(2);
    // A half unit behind the last one is what a file has that was cut.
    std::optional<std::string> text = Conversion(utf16)(bytes.substr(0, bytes.size() / 2 * 2));
    if (!text) return std::nullopt;
    return DecodedText{std::move(*text), "UTF-16"};
  }
  if (std::any_of(bytes.begin(), bytes.end(), is_control) || is_utf8(bytes)) return std::nullopt;
  std::optional<std::string> text = Conversion("WINDOWS-1252")(bytes);
  if (!text) return std::nullopt;
  return DecodedText{std::move(*text), "Windows-1252"};
}

}  // namespace ringfilm::io
