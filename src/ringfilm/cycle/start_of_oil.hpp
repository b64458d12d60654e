#pragma once
#include <vector>

#include "ringfilm/cycle/integration/liner_oil.hpp"

namespace ringfilm::cycle {

/// The oil on a liner with which its rings begin: a fresh liner or, where it pays, what lies there after many cycles on
/// coarse cells and steps, eq-oil-leap.
/// @param below distances of the chamber edges of the rings from that of the first one [m]
LinerFilm start_of_oil(const std::vector<Setup>& rings, const std::vector<double>& below);

}  // namespace ringfilm::cycle
