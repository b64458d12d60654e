#pragma once
#include <vector>

#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// Rules for the values of `[contact.plateau]`: one complete curve, of a plateau over deeper valleys.
/// @returns whether the curve is one, so that what follows from it can be judged; true without one
bool append_plateau_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
