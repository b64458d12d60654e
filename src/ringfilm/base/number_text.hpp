#pragma once
#include <string>

namespace ringfilm {

/// A text with values in it. @param format as of printf
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// A number as messages show it.
/// @param digits at the most
std::string number_text(double value, int digits = 6);

}  // namespace ringfilm
