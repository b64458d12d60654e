#include "ringfilm/instrument/grid/regular_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "ringfilm/instrument/grid/binary_reader.hpp"

namespace ringfilm::instrument {
namespace {

/// By how much of a step a place may lie off the grid: files round their places to a few digits.
constexpr double kOffGrid = 0.02;
/// Digits coarser than this share of a step leave open which place of a grid is meant.
constexpr double kCoarsestDigit = 0.25;

/// The unit of the last digit that all places are written with, if it is a large part of the step; else 0.
double digit_of(const std::vector<double>& places, double step) {
  double digit = std::pow(10.0, std::ceil(std::log10(step)));
  const auto holds = [&places](double of) {
    return std::all_of(places.begin(), places.end(),
                       [of](double place) { return std::abs(place / of - std::round(place / of)) <= 1e-6; });
  };
  for (; digit >= kOffGrid * step; digit /= 10) {
    if (holds(digit)) return digit;
  }
  return 0;
}

/// Did rounding to a digit move places of this step? Not where the step is a whole number of digits.
/// @param steps from the first to the last place
bool is_rounded(double digit, double step, double steps) {
  const double digits = digit > 0 ? step / digit : 0;
  return digit > 0 && std::abs(digits - std::round(digits)) * steps >= 1;
}

/// How far a place may lie off: its own rounding, and half of that of the first and of the last place.
double tolerance(const std::vector<double>& places, double step, double steps) {
  const double digit = digit_of(places, step);
  return is_rounded(digit, step, steps) && digit <= kCoarsestDigit * step ? std::max(kOffGrid * step, digit)
                                                                          : kOffGrid * step;
}

struct GridAxis {
  /// Places that occur, rising; the first of those that are one but for their rounding.
  std::vector<double> places;
  std::vector<std::size_t> index;  ///< index of each place on the grid
  double step = 0;
  double off = 0;       ///< how far a place may lie off the grid
  double rounding = 0;  ///< rounding of the step, where places were rounded by a large part of it; else 0
  std::size_t points = 1;
};

/// The places without those that are closer than a twentieth of the largest gap: rounding of one and the same.
std::vector<double> distinct(std::vector<double> places) {
  std::sort(places.begin(), places.end());
  double largest = 0;
  for (std::size_t i = 1; i < places.size(); ++i) largest = std::max(largest, places[i] - places[i - 1]);
  std::vector<double> kept = {places.front()};
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] - places[i - 1] > 0.05 * largest) kept.push_back(places[i]);
  }
  return kept;
}

/// Are these places an even grid without a hole, each rounded to a digit that may be coarse?
bool is_rounded_grid(const std::vector<double>& places) {
  constexpr std::size_t kEnough = 12;  // fewest places; fewer whole numbers with a hole look like rounded ones
  // Least step in digits; a grid of whole digits with few holes has hardly more than 1.
  constexpr double kMinDigits = 1.2;
  if (places.size() < kEnough) return false;
  const auto steps = static_cast<double>(places.size() - 1);
  const double step = (places.back() - places.front()) / steps, digit = digit_of(places, step);
  if (!is_rounded(digit, step, steps) || step < kMinDigits * digit) return false;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double even = places.front() + step * static_cast<double>(k);
    if (!(std::abs(places[k] - even) <= digit * (1 + 1e-9))) return false;
  }
  return true;
}

