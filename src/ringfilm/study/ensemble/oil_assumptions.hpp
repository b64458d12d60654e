#pragma once
#include <vector>

#include "ringfilm/study/ensemble/assumptions.hpp"

namespace ringfilm::study {

/// What the oil consumption rests on, of the ring next to the chamber.
std::vector<Assumption> oil_consumption_assumptions(const cycle::Case& c);

}  // namespace ringfilm::study
