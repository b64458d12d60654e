#include "ringfilm/surface/topography/regions.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMinPointsOfRegion = 8;
constexpr double kHighShare = 0.1;

/// Height that a share of the measured points exceeds.
double level(const HeightMap& map, double share) {
  std::vector<double> heights;
  heights.reserve(map.points());
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i)) heights.push_back(-map.height_m[i]);
  }
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), at, heights.end());
  return -*at;
}

bool overlap(const Region& a, const Region& b) {
  return a.column < b.column + b.columns && b.column < a.column + a.columns && a.row < b.row + b.rows &&
         b.row < a.row + a.rows;
}

/// First points of regions: every quarter of a size, and the last that fits.
std::vector<std::size_t> starts(std::size_t points, std::size_t size) {
  std::vector<std::size_t> places;
  const std::size_t step = std::max<std::size_t>(1, size / 4);
  for (std::size_t at = 0; at + size <= points; at += step) places.push_back(at);
  if (places.back() != points - size) places.push_back(points - size);
  return places;
}

}  // namespace

Region region_in_metres(const HeightMap& map, double x_m, double y_m, double width_m, double height_m) {
  check_map(map);
  const double step_y_m = map.is_profile() ? 1.0 : map.step_y_m;
  const double end_x = (x_m + width_m) / map.step_x_m, end_y = map.is_profile() ? 0.0 : (y_m + height_m) / step_y_m;
  const double begin_x = x_m / map.step_x_m, begin_y = map.is_profile() ? 0.0 : y_m / step_y_m;
  const double slack = 1e-6;  // tolerance in steps: lengths come from text
  const bool inside = std::isfinite(begin_x + end_x + begin_y + end_y) && begin_x >= -slack && begin_y >= -slack &&
                      end_x <= static_cast<double>(map.points_x) + slack &&
                      end_y <= static_cast<double>(map.points_y) + slack && width_m > 0 &&
                      (map.is_profile() || height_m > 0);
  if (!inside) {
    throw InputError("a region of " + length_text(width_m) + " x " + length_text(height_m) + " at " + length_text(x_m) +
                         ", " + length_text(y_m) + " does not lie on the map",
                     "the map measures " + length_text(map.step_x_m * static_cast<double>(map.points_x)) + " x " +
                         length_text(map.step_y_m * static_cast<double>(map.points_y)));
  }
  const auto first = [&](double place) { return static_cast<std::size_t>(std::max(0.0, std::ceil(place - slack))); };
  Region region;
  region.column = first(begin_x);
  region.row = first(begin_y);
  region.columns = std::min(first(end_x), map.points_x) - std::min(region.column, map.points_x);
  region.rows = map.is_profile() ? 1 : std::min(first(end_y), map.points_y) - std::min(region.row, map.points_y);
  if (region.columns == 0 || region.rows == 0) {
    throw InputError("a region of " + length_text(width_m) + " x " + length_text(height_m) + " holds no points");
  }
  return region;
}

std::vector<Region> grid_regions(const HeightMap& map, std::size_t across, std::size_t down) {
  check_map(map);
  if (map.is_profile()) down = std::min<std::size_t>(down, 1);
  const bool fits = across > 0 && down > 0 && map.points_x / across >= kMinPointsOfRegion &&
                    (map.is_profile() || map.points_y / down >= kMinPointsOfRegion);
  if (!fits) {
    throw InputError(std::to_string(across) + " x " + std::to_string(down) + " regions do not fit on a map of " +
                         std::to_string(map.points_x) + " x " + std::to_string(map.points_y) + " points",
                     "each needs " + std::to_string(kMinPointsOfRegion) + " points or more in a direction");
  }
  const std::size_t columns = map.points_x / across, rows = map.points_y / down;
  std::vector<Region> regions;
  for (std::size_t j = 0; j < down; ++j) {
    for (std::size_t i = 0; i < across; ++i) regions.push_back({i * columns, j * rows, columns, rows, 0});
  }
  return regions;
}

std::vector<Region> prominent_regions(const HeightMap& map, std::size_t count, std::size_t columns, std::size_t rows) {
  check_map(map);
  if (map.is_profile()) rows = 1;
  if (columns < kMinPointsOfRegion || (!map.is_profile() && rows < kMinPointsOfRegion) || columns > map.points_x ||
      rows > map.points_y) {
    throw InputError("regions of " + std::to_string(columns) + " x " + std::to_string(rows) +
                         " points do not fit on a map of " + std::to_string(map.points_x) + " x " +
                         std::to_string(map.points_y) + " points",
                     "each needs " + std::to_string(kMinPointsOfRegion) + " points or more in a direction");
  }
  const double high = level(map, kHighShare);
  std::vector<Region> candidates;
  for (const std::size_t row : starts(map.points_y, rows)) {
    for (const std::size_t column : starts(map.points_x, columns)) {
      double above = 0;
      std::size_t measured = 0;
      for (std::size_t j = row; j < row + rows; ++j) {
        for (std::size_t i = map.index(column, j); i < map.index(column + columns, j); ++i) {
          if (!map.measured(i)) continue;
          above += std::max(0.0, map.height_m[i] - high);
          ++measured;
        }
      }
      if (2 * measured < columns * rows) continue;
      candidates.push_back({column, row, columns, rows, above / static_cast<double>(measured)});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Region& a, const Region& b) { return a.prominence_m > b.prominence_m; });
  std::vector<Region> chosen;
  for (const Region& candidate : candidates) {
    if (chosen.size() == count) break;
    const bool free =
        std::none_of(chosen.begin(), chosen.end(), [&](const Region& taken) { return overlap(taken, candidate); });
    if (free) chosen.push_back(candidate);
  }
  return chosen;
}

HeightMap part_of_map(const HeightMap& map, const Region& region) {
  if (region.columns == 0 || region.rows == 0 || region.columns > map.points_x || region.rows > map.points_y ||
      region.column > map.points_x - region.columns || region.row > map.points_y - region.rows) {
    throw InputError("a region of " + std::to_string(region.columns) + " x " + std::to_string(region.rows) +
                     " points at column " + std::to_string(region.column + 1) + " of row " +
                     std::to_string(region.row + 1) + " does not lie on the map");
  }
  HeightMap part{region.columns, region.rows, map.step_x_m, map.step_y_m, {}, {}};
  part.height_m.reserve(part.points());
  for (std::size_t j = region.row; j < region.row + region.rows; ++j) {
    const auto begin = static_cast<std::ptrdiff_t>(map.index(region.column, j));
    const auto end = begin + static_cast<std::ptrdiff_t>(region.columns);
    part.height_m.insert(part.height_m.end(), map.height_m.begin() + begin, map.height_m.begin() + end);
    if (!map.missing.empty()) {
      part.missing.insert(part.missing.end(), map.missing.begin() + begin, map.missing.begin() + end);
    }
  }
  return part;
}

}  // namespace ringfilm::surface