/// The even places that all given ones lie on.
GridAxis axis_of(const std::string& file, const std::vector<double>& all, const char* name) {
  GridAxis axis;
  axis.places = distinct(all);
  axis.index.assign(axis.places.size(), 0);
  const std::vector<double>& places = axis.places;
  const double range = places.back() - places.front();
  if (!(range > 0)) return axis;
  if (!std::isfinite(range)) refuse(file, fmt::format("the places {} are not finite", name), "give finite numbers");
  if (is_rounded_grid(places)) {
    axis.points = places.size();
    axis.step = range / static_cast<double>(places.size() - 1);
    axis.off = digit_of(places, axis.step);
    axis.rounding = axis.off / static_cast<double>(places.size() - 1);
    for (std::size_t k = 0; k < places.size(); ++k) axis.index[k] = k;
    return axis;
  }
  double least = range;
  for (std::size_t k = 1; k < places.size(); ++k) least = std::min(least, places[k] - places[k - 1]);
  // Rounding makes steps of two lengths: their mean is the step.
  double sum = 0, single = 0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double gap = places[k] - places[k - 1];
    if (gap > 1.5 * least) continue;
    sum += gap;
    single += 1;
  }
  const double steps = std::round(range / (sum / single));
  if (!(steps < static_cast<double>(kMaxPoints))) {
    refuse(file, fmt::format("the places {} form no grid of any use", name), "export the measurement as a matrix");
  }
  axis.points = static_cast<std::size_t>(steps) + 1;
  axis.step = range / steps;
  axis.off = tolerance(places, axis.step, steps);
  if (axis.off > kOffGrid * axis.step) axis.rounding = axis.off / steps;
  for (std::size_t k = 0; k < places.size(); ++k) {
    axis.index[k] = static_cast<std::size_t>(std::round((places[k] - places.front()) / axis.step));
  }
  return axis;
}

/// By how much the grid of points is turned, as a part of a sentence: from each of the first points to its nearest
/// neighbour. Empty where that is not one and the same angle, or none.
std::string words_of_turn(const ListedPoints& points) {
  constexpr std::size_t kLooked = 20;
  constexpr double kMinDeg = 0.05, kScatterDeg = 1, kQuarterDeg = 90;
  std::vector<double> turns;
  for (std::size_t i = 0; i < std::min(kLooked, points.x.size()); ++i) {
    double nearest = std::numeric_limits<double>::infinity(), angle = 0;
    for (std::size_t k = 0; k < points.x.size(); ++k) {
      const double x = points.x[k] - points.x[i], y = points.y[k] - points.y[i], distance = std::hypot(x, y);
      if (k == i || !(distance > 0) || distance >= nearest) continue;
      nearest = distance;
      angle = std::remainder(std::atan2(y, x) * 180 / std::numbers::pi, kQuarterDeg);
    }
    turns.push_back(angle);
  }
  std::sort(turns.begin(), turns.end());
  const double turn = turns[turns.size() / 2];
  if (std::abs(turn) < kMinDeg || turns.back() - turns.front() > kScatterDeg) return "";
  return fmt::format("; the grid seems to be turned by {:.3g} degree", turn);
}

std::size_t place_on(const std::string& file, const GridAxis& axis, const ListedPoints& points, std::size_t point,
                     const char* name) {
  const double place = (name[0] == 'x' ? points.x : points.y)[point];
  if (axis.points == 1) return 0;
  const auto next = std::upper_bound(axis.places.begin(), axis.places.end(), place);
  const std::size_t found = axis.index[static_cast<std::size_t>(next - axis.places.begin()) - 1];
  const double off = std::abs(place - (axis.places.front() + axis.step * static_cast<double>(found)));
  if (!(off <= axis.off * (1 + 1e-9))) {
    refuse(
        file,
        fmt::format("point {}: {} = {} lies {:.3g} of a step off the grid of step {:.9g}", point + 1, name, place,
                    off / axis.step, axis.step) +
            words_of_turn(points),
        "points on an even grid along x and y are required, which is not turned: write their places with more digits, "
        "or resample them in the program that wrote them");
  }
  return found;
}

/// Steps that are one but for the rounding of the places, which is noted.
void share_step(GridAxis& along_x, GridAxis& along_y, ChannelValues& grid) {
  if (along_x.rounding == 0 && along_y.rounding == 0) return;
  if (std::abs(along_x.step - along_y.step) <= along_x.rounding + along_y.rounding) {
    const auto n_x = static_cast<double>(along_x.points - 1), n_y = static_cast<double>(along_y.points - 1);
    along_x.step = along_y.step = (along_x.step * n_x + along_y.step * n_y) / (n_x + n_y);
  }
  grid.notes.push_back(
      fmt::format("the places were rounded by a large part of a step; the steps are {:.4g} and {:.4g} on "
                  "the mean",
                  along_x.step, along_y.step));
}

