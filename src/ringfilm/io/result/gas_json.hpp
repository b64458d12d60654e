#pragma once
#include <nlohmann/json.hpp>

#include "ringfilm/io/result/pack_gas.hpp"

namespace ringfilm::io {

/// What the gas between the rings does over a cycle, without its curves: values in SI with their units, regions, ring
/// events, ring motion and paths. The same in `gas --json`, in `run --json` of a pack, in Python and on the page.
nlohmann::ordered_json gas_object(const PackGas& gas);

/// Puts the values of gas_sum_quantities() into an object.
void put_gas_sums(const gas_path::GasSums& sums, nlohmann::ordered_json& object);

}  // namespace ringfilm::io
