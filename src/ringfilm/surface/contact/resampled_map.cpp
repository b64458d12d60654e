#include "ringfilm/surface/contact/resampled_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ringfilm::surface {
namespace {

/// Four points around a place and their weights; at the edges the outer ones are the edge itself.
struct Stencil {
  std::array<std::size_t, 4> point;
  std::array<double, 4> weight;
  std::size_t nearest;
};

Stencil stencil(double place, std::size_t points) {
  const double inside = std::clamp(place, 0.0, static_cast<double>(points - 1));
  const auto low = std::min(static_cast<std::size_t>(inside), points > 1 ? points - 2 : 0);
  const double t = inside - static_cast<double>(low);
  Stencil of;
  const std::size_t last = points - 1;
  of.point = {low == 0 ? 0 : low - 1, low, std::min(low + 1, last), std::min(low + 2, last)};
  of.weight = {t * (-0.5 + t * (1 - 0.5 * t)), 1 + t * t * (-2.5 + 1.5 * t), t * (0.5 + t * (2 - 1.5 * t)),
               t * t * (-0.5 + 0.5 * t)};
  of.nearest = t < 0.5 ? of.point[1] : of.point[2];
  return of;
}

std::vector<Stencil> stencils(std::size_t points, double step, double new_step) {
  constexpr double kRounding = 1e-9;
  const double length = static_cast<double>(points - 1) * step;
  const auto count = static_cast<std::size_t>(std::floor(length / new_step + kRounding)) + 1;
  std::vector<Stencil> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(stencil(static_cast<double>(i) * new_step / step, points));
  return all;
}

}  // namespace

HeightMap resampled(const HeightMap& map, double step_x_m, double step_y_m) {
  const auto across = stencils(map.points_x, map.step_x_m, step_x_m);
  const bool is_profile = map.is_profile();
  const auto down = is_profile ? std::vector{stencil(0, 1)} : stencils(map.points_y, map.step_y_m, step_y_m);
  HeightMap to{across.size(), down.size(), step_x_m, is_profile ? map.step_y_m : step_y_m, {}, {}};
  to.height_m.reserve(to.points());
  for (const Stencil& row : down) {
    for (const Stencil& column : across) {
      double sum = 0;
      bool is_whole = true;
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
          const std::size_t point = map.index(column.point[i], row.point[j]);
          is_whole = is_whole && map.measured(point);
          sum += row.weight[j] * column.weight[i] * map.height_m[point];
        }
      }
      const std::size_t nearest = map.index(column.nearest, row.nearest);
      to.height_m.push_back(is_whole ? sum : map.height_m[nearest]);
      if (!map.missing.empty()) to.missing.push_back(map.measured(nearest) ? 0 : 1);
    }
  }
  return to;
}

}  // namespace ringfilm::surface
