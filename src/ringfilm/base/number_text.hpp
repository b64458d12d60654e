#pragma once
#include <string>

namespace ringfilm {

/// A number as messages show it.
/// @param digits at the most
std::string number_text(double value, int digits = 6);

/// A length [m] with its unit: "1.2 mm".
std::string in_mm(double length);

}  // namespace ringfilm
