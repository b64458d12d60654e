#include "ringfilm/surface/asperity/spectral_moments.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/roughness.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMinStencils = 16;

/// A sum over complete stencils.
struct Mean {
  double sum = 0;
  std::size_t count = 0;
  void add(const Mean& row) {
    sum += row.sum;
    count += row.count;
  }
  double value() const { return sum / static_cast<double>(count); }
};

/// Rows of a map around one of them.
struct Rows {
  const HeightMap& map;
  std::size_t row;

  const double* heights(int away) const {
    return map.height_m.data() + map.index(0, row) + away * static_cast<std::ptrdiff_t>(map.points_x);
  }
  /// Are the points on a line through (column, row), from one number of steps to another, all measured?
  bool complete(std::size_t column, int step_x, int step_y, int from, int to) const {
    if (map.missing.empty()) return true;
    for (int k = from; k <= to; ++k) {
      const std::ptrdiff_t away = k * (step_x + step_y * static_cast<std::ptrdiff_t>(map.points_x));
      if (map.missing[map.index(column, row) + away] != 0) return false;
    }
    return true;
  }
  bool complete_block(std::size_t column) const {
    return complete(column, 1, 0, -1, 1) && complete(column - 1, 0, 1, -1, 1) && complete(column, 0, 1, -1, 1) &&
           complete(column + 1, 0, 1, -1, 1);
  }
};

/// Mean square of value(z, column) over the columns first to last - 1 whose stencil is complete.
template <class Value>
Mean squares(const Rows& rows, std::size_t first, std::size_t last, int step_x, int step_y, int from, int to,
             const Value& value) {
  Mean of;
  const bool whole = rows.map.missing.empty();
  for (std::size_t i = first; i < last; ++i) {
    if (!whole && !rows.complete(i, step_x, step_y, from, to)) continue;
    const double v = value(i);
    of.sum += v * v;
    ++of.count;
  }
  return of;
}

struct Sums {
  Mean slope_x, slope_y, curve_x, curve_y;
  Mean slopes_xy, curve_xxyy, curve_xyxy, curve_xxxy, curve_xyyy;
};

/// Differences without their division by the steps.
void add_neighbours(const Rows& rows, Sums& sums) {
  const std::size_t nx = rows.map.points_x, ny = rows.map.points_y;
  const double* const z = rows.heights(0);
  sums.slope_x.add(squares(rows, 0, nx - 1, 1, 0, 0, 1, [&](std::size_t i) { return z[i + 1] - z[i]; }));
  if (nx > 2) {
    sums.curve_x.add(
        squares(rows, 1, nx - 1, 1, 0, -1, 1, [&](std::size_t i) { return z[i + 1] - 2 * z[i] + z[i - 1]; }));
  }
  if (rows.row + 1 >= ny) return;
  const double* const above = rows.heights(1);
  sums.slope_y.add(squares(rows, 0, nx, 0, 1, 0, 1, [&](std::size_t i) { return above[i] - z[i]; }));
  if (rows.row == 0) return;
  const double* const below = rows.heights(-1);
  sums.curve_y.add(squares(rows, 0, nx, 0, 1, -1, 1, [&](std::size_t i) { return above[i] - 2 * z[i] + below[i]; }));
  Sums block;
  const bool whole = rows.map.missing.empty();
  for (std::size_t i = 1; i + 1 < nx; ++i) {
    if (!whole && !rows.complete_block(i)) continue;
    const double slope_x = 0.5 * (z[i + 1] - z[i - 1]), slope_y = 0.5 * (above[i] - below[i]);
    const double xx = z[i + 1] - 2 * z[i] + z[i - 1], yy = above[i] - 2 * z[i] + below[i];
    const double xy = 0.25 * (above[i + 1] - above[i - 1] - below[i + 1] + below[i - 1]);
    block.slopes_xy.sum += slope_x * slope_y;
    block.curve_xxyy.sum += xx * yy;
    block.curve_xyxy.sum += xy * xy;
    block.curve_xxxy.sum += xx * xy;
    block.curve_xyyy.sum += xy * yy;
    ++block.slopes_xy.count;
  }
  for (Mean Sums::*mean :
       {&Sums::slopes_xy, &Sums::curve_xxyy, &Sums::curve_xyxy, &Sums::curve_xxxy, &Sums::curve_xyyy}) {
    (block.*mean).count = block.slopes_xy.count;
    (sums.*mean).add(block.*mean);
  }
}

