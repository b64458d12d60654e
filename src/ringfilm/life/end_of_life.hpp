#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/life/life_result.hpp"

namespace ringfilm::life {

/// Names of what an end-of-life rule may limit, with their units: life_quantities() and what a scenario of wear has.
const std::vector<cycle::Quantity>& limitable_quantities();

/// When each rule of a life is met, on its path and on all others.
std::vector<EndOfLife> ends_of_life(const Life& life, const LifeResult& result);

/// Notes the rules whose quantity no state has.
void append_notes_of_ends(const Life& life, LifeResult& result);

/// When values at increasing times first reach a limit, from whichever side they start; straight between the times.
/// Nothing: never, or not known.
std::optional<double> reaching_time(const std::vector<double>& times, const std::vector<double>& values, double limit);

}  // namespace ringfilm::life
