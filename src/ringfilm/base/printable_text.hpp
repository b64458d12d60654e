#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace ringfilm {

/// Place of the first character at or after `from` that a terminal obeys instead of showing it: C0 (U+0000 to U+001F),
/// DEL, C1 (U+0080 to U+009F), the characters that change the direction of writing (Bidi_Control of Unicode: U+061C,
/// U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069) and the separators of lines and paragraphs (U+2028, U+2029), in
/// UTF-8; line ends and tabs are not counted. npos where there is none.
std::size_t find_control_character(std::string_view text, std::size_t from = 0);

/// Code of the UTF-8 character that begins at `at`; that of the byte alone where no whole character begins there.
char32_t code_point_at(std::string_view text, std::size_t at);

/// The text with each such character by its code: "\x1B" below U+0100, else "\u202E". A terminal obeys control
/// characters, and a NUL ends a C string.
std::string printable(std::string_view text);

}  // namespace ringfilm
