#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace ringfilm {

/// Place of the first control character at or after `from`: C0 (U+0000 to U+001F), DEL, and C1 (U+0080 to U+009F) in
/// UTF-8; line ends and tabs are not counted. npos where there is none.
std::size_t find_control_character(std::string_view text, std::size_t from = 0);

/// The text with each such character as "\x1B", its code in two hexadecimal digits: a terminal obeys control
/// characters, and a NUL ends a C string.
std::string printable(std::string_view text);

}  // namespace ringfilm