// Weights of the sixth order at 1, 2 and 3 points to both sides.
double slope_of_seven(const double* z, std::ptrdiff_t step) {
  return (45 * (z[step] - z[-step]) - 9 * (z[2 * step] - z[-2 * step]) + (z[3 * step] - z[-3 * step])) / 60;
}

double curvature_of_seven(const double* z, std::ptrdiff_t step) {
  return (270 * (z[step] + z[-step]) - 27 * (z[2 * step] + z[-2 * step]) + 2 * (z[3 * step] + z[-3 * step]) -
          490 * z[0]) /
         180;
}

void add_seven_points(const Rows& rows, Sums& sums) {
  const std::size_t nx = rows.map.points_x, ny = rows.map.points_y;
  const double* const z = rows.heights(0);
  if (nx >= 7) {
    sums.slope_x.add(squares(rows, 3, nx - 3, 1, 0, -3, 3, [&](std::size_t i) { return slope_of_seven(z + i, 1); }));
    sums.curve_x.add(
        squares(rows, 3, nx - 3, 1, 0, -3, 3, [&](std::size_t i) { return curvature_of_seven(z + i, 1); }));
  }
  if (rows.row < 3 || rows.row + 3 >= ny) return;
  const auto step = static_cast<std::ptrdiff_t>(nx);
  sums.slope_y.add(squares(rows, 0, nx, 0, 1, -3, 3, [&](std::size_t i) { return slope_of_seven(z + i, step); }));
  sums.curve_y.add(squares(rows, 0, nx, 0, 1, -3, 3, [&](std::size_t i) { return curvature_of_seven(z + i, step); }));
}

void check_count(const Mean& mean, const char* axis, DifferenceScheme scheme) {
  if (mean.count >= kMinStencils) return;
  throw InputError("along " + std::string(axis) + " there are " + std::to_string(mean.count) +
                       " complete sets of points for " + scheme_text(scheme) + ", fewer than " +
                       std::to_string(kMinStencils),
                   "take a larger region, or one with fewer missing points");
}

}  // namespace

std::string scheme_text(DifferenceScheme scheme) {
  return scheme == DifferenceScheme::neighbours ? "slopes of 2, curvatures of 3 neighbouring points"
                                                : "slopes and curvatures of 7 points";
}

MomentTable moment_table(const HeightMap& map, DifferenceScheme scheme) {
  const HeightStatistics heights = height_statistics(map);
  MomentTable table;
  table.scheme = scheme;
  table.profile = map.is_profile();
  table.m0_m2 = heights.Sq_m * heights.Sq_m;
  Sums sums;
  for (std::size_t j = 0; j < map.points_y; ++j) {
    if (scheme == DifferenceScheme::neighbours) {
      add_neighbours({map, j}, sums);
    } else {
      add_seven_points({map, j}, sums);
    }
  }
  check_count(sums.slope_x, "x", scheme);
  check_count(sums.curve_x, "x", scheme);
  table.stencils = sums.curve_x.count;
  const double h = map.step_x_m;
  table.m2_x = sums.slope_x.value() / (h * h);
  // A curvature that is round-off of the heights would make a radius out of nothing.
  const double size = std::max(heights.Sp_m, heights.Sv_m) + std::abs(heights.mean_m);
  const double round_off = 8 * std::numeric_limits<double>::epsilon() * size;
  const auto curvature = [&](const Mean& curve) {
    const double square = curve.value();
    return std::sqrt(square) > round_off ? square : 0.0;
  };
  table.m4_x_per_m2 = curvature(sums.curve_x) / (h * h * h * h);
  if (!table.profile) {
    check_count(sums.slope_y, "y", scheme);
    check_count(sums.curve_y, "y", scheme);
    const double k = map.step_y_m;
    table.m2_y = sums.slope_y.value() / (k * k);
    table.m4_y_per_m2 = curvature(sums.curve_y) / (k * k * k * k);
    if (scheme == DifferenceScheme::neighbours && sums.slopes_xy.count > 0) {
      table.m2_xy = sums.slopes_xy.value() / (h * k);
      table.m4_xxyy_per_m2 = sums.curve_xxyy.value() / (h * h * k * k);
      table.m4_xyxy_per_m2 = sums.curve_xyxy.value() / (h * h * k * k);
      table.m4_xxxy_per_m2 = sums.curve_xxxy.value() / (h * h * h * k);
      table.m4_xyyy_per_m2 = sums.curve_xyyy.value() / (h * k * k * k);
    }
  }
  for (const double moment : {table.m0_m2, table.m2_x, table.m2_y, table.m4_x_per_m2, table.m4_y_per_m2}) {
    if (std::isfinite(moment)) continue;
    throw InputError("the heights of the map are so large that its spectral moments cannot be expressed as numbers",
                     "heights and steps are in metres");
  }
  if (table.m4_x_per_m2 == 0 && table.m4_y_per_m2 == 0) {
    throw InputError("the surface has no curvature: m4 is zero, the radius of its asperities infinite",
                     "choose another channel or region");
  }
  return table;
}

