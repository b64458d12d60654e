#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Letters of text tables, whatever program wrote them.
namespace ringfilm::io {

/// Bytes of a text that are not UTF-8, as UTF-8.
struct DecodedText {
  std::string text;      ///< UTF-8 without byte-order mark
  std::string encoding;  ///< what the bytes are, for the record: "UTF-16" or "Windows-1252"
};

/// Length of the well-formed UTF-8 sequence at `i` (Unicode 15, table 3-7); 0 if there is none.
std::size_t utf8_length(std::string_view text, std::size_t i);

/// Is the text well-formed UTF-8?
bool is_utf8(std::string_view text);

/// The text of bytes that are UTF-16, its byte-order mark there or not, or Windows-1252, of which Latin-1 is a part;
/// nothing where they are UTF-8 already, hold control characters or cannot be converted.
std::optional<DecodedText> decoded(std::string_view bytes);

}  // namespace ringfilm::io
