#include "ringfilm/surface/asperity/scale.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/surface/asperity/summits.hpp"
#include "ringfilm/surface/topography/filter.hpp"

namespace ringfilm::surface {
namespace {

ScaleRow row_of(const HeightMap& map, double cutoff_m, MomentDirection direction, DifferenceScheme scheme) {
  ScaleRow row;
  row.short_cutoff_m = cutoff_m;
  const MomentTable table = moment_table(map, scheme);
  row.moments = moments(table, direction);
  row.Sq_m = std::sqrt(table.m0_m2);
  row.Sdq = rms_slope(table);
  const AsperityParameters parameters = asperity_parameters(row.moments, row.Sq_m);
  row.density_per_m2 = parameters.density_per_m2;
  row.beta_m = parameters.beta_m;
  if (map.points_x < 3 || map.points_y < 3) return row;
  row.summit_density_per_m2 = count_summits(map).density_per_m2;
  return row;
}

}  // namespace

std::vector<double> short_cutoffs(const HeightMap& map) {
  check_map(map);
  const double length_x = map.step_x_m * static_cast<double>(map.points_x);
  const double step = map.is_profile() ? map.step_x_m : std::max(map.step_x_m, map.step_y_m);
  const double side =
      map.is_profile() ? length_x : std::min(length_x, map.step_y_m * static_cast<double>(map.points_y));
  std::vector<double> cutoffs;
  for (double cutoff = 2.5 * step; cutoff <= 0.1 * side * (1 + 1e-12); cutoff *= 2) cutoffs.push_back(cutoff);
  return cutoffs;
}

std::vector<ScaleRow> scale_table(const HeightMap& map, const std::vector<double>& cutoffs_m, MomentDirection direction,
                                  DifferenceScheme scheme) {
  std::vector<ScaleRow> rows{row_of(map, 0, direction, scheme)};
  for (const double cutoff_m : cutoffs_m) {
    HeightMap smooth = map;
    apply_filter(smooth, {FilterKind::gaussian, FilterSide::short_cutoff, cutoff_m});
    rows.push_back(row_of(smooth, cutoff_m, direction, scheme));
  }
  return rows;
}

}  // namespace ringfilm::surface
