#pragma once
#include <string>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

namespace ringfilm::io {

/// How a study with `until` ended: how many points it took and how wide the interval then was for each base. Empty
/// without `until`.
/// @param values of all scenarios, of the value of the cycle that `until` names
std::vector<std::string> until_notes(const study::Plan& plan, const std::vector<double>& values);

}  // namespace ringfilm::io
