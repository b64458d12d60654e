#pragma once
#include <optional>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

namespace ringfilm::study {

/// Mean of a value over the operating points of a base, with their weights, eq-weighted-mean. Nothing for a plan of
/// another method, and where a point was not solved.
/// @param values of all scenarios
std::optional<double> weighted_mean(const Plan& plan, const std::vector<double>& values, std::size_t base);

}  // namespace ringfilm::study
