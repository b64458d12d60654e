#include "ringfilm/base/printable_text.hpp"

namespace ringfilm {
namespace {

struct Character {
  char32_t code;
  std::size_t size;  ///< [byte]
};

/// The UTF-8 character of two or three bytes that begins at `at`, else the byte alone.
Character character_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) -> char32_t {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  const auto follows = [&](std::size_t k) { return (byte(k) & 0xC0u) == 0x80u; };
  const char32_t first = byte(at);
  if ((first & 0xE0u) == 0xC0u && follows(at + 1)) return {((first & 0x1Fu) << 6) | (byte(at + 1) & 0x3Fu), 2};
  if ((first & 0xF0u) == 0xE0u && follows(at + 1) && follows(at + 2)) {
    return {((first & 0x0Fu) << 12) | ((byte(at + 1) & 0x3Fu) << 6) | (byte(at + 2) & 0x3Fu), 3};
  }
  return {first, 1};
}

bool is_control(const Character& character) {
  const char32_t code = character.code;
  const auto lies_in = [code](char32_t low, char32_t high) { return low <= code && code <= high; };
  if (character.size == 1) return (code < 0x20 && code != '\n' && code != '\t') || code == 0x7F;
  const bool is_c1 = lies_in(0x80, 0x9F);
  const bool is_direction = code == 0x061C || lies_in(0x200E, 0x200F) || lies_in(0x202A, 0x202E) ||
                            lies_in(0x2066, 0x2069);  // Bidi_Control of Unicode 15
  return is_c1 || is_direction || lies_in(0x2028, 0x2029);
}

std::string hexadecimal(char32_t code, int n_digits) {
  std::string digits;
  for (int k = n_digits - 1; k >= 0; --k) digits += "0123456789ABCDEF"[(code >> (4 * k)) & 15];
  return digits;
}

}  // namespace

std::size_t find_control_character(std::string_view text, std::size_t from) {
  for (std::size_t i = from; i < text.size(); ++i) {
    if (is_control(character_at(text, i))) return i;
  }
  return std::string_view::npos;
}

char32_t code_point_at(std::string_view text, std::size_t at) { return character_at(text, at).code; }

std::string printable(std::string_view text) {
  constexpr char32_t kLastOfTwoDigits = 0xFF;
  std::string shown;
  std::size_t begin = 0;
  for (std::size_t i = find_control_character(text); i != std::string_view::npos;
       i = find_control_character(text, begin)) {
    const auto [code, size] = character_at(text, i);
    shown.append(text.substr(begin, i - begin));
    shown += code <= kLastOfTwoDigits ? "\\x" + hexadecimal(code, 2) : "\\u" + hexadecimal(code, 4);
    begin = i + size;
  }
  return shown.append(text.substr(begin));
}

}  // namespace ringfilm
