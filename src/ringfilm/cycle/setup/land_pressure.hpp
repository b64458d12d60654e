#pragma once
#include "ringfilm/case/case.hpp"
#include "ringfilm/models/gas/gas.hpp"

namespace ringfilm::cycle {

/// A gas pressure next to a ring that is stated or computed: absolute, 0 = firing TDC. Throws InputError where its
/// trace cannot be used.
models::CyclePressure land_pressure(const Case& c, const LandPressure& land);

}  // namespace ringfilm::cycle
