#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// A rectangle of a map, in points.
struct Region {
  std::size_t column = 0, row = 0;  ///< column and row of its first point
  std::size_t columns = 0, rows = 0;
  double prominence_m = 0.0;  ///< where it was proposed for its heights: eq-surface-prominence, else 0 [m]
};

/// A rectangle given in metres from the first point, on the points inside it.
/// @throws InputError where it reaches beyond the map or holds no points
Region region_in_metres(const HeightMap& map, double x_m, double y_m, double width_m, double height_m);

/// across * down regions of equal size that fill the map but for a rest of fewer points than regions.
/// @throws InputError where a region would have fewer than 8 points in a direction
std::vector<Region> grid_regions(const HeightMap& map, std::size_t across, std::size_t down);

/// The regions of one size that stand out most, the first most of all, without overlap: the mean over the region of
/// what rises above the 10 % level of the whole map. Places are tried at quarters of the size. Fewer are given where no
/// more have room or at least half of their points measured.
std::vector<Region> prominent_regions(const HeightMap& map, std::size_t count, std::size_t columns, std::size_t rows);

/// The part of a map in a region.
HeightMap part_of_map(const HeightMap& map, const Region& region);

}  // namespace ringfilm::surface
