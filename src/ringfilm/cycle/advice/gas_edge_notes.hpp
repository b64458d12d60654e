#pragma once
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::cycle {

/// Where gas breaks through the film, and where it holds the ring off the liner. @param base samples at the crank steps
void append_gas_edge_notes(const std::vector<Sample>& base, const CycleValues& values, std::vector<Note>& notes);

}  // namespace ringfilm::cycle
