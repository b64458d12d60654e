#pragma once
#include <nlohmann/json.hpp>

#include "ringfilm/io/result/pack_gas.hpp"

namespace ringfilm::io {

/// What the gas between the rings does over a cycle, without its curves: values in SI with their units, regions, ring
/// events, ring motion and paths. The same in `gas --json`, in `run --json` of a pack, in Python and on the page.
nlohmann::ordered_json gas_object(const PackGas& gas);

}  // namespace ringfilm::io
