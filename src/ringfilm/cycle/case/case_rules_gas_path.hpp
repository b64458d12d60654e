#pragma once
#include <vector>

#include "ringfilm/cycle/case/case_fields.hpp"

namespace ringfilm::cycle {

/// Rules of what the gas meets at a ring, where the gas path is computed.
void append_gas_path_breaches(const Case& c, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
