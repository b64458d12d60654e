#pragma once
#include <string>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

namespace ringfilm::io {

/// How a study with `until` ended: how many points it took and how wide the interval then was for each base. Empty
/// without `until`.
/// @param values the cycle value that `until` names, in all scenarios
std::vector<std::string> until_notes(const study::Plan& plan, const std::vector<double>& values);

}  // namespace ringfilm::io
