#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ringfilm::surface {

/// Heights on an even grid, as an instrument gives them: row after row, the first row at y = 0, x along a row, heights
/// counted away from the material. A profile is a map of one row. Points that were not measured are marked, and their
/// height is 0.
struct HeightMap {
  std::size_t points_x = 0;           ///< along a row
  std::size_t points_y = 0;           ///< rows; 1: a profile
  double step_x_m = 0.0;              ///< between points of a row [m]
  double step_y_m = 0.0;              ///< between rows; of a profile of no meaning [m]
  std::vector<double> height_m;       ///< points_x * points_y [m]
  std::vector<std::uint8_t> missing;  ///< 1 where there is no height; empty when every point was measured

  std::size_t points() const { return points_x * points_y; }  ///< measured or not
  /// Index of a point, row after row.
  std::size_t index(std::size_t column, std::size_t row) const { return row * points_x + column; }
  bool measured(std::size_t point) const { return missing.empty() || missing[point] == 0; }  ///< is there a height?
  bool is_profile() const { return points_y == 1; }                                          ///< one row
};

/// Refuses a map that no analysis can take: sizes that do not fit, steps that are not positive lengths, a map of one
/// column, a height that is not a finite number, fewer measured points than required.
/// @param least_points how many measured points the caller needs
void check_map(const HeightMap& map, std::size_t least_points = 1);

/// How many points have a height.
std::size_t measured_points(const HeightMap& map);

/// Mean of the heights that were measured; 0 of none [m].
double mean_height(const HeightMap& map);

/// A length as messages print it, for example "0.25 um".
std::string length_text(double length_m);

/// A trace of a stylus: places [m], rising, not always evenly spaced, and heights [m].
struct Trace {
  std::vector<double> x_m;       ///< places along the trace, rising [m]
  std::vector<double> height_m;  ///< at these places [m]
};

}  // namespace ringfilm::surface
