#include "text/wrapped_text.hpp"

#include <sstream>

namespace ringfilm::app {

std::string wrapped(const std::vector<std::string>& pieces) {
  constexpr std::size_t kLineLength = 100;
  constexpr const char* kIndent = "    ";
  std::string lines, line;
  for (const std::string& piece : pieces) {
    if (!line.empty() && line.size() + 1 + piece.size() > kLineLength) {
      lines += line + "\n";
      line = kIndent + piece;
    } else {
      line += (line.empty() ? "" : " ") + piece;
    }
  }
  return lines + line + "\n";
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace ringfilm::app
