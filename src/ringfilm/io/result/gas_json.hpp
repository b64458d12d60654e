#pragma once
#include <nlohmann/json.hpp>

#include "ringfilm/io/result/pack_gas.hpp"

namespace ringfilm::io {

/// What the gas between the rings does over a cycle, without its curves: values in SI with their units, regions, ring
/// events, ring motion and paths. `gas --json`, `run --json` of a pack, Python and the page share this object.
nlohmann::ordered_json gas_object(const PackGas& gas);

}  // namespace ringfilm::io
