#include "ringfilm/base/error.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/base/printable_text.hpp"

namespace ringfilm {
namespace {

/// Nobody mends more at once, and a file that has more is of another kind.
constexpr std::size_t kMaxDescribed = 100;
/// A line of over this many characters is shown as a window around the mark.
constexpr int kShownColumns = 100;

/// The text with each byte of a control character as a blank, so that the caret stays under its place.
std::string without_control_characters(std::string text) {
  for (std::size_t i = find_control_character(text); i != std::string::npos; i = find_control_character(text, i)) {
    do {
      text[i++] = ' ';
    } while (i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80u);
  }
  return text;
}

std::string with_caret(const SourceMark& mark, const std::string& remedy) {
  const std::string number = std::to_string(mark.line);
  const int first = std::max(0, mark.column - 1 - kShownColumns / 2);
  std::string shown = mark.line_text.substr(std::min<std::size_t>(first, mark.line_text.size()), kShownColumns);
  std::replace(shown.begin(), shown.end(), '\t', ' ');
  shown = without_control_characters(std::move(shown));
  const int caret = std::max(0, mark.column - 1 - first);
  const std::string margin = "    " + std::string(number.size(), ' ') + " | ";
  std::string text = "    " + number + " | " + shown + "\n" + margin + std::string(caret, ' ') + "^";
  if (!remedy.empty()) text.append(" ").append(printable(remedy));
  return text.append("\n");
}

}  // namespace

std::string describe(const std::vector<Fault>& faults) {
  std::string text;
  for (std::size_t i = 0; i < std::min(faults.size(), kMaxDescribed); ++i) {
    const auto& [mark, message, remedy] = faults[i];
    if (!mark.file.empty()) {
      text.append(printable(mark.file)).append(":");
      if (mark.line > 0) text += std::to_string(mark.line) + ":";
      if (mark.line > 0 && mark.column > 0) text += std::to_string(mark.column) + ":";
      text += " ";
    }
    text.append(printable(message)).append("\n");
    if (mark.line > 0 && !mark.line_text.empty()) {
      text += with_caret(mark, remedy);
    } else if (!remedy.empty()) {
      text.append("    ").append(printable(remedy)).append("\n");
    }
  }
  if (faults.size() > kMaxDescribed) {
    text.append("and ").append(std::to_string(faults.size() - kMaxDescribed)).append(" more\n");
  }
  return text;
}

InputError::InputError(std::vector<Fault> faults) : std::runtime_error(describe(faults)), faults_(std::move(faults)) {}

InputError::InputError(const std::string& message, const std::string& remedy)
    : InputError(std::vector<Fault>{{{}, message, remedy}}) {}

}  // namespace ringfilm
