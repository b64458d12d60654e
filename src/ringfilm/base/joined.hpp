#pragma once
#include <string>
#include <vector>

namespace ringfilm {

/// Words one after the other with `separator` between them.
inline std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : separator) + words[i];
  return text;
}

}  // namespace ringfilm
