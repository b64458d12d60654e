#pragma once
#include <string>

namespace ringfilm {

/// A number as messages show it: of six digits at the most.
std::string number_text(double value);

/// A length [m] with its unit: "1.2 mm".
std::string in_mm(double length);

}  // namespace ringfilm
