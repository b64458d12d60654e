#pragma once
#include "figures.hpp"
#include "measurements.hpp"

namespace ringfilm::benchmarks {

/// Prints what was measured as tables of Markdown; what was not is a dash.
void print_tables(const Figures& figures, const Extent& extent);

}  // namespace ringfilm::benchmarks
