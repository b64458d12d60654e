#pragma once
#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// The map on other steps, between its points by cubics through four of them along rows and columns (Catmull and Rom);
/// next to missing points the nearest one. Steps are positive, and not larger than the map [m].
HeightMap resampled(const HeightMap& map, double step_x_m, double step_y_m);

}  // namespace ringfilm::surface
