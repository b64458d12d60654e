#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/result.hpp"

namespace ringfilm::io {

/// The curves as CSV text: a row per crank angle, a column per entry of cycle::curve_quantities(), header
/// `name [unit]` or `name` alone if dimensionless. SI, angles in degrees, each number in the fewest digits that give
/// it back exactly; `nan` where a quantity does not exist at that angle.
std::string result_csv(const std::vector<cycle::Sample>& samples);

}  // namespace ringfilm::io
