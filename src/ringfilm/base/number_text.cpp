#include "ringfilm/base/number_text.hpp"

#include <cstdarg>
#include <cstdio>

namespace ringfilm {

std::string formatted(const char* format, ...) {
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  std::string text(std::vsnprintf(nullptr, 0, format, values), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  va_end(values);
  return text;
}

std::string number_text(double value, int digits) { return formatted("%.*g", digits, value); }

}  // namespace ringfilm
