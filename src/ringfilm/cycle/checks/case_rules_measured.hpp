#pragma once
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace ringfilm::cycle {

/// Rules for the values of `[contact.measured]`: whole regions, cut-offs in order, correlations of known scatter
/// that some data can have, a calibration with a name.
void append_measured_breaches(const MeasuredContact& measured, std::vector<RuleBreach>& breaches);

}  // namespace ringfilm::cycle
