#pragma once
#include <string>

namespace ringfilm::report {

/// JSON without "<", so that a script element may contain it whatever its texts are.
std::string script_text(const std::string& json);

}  // namespace ringfilm::report
