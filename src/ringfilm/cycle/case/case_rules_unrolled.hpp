#pragma once
#include <vector>

#include "ringfilm/cycle/case/case_fields.hpp"

namespace ringfilm::cycle {

/// Rules of a film on the unrolled ring: its gap, its cells around the ring, its method, the memory of its fields.
void append_unrolled_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
