#pragma once
#include <string>

namespace ringfilm {

/// A number as messages show it: of six digits at the most.
std::string number_text(double value);

}  // namespace ringfilm
