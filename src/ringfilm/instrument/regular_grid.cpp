#include "ringfilm/instrument/regular_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/instrument/formats/binary_reader.hpp"

namespace ringfilm::instrument {
namespace {

/// By how much of a step a place may lie off the grid: files round their places to a few digits.
constexpr double kOffGrid = 0.02;

struct GridAxis {
  double first = 0;
  double step = 0;
  std::size_t points = 1;
};

/// The even places that all given ones lie on.
GridAxis axis_of(const std::string& file, std::vector<double> places, const char* name) {
  std::sort(places.begin(), places.end());
  const double range = places.back() - places.front();
  GridAxis axis;
  axis.first = places.front();
  if (!(range > 0)) return axis;
  if (!std::isfinite(range)) refuse(file, fmt::format("the places {} are not finite", name), "give finite numbers");
  double largest = 0;
  for (std::size_t i = 1; i < places.size(); ++i) largest = std::max(largest, places[i] - places[i - 1]);
  // Gaps far below the largest are the rounding of one and the same place.
  double step = largest;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double gap = places[i] - places[i - 1];
    if (gap > 0.05 * largest) step = std::min(step, gap);
  }
  const double steps = std::round(range / step);
  if (!(steps < static_cast<double>(kMostPoints))) {
    refuse(file, fmt::format("the places {} form no grid of any use", name), "export the measurement as a matrix");
  }
  axis.points = static_cast<std::size_t>(steps) + 1;
  axis.step = range / steps;
  return axis;
}

std::size_t place_on(const std::string& file, const GridAxis& axis, double place, std::size_t point, const char* name) {
  if (axis.points == 1) return 0;
  const double steps = (place - axis.first) / axis.step;
  const double nearest = std::round(steps);
  if (!(std::abs(steps - nearest) <= kOffGrid)) {
    refuse(file,
           fmt::format("point {}: {} = {} lies {:.3g} of a step off the grid of step {:.9g}", point + 1, name, place,
                       std::abs(steps - nearest), axis.step),
           "points on an even grid are required: resample them in the program that wrote them");
  }
  return static_cast<std::size_t>(nearest);
}

}  // namespace

ChannelValues on_regular_grid(const std::string& file, const ListedPoints& points) {
  if (points.value.empty()) refuse(file, "the file has no point", "is it the right file?");
  const GridAxis along_x = axis_of(file, points.x, "x"), along_y = axis_of(file, points.y, "y");
  const std::size_t n_places = checked_points(file, along_x.points, along_y.points);
  if (n_places > 10 * points.value.size()) {
    refuse(file,
           fmt::format("{} points would fill a tenth or less of a grid of {} x {}", points.value.size(), along_x.points,
                       along_y.points),
           "points on an even grid are required: resample them in the program that wrote them");
  }
  ChannelValues grid;
  grid.channel.points_x = along_x.points;
  grid.channel.points_y = along_y.points;
  grid.step_x = along_x.step;
  grid.step_y = along_y.step;
  grid.value.assign(n_places, 0.0);
  grid.missing.assign(n_places, 2);  // nobody has been there
  for (std::size_t k = 0; k < points.value.size(); ++k) {
    const std::size_t column = place_on(file, along_x, points.x[k], k, "x");
    const std::size_t row = place_on(file, along_y, points.y[k], k, "y");
    const std::size_t place = row * along_x.points + column;
    if (grid.missing[place] != 2) {
      refuse(file, fmt::format("point {}: a second height at x = {}, y = {}", k + 1, points.x[k], points.y[k]),
             "give each place one height");
    }
    const bool measured = !std::isnan(points.value[k]);
    grid.missing[place] = measured ? 0 : 1;
    if (measured) grid.value[place] = points.value[k];
  }
  bool any_missing = false;
  for (std::uint8_t& missing : grid.missing) {
    missing = missing != 0 ? 1 : 0;
    any_missing = any_missing || missing != 0;
  }
  if (!any_missing) grid.missing.clear();
  return grid;
}

double even_step(const std::vector<double>& places) {
  if (places.size() < 2) return 0;
  const double step = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
  if (!(step > 0) || !std::isfinite(step)) return 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double even = places.front() + step * static_cast<double>(i);
    if (!(std::abs(places[i] - even) <= kOffGrid * step)) return 0;
  }
  return step;
}

}  // namespace ringfilm::instrument
