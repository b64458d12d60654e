#pragma once
#include <vector>

#include "ringfilm/models/conformity/lift_off.hpp"

namespace ringfilm::models {

/// Where a ring on evenly spaced points touches: the quadratic programme in the clearances, by an active set. A start
/// for what is solved exactly.
/// @returns for each of n_steps + 1 points from ring.start() to ring.end() whether it touches
std::vector<bool> contact_on_grid(const RingAtWall& ring, int n_steps);

}  // namespace ringfilm::models
