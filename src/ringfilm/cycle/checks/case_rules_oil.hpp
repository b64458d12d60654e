#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// Distances of values along the stroke are not negative and increase.
void append_stroke_breaches(const std::string& key, const std::vector<StrokeValue>& points,
                            std::vector<RuleBreach>& breaches);

/// What the temperatures of the walls require, of a pad and of a ring.
void append_thermal_breaches(const Case& c, std::vector<RuleBreach>& breaches);

/// What the laws of viscosity and density against temperature require.
void append_oil_law_breaches(const Lubricant& oil, std::vector<RuleBreach>& breaches);

/// What HTHS and the temperatures of its film require of the viscosity of an oil. Of laws that break no rule.
void append_viscosity_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
