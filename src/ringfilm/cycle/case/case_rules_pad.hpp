#pragma once
#include <vector>

#include "ringfilm/cycle/case/case_fields.hpp"

namespace ringfilm::cycle {

/// The rules that join the keys of a pad.
std::vector<RuleBreach> broken_pad_rules(const Case& c);

}  // namespace ringfilm::cycle
