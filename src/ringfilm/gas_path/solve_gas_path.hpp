#pragma once
#include "ringfilm/gas_path/result.hpp"

/// The gas between the rings of a pack over the engine cycle (docs/theory/gas-path.md).
namespace ringfilm::gas_path {

/// The gas of a pack over a cycle that repeats itself. Cycles are integrated until the pressures repeat; between them
/// Newton's method on the map of a cycle finds where slow volumes end up. Where the rings' motion never repeats, the
/// last cycle is returned with `repeats` false. Throws ConvergenceError where the integration stops.
/// @param below where the pressures between the rings are stated, what flows along the paths between them
/// @param pack of checked values: positive temperatures, clearances and capacities, areas and volumes not negative
GasPathResult solve_gas_path(const Pack& pack, const GivenPressures& below = {});

}  // namespace ringfilm::gas_path
