#pragma once
#include "ringfilm/study/ensemble/assumptions.hpp"

namespace ringfilm::study {

/// What the twist of a ring whose section is stated rests on.
Assumption ring_twist(const cycle::Case& c);

}  // namespace ringfilm::study
