#include "ringfilm/base/printable_text.hpp"

namespace ringfilm {
namespace {

unsigned code_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

/// First byte of the two that UTF-8 has for U+0080 to U+009F.
constexpr unsigned kFirstOfC1 = 0xC2;

bool is_c1(std::string_view text, std::size_t i) {
  return code_at(text, i) == kFirstOfC1 && i + 1 < text.size() && code_at(text, i + 1) >= 0x80 &&
         code_at(text, i + 1) <= 0x9F;
}

}  // namespace

std::size_t find_control_character(std::string_view text, std::size_t from) {
  for (std::size_t i = from; i < text.size(); ++i) {
    const unsigned code = code_at(text, i);
    if ((code < 0x20 && code != '\n' && code != '\t') || code == 0x7F || is_c1(text, i)) return i;
  }
  return std::string_view::npos;
}

std::string printable(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string shown;
  std::size_t begin = 0;
  for (std::size_t i = find_control_character(text); i != std::string_view::npos;
       i = find_control_character(text, begin)) {
    const std::size_t last = is_c1(text, i) ? i + 1 : i;
    const unsigned code = code_at(text, last);
    shown.append(text.substr(begin, i - begin)).append("\\x") += kDigits[code >> 4];
    shown += kDigits[code & 15];
    begin = last + 1;
  }
  return shown.append(text.substr(begin));
}

}  // namespace ringfilm
