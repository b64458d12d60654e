#pragma once
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// Rules of what the gas meets at a ring, where the gas path is computed.
void append_gas_path_breaches(const Case& c, std::vector<RuleBreach>& breaches);

/// Rules of the composition of the gas, and of the properties that follow from it.
void append_composition_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
