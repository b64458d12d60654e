#pragma once
#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::io::example {

/// A made-up document with every part that one can have: a map with missing points, a spike and framed regions, a
/// spectrum on logarithmic axes, a material ratio curve with marks, a long profile, parameters against the cut-off, a
/// friction loop, tables and a fragment. No analysis made its numbers.
Measurement measurement(std::size_t points_x = 60, std::size_t points_y = 40);

/// Where the map has its only spike.
inline constexpr double kSpikeHeight = 9.5e-6;  // [m]

}  // namespace ringfilm::io::example
