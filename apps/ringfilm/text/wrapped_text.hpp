#pragma once
#include <string>
#include <vector>

namespace ringfilm::app {

/// Pieces set one after the other in lines of at most 100 characters, all but the first line indented; ends a line.
std::string wrapped(const std::vector<std::string>& pieces);

/// The words of a text.
std::vector<std::string> words(const std::string& text);

}  // namespace ringfilm::app
