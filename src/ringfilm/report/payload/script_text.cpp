#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {

std::string script_text(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace ringfilm::report