MomentTable moment_table_above(HeightMap map, double height_m, DifferenceScheme scheme) {
  map.missing.resize(map.points(), 0);
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.missing[i] != 0 || map.height_m[i] >= height_m) continue;
    map.missing[i] = 1;
    map.height_m[i] = 0;
  }
  return moment_table(map, scheme);
}

SpectralMoments moments(const MomentTable& table, MomentDirection direction) {
  const SpectralMoments x{table.m0_m2, table.m2_x, table.m4_x_per_m2}, y{table.m0_m2, table.m2_y, table.m4_y_per_m2};
  if (table.profile) {
    if (direction == MomentDirection::y) {
      throw InputError("a profile has no moments along y", "take those along x");
    }
    return x;
  }
  switch (direction) {
    case MomentDirection::x:
      return x;
    case MomentDirection::y:
      return y;
    case MomentDirection::mean:
      return {table.m0_m2, 0.5 * (x.m2 + y.m2), 0.5 * (x.m4_per_m2 + y.m4_per_m2)};
    case MomentDirection::geometric:
      break;
  }
  return {table.m0_m2, std::sqrt(x.m2 * y.m2), std::sqrt(x.m4_per_m2 * y.m4_per_m2)};
}

SpectralMoments moments_at_angle(const MomentTable& table, double angle_rad) {
  if (table.profile || table.scheme != DifferenceScheme::neighbours) {
    throw InputError("moments at an angle are taken from maps by " + scheme_text(DifferenceScheme::neighbours) +
                     " alone");
  }
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {table.m0_m2, c * c * table.m2_x + s * s * table.m2_y + 2 * c * s * table.m2_xy,
          c * c * c * c * table.m4_x_per_m2 + s * s * s * s * table.m4_y_per_m2 +
              2 * c * c * s * s * (table.m4_xxyy_per_m2 + 2 * table.m4_xyxy_per_m2) +
              4 * c * s * (c * c * table.m4_xxxy_per_m2 + s * s * table.m4_xyyy_per_m2)};
}

SpectralMoments without_noise(const SpectralMoments& surface, const SpectralMoments& flat) {
  const SpectralMoments rest{surface.m0_m2 - flat.m0_m2, surface.m2 - flat.m2, surface.m4_per_m2 - flat.m4_per_m2};
  for (const auto& [value, name] : {std::pair{rest.m0_m2, "m0"}, {rest.m2, "m2"}, {rest.m4_per_m2, "m4"}}) {
    if (value > 0) continue;
    throw InputError("taking off the noise of the flat leaves no " + std::string(name) +
                         ": the surface is not rougher than the instrument's noise",
                     "filter both maps with a longer short cut-off");
  }
  return rest;
}

double rms_slope(const MomentTable& table) { return std::sqrt(table.m2_x + table.m2_y); }

}  // namespace ringfilm::surface
