#pragma once
#include <vector>

#include "ringfilm/gas_path/network.hpp"
#include "ringfilm/gas_path/result.hpp"
#include "ringfilm/gas_path/scalar_transport.hpp"

namespace ringfilm::gas_path {

/// Adds to a result what Pack::composition gives: the scalars that the steps of its last cycle carry, in their periodic
/// state, and the dew points of the regions. Nothing without it, or where the pressure of a piston land is stated.
void add_composition(const Network& network, const std::vector<FlowStep>& steps, GasPathResult& result);

}  // namespace ringfilm::gas_path
