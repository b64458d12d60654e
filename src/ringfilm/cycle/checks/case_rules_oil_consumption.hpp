#pragma once
#include <vector>

#include "ringfilm/case/case.hpp"

namespace ringfilm::cycle {

struct RuleBreach;

/// The rules of what oil consumption is computed from: fractions of the oil, the number of cylinders.
void append_oil_consumption_breaches(const Case& c, std::vector<RuleBreach>& breaches);

/// The number of cylinders is a whole one.
void append_cylinder_breaches(const Engine& engine, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
