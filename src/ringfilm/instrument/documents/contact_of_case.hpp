#pragma once
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::instrument {

/// The contact law of a case at these lambda ratios: pressure, real area, mean pressure on it, with what its asperities
/// state of its validity, and other laws of the same surfaces next to it. A pack has the law of its first ring.
/// @param lambda in the order of the table; separations are lambda times the composite roughness
io::Measurement contact_of_case(const cycle::Case& c, const std::vector<double>& lambda);

}  // namespace ringfilm::instrument
