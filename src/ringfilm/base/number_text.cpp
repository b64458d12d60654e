#include "ringfilm/base/number_text.hpp"

#include <cstdio>

namespace ringfilm {

std::string number_text(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string in_mm(double length) { return number_text(length * 1e3) + " mm"; }

}  // namespace ringfilm
