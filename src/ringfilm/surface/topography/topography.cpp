#include "ringfilm/surface/topography/topography.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

std::string size_text(const HeightMap& map) {
  return std::to_string(map.points_x) + " x " + std::to_string(map.points_y) + " points";
}

}  // namespace

std::string length_text(double length_m) {
  const double size = std::abs(length_m);
  if (!std::isfinite(size)) return number_text(length_m) + " m";
  return text_in(length_m, size < 1e-7 ? kNanometre : size < 1e-3 ? kMicrometre : kMillimetre);
}

double mean_height(const HeightMap& map) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) continue;
    sum += map.height_m[i];
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

std::size_t measured_points(const HeightMap& map) {
  if (map.missing.empty()) return map.points();
  return map.points() - static_cast<std::size_t>(std::count_if(map.missing.begin(), map.missing.end(),
                                                               [](std::uint8_t mark) { return mark != 0; }));
}

void check_map(const HeightMap& map, std::size_t least_points) {
  if (map.height_m.empty() && map.points() == 0) {
    throw InputError("a map of " + size_text(map) + " has no heights", "give one row of heights or more");
  }
  if (map.points_y == 0 || map.points_x == 0 || map.height_m.size() / map.points_y != map.points_x ||
      map.height_m.size() % map.points_y != 0 || (!map.missing.empty() && map.missing.size() != map.height_m.size())) {
    throw InputError("a map of " + size_text(map) + " holds " + std::to_string(map.height_m.size()) + " heights and " +
                     std::to_string(map.missing.size()) + " marks of missing points");
  }
  if (map.points_x == 1) {
    throw InputError("a map of " + size_text(map) + " has one column: no slope can be taken along x",
                     "a profile is one row with its points along x");
  }
  const auto is_step = [](double step) { return std::isfinite(step) && step > 0; };
  if (!is_step(map.step_x_m) || (map.points_y > 1 && !is_step(map.step_y_m))) {
    throw InputError("the steps of the map, " + length_text(map.step_x_m) + " along x and " +
                         length_text(map.step_y_m) + " along y, are not positive lengths",
                     "state the distance of neighbouring points");
  }
  std::size_t measured = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) continue;
    ++measured;
    if (!std::isfinite(map.height_m[i])) {
      throw InputError("the height in column " + std::to_string(i % map.points_x + 1) + " of row " +
                           std::to_string(i / map.points_x + 1) + " is not a number but " +
                           number_text(map.height_m[i]),
                       "mark points without a height as missing");
    }
  }
  if (measured < least_points) {
    throw InputError("a map of " + size_text(map) + " has " + std::to_string(measured) +
                         " measured points, fewer than " + std::to_string(least_points) + " that are needed",
                     "take a larger region, or one with fewer missing points");
  }
}

}  // namespace ringfilm::surface
