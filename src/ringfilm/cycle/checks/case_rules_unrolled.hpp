#pragma once
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// Rules of a film on the unrolled ring: its gap, its cells around the ring, its method, the memory of its fields.
void append_unrolled_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
