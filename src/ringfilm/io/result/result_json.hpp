#pragma once
#include <string>

#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// The values of the cycle as one flat JSON object, SI with angles in degrees: title, every entry of
/// cycle::cycle_quantities(), of an unrolled film of cycle::unrolled_cycle_quantities(), and every derived constant by
/// its name, then `units`, `notes`, `assumed`, `effort`, `program`, `commit`, `kernels` and `complete`; with an error
/// estimate also `errors`, by the same names and in the same units, and `error_estimate` with the grids that were
/// integrated and `order_in_cells` and `order_in_step` as seen. JSON has no NaN: such a value is null.
std::string result_json(const ResultDocument& document);

}  // namespace ringfilm::io
