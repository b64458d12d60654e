#pragma once
#include <string>

namespace ringfilm::report {

/// JSON that may stand inside a script element whatever its texts say: no "<" is left in it.
std::string script_text(const std::string& json);

}  // namespace ringfilm::report
