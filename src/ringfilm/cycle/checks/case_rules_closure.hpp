#pragma once
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// Rules of the static closure of a ring in its bore: a section that can bend, a gap that leaves a ring, a bore that is
/// left by its distortion, heights that are covered.
void append_closure_breaches(const Case& c, std::vector<RuleBreach>& breaches);

/// Rules of ring.free_shape, which must be stated. @returns whether its points were read and are a ring that closes
bool shows_free_ring(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
