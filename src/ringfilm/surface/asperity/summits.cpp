#include "ringfilm/surface/asperity/summits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::surface {
namespace {

bool block_measured(const HeightMap& map, std::size_t i, std::size_t j) {
  if (map.missing.empty()) return true;
  for (std::size_t row = j - 1; row <= j + 1; ++row) {
    for (std::size_t column = i - 1; column <= i + 1; ++column) {
      if (!map.measured(map.index(column, row))) return false;
    }
  }
  return true;
}

bool is_summit(const double* z, std::ptrdiff_t row) {
  const double top = z[0];
  return top > z[-1] && top > z[1] && top > z[-row] && top > z[row] && top > z[-row - 1] && top > z[-row + 1] &&
         top > z[row - 1] && top > z[row + 1];
}

}  // namespace

Summits count_summits(const HeightMap& map) {
  const HeightStatistics heights = height_statistics(map);
  if (map.points_x < 3 || map.points_y < 3) {
    throw InputError("summits are counted on maps of 3 x 3 points or more", "a profile shows peaks, no summits");
  }
  Summits of;
  std::size_t candidates = 0;
  double curvature = 0, sum = 0, squares = 0;
  const auto row = static_cast<std::ptrdiff_t>(map.points_x);
  const double per_x = 1 / (map.step_x_m * map.step_x_m), per_y = 1 / (map.step_y_m * map.step_y_m);
  for (std::size_t j = 1; j + 1 < map.points_y; ++j) {
    for (std::size_t i = 1; i + 1 < map.points_x; ++i) {
      if (!block_measured(map, i, j)) continue;
      ++candidates;
      const double* const z = map.height_m.data() + map.index(i, j);
      if (!is_summit(z, row)) continue;
      ++of.count;
      curvature += 0.5 * ((2 * z[0] - z[-1] - z[1]) * per_x + (2 * z[0] - z[-row] - z[row]) * per_y);
      const double height = (z[0] - heights.mean_m) / heights.Sq_m;
      sum += height;
      squares += height * height;
    }
  }
  if (of.count == 0) return of;
  const double count = static_cast<double>(of.count), mean = sum / count;
  of.density_per_m2 = count / (static_cast<double>(candidates) * map.step_x_m * map.step_y_m);
  of.mean_curvature_per_m = curvature / count;
  of.mean_radius_m = 1 / of.mean_curvature_per_m;
  of.mean_height_m = mean * heights.Sq_m;
  of.rms_height_m = std::sqrt(std::max(0.0, squares / count - mean * mean)) * heights.Sq_m;
  return of;
}

Summits count_summits_of_pair(const HeightMap& first, const HeightMap& second) {
  check_map(first);
  check_map(second);
  const auto differ = [](double a, double b) { return std::abs(a - b) > 1e-6 * a; };
  if (differ(first.step_x_m, second.step_x_m) || differ(first.step_y_m, second.step_y_m)) {
    throw InputError("the steps of the two maps differ, " + length_text(first.step_x_m) + " and " +
                         length_text(second.step_x_m) + " along x: their heights cannot be added",
                     "measure both with the same steps");
  }
  HeightMap sum;
  sum.points_x = std::min(first.points_x, second.points_x);
  sum.points_y = std::min(first.points_y, second.points_y);
  sum.step_x_m = first.step_x_m;
  sum.step_y_m = first.step_y_m;
  sum.height_m.resize(sum.points());
  sum.missing.assign(sum.points(), 0);
  for (std::size_t j = 0; j < sum.points_y; ++j) {
    for (std::size_t i = 0; i < sum.points_x; ++i) {
      const std::size_t a = first.index(i, j), b = second.index(i, j), at = sum.index(i, j);
      sum.missing[at] = first.measured(a) && second.measured(b) ? 0 : 1;
      sum.height_m[at] = sum.missing[at] ? 0.0 : first.height_m[a] + second.height_m[b];
    }
  }
  return count_summits(sum);
}

SummitTheory summit_theory(double m0_m2, double m2, double m4_per_m2) {
  const double bandwidth = m0_m2 * m4_per_m2 / (m2 * m2);
  if (!(std::isfinite(bandwidth) && bandwidth > 0)) {
    throw InputError("the spectral moments are not all positive: no summits are expected");
  }
  SummitTheory of;
  of.bandwidth = bandwidth;
  of.density_per_m2 = m4_per_m2 / (m2 * 6 * std::numbers::pi * std::sqrt(3.0));
  of.mean_curvature_per_m = 8 / (3 * std::sqrt(std::numbers::pi)) * std::sqrt(m4_per_m2);
  of.mean_height_m = 4 * std::sqrt(m0_m2 / (std::numbers::pi * bandwidth));
  // The constant of Nayak's distribution: 1 - 0.8968/bandwidth after Bush, Gibson and Thomas.
  of.rms_height_m = std::sqrt(m0_m2 * std::max(0.0, 1 - 0.8968 / bandwidth));
  return of;
}

}  // namespace ringfilm::surface
