#include "ringfilm/base/number_text.hpp"

#include <cstdio>

namespace ringfilm {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string in_mm(double length) { return number_text(length * 1e3) + " mm"; }

}  // namespace ringfilm
