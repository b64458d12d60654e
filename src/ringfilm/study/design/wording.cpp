#include "ringfilm/study/design/wording.hpp"

#include <cstdio>

namespace ringfilm::study {

std::string exact(double number) {
  char text[48];
  std::snprintf(text, sizeof text, "%a", number);
  return text;
}

}  // namespace ringfilm::study
