#include "text/terminal_text.hpp"

#include "ringfilm/base/printable_text.hpp"

namespace ringfilm::app {

void PrintableBuffer::put_unchanged(std::string_view text) {
  to_.sputn(text.data(), static_cast<std::streamsize>(text.size()));
}

PrintableBuffer::int_type PrintableBuffer::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char one = traits_type::to_char_type(character);
  return xsputn(&one, 1) == 1 ? character : traits_type::eof();
}

std::streamsize PrintableBuffer::xsputn(const char* text, std::streamsize n) {
  const std::string_view whole(text, static_cast<std::size_t>(n));
  if (find_control_character(whole) == std::string_view::npos) return to_.sputn(text, n);
  const std::string shown = printable(whole);
  const auto size = static_cast<std::streamsize>(shown.size());
  return to_.sputn(shown.data(), size) == size ? n : 0;
}

void command_terminal(std::ostream& stream, std::string_view command) {
  auto* const buffer = dynamic_cast<PrintableBuffer*>(stream.rdbuf());
  if (buffer != nullptr) {
    buffer->put_unchanged(command);
  } else {
    stream << command;
  }
}

}  // namespace ringfilm::app