/// Rows or columns of the grid without any point: it may be finer than the measurement was.
void doubt_empty_lines(const GridAxis& axis, const char* word, ChannelValues& grid) {
  constexpr double kManyEmpty = 0.1;
  std::vector<std::size_t> claimed = axis.index;
  claimed.erase(std::unique(claimed.begin(), claimed.end()), claimed.end());
  const std::size_t empty = axis.points - std::min(claimed.size(), axis.points);
  if (static_cast<double>(empty) <= kManyEmpty * static_cast<double>(axis.points)) return;
  std::size_t first = 0;
  while (first < claimed.size() && claimed[first] == first) ++first;
  grid.doubts.push_back(
      {fmt::format("{} of the {} {}s of the grid have no point, the first of them {} {}", empty, axis.points, word,
                   word, first + 1),
       "if the steps were rounded or the first line is not a point, write the places with more digits "
       "and without that line"});
}

}  // namespace

ChannelValues on_regular_grid(const std::string& file, const ListedPoints& points) {
  if (points.value.empty()) refuse(file, "the file has no point", "is it the right file?");
  GridAxis along_x = axis_of(file, points.x, "x"), along_y = axis_of(file, points.y, "y");
  const std::size_t n_places = checked_points(file, along_x.points, along_y.points);
  if (n_places > 10 * points.value.size()) {
    refuse(file,
           fmt::format("{} points would fill a tenth or less of a grid of {} x {}", points.value.size(), along_x.points,
                       along_y.points) +
               words_of_turn(points),
           "points on an even grid are required: resample them in the program that wrote them");
  }
  ChannelValues grid;
  grid.channel.points_x = along_x.points;
  grid.channel.points_y = along_y.points;
  doubt_empty_lines(along_x, "column", grid);
  doubt_empty_lines(along_y, "row", grid);
  grid.value.assign(n_places, 0.0);
  grid.missing.assign(n_places, 2);  // nobody has been there
  for (std::size_t k = 0; k < points.value.size(); ++k) {
    const std::size_t column = place_on(file, along_x, points, k, "x");
    const std::size_t row = place_on(file, along_y, points, k, "y");
    const std::size_t place = row * along_x.points + column;
    if (grid.missing[place] != 2) {
      refuse(file, fmt::format("point {}: a second height at x = {}, y = {}", k + 1, points.x[k], points.y[k]),
             "give each place one height");
    }
    const bool measured = !std::isnan(points.value[k]);
    grid.missing[place] = measured ? 0 : 1;
    if (measured) grid.value[place] = points.value[k];
  }
  share_step(along_x, along_y, grid);
  grid.step_x = along_x.step;
  grid.step_y = along_y.step;
  bool any_missing = false;
  for (std::uint8_t& missing : grid.missing) {
    missing = missing != 0 ? 1 : 0;
    any_missing = any_missing || missing != 0;
  }
  if (!any_missing) grid.missing.clear();
  return grid;
}

bool fills_grid(const ListedPoints& points) {
  const auto steps_of = [](std::vector<double> places) -> std::size_t {
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return even_step(places) > 0 ? places.size() : 0;
  };
  const auto is_finite = [](double place) { return std::isfinite(place); };
  if (!std::all_of(points.x.begin(), points.x.end(), is_finite)) return false;
  if (!std::all_of(points.y.begin(), points.y.end(), is_finite)) return false;
  if (steps_of(points.x) * steps_of(points.y) != points.x.size()) return false;
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i < points.x.size(); ++i) pairs.emplace_back(points.x[i], points.y[i]);
  std::sort(pairs.begin(), pairs.end());
  return std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end();
}

double even_step(const std::vector<double>& places) {
  if (places.size() < 2) return 0;
  const double step = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
  if (!(step > 0) || !std::isfinite(step)) return 0;
  const double off = tolerance(places, step, static_cast<double>(places.size() - 1));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double even = places.front() + step * static_cast<double>(i);
    if (!(std::abs(places[i] - even) <= off)) return 0;
  }
  return step;
}

}  // namespace ringfilm::instrument
