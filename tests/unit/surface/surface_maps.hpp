#pragma once
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// A map of f(x, y), both in metres from the first point.
inline HeightMap map_of(std::size_t points_x, std::size_t points_y, double step_x_m, double step_y_m,
                        const std::function<double(double, double)>& f) {
  HeightMap map{points_x, points_y, step_x_m, step_y_m, {}, {}};
  map.height_m.resize(map.points());
  for (std::size_t j = 0; j < points_y; ++j) {
    for (std::size_t i = 0; i < points_x; ++i) {
      map.height_m[map.index(i, j)] = f(static_cast<double>(i) * step_x_m, static_cast<double>(j) * step_y_m);
    }
  }
  return map;
}

/// Takes points out at random, with seed.
inline void lose_points(HeightMap& map, double share, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform;
  map.missing.assign(map.points(), std::uint8_t{0});
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (uniform(generator) >= share) continue;
    map.missing[i] = 1;
    map.height_m[i] = 0;
  }
}

}  // namespace ringfilm::surface
