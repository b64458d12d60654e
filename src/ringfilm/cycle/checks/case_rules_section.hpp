#pragma once
#include <vector>

#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// Rules of the section of a ring and its twist. False where the section has no area, so that other rules would not
/// find their values.
bool append_section_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
