#pragma once
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// The rules that join the keys of a pad.
std::vector<RuleBreach> broken_pad_rules(const Case& c);

/// What gas at an edge requires of the film, of a pad and of a ring.
void append_gas_edge_breaches(const Case& c, std::vector<RuleBreach>& breaches);

/// What an oil that thins with the shear rate and rough walls require, of a pad and of a ring.
void append_flow_factor_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
