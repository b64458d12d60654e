#include "ringfilm/report/thinned_curve.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace ringfilm::report {
namespace {

constexpr std::size_t kPointsOfAStretch = 4;

/// Where a place lies on the drawn axis; NaN where it has no place there.
double along(const io::MeasuredAxis& axis, double x) {
  if (!axis.logarithmic) return x;
  return x > 0 ? std::log(x) : std::nan("");
}

/// The points of one stretch that are kept, and one gap if it has any.
void keep(const io::MeasuredSeries& series, std::size_t begin, std::size_t end, std::set<std::size_t>& kept) {
  std::size_t lowest = end, highest = end, first = end, last = end, gap = end;
  for (std::size_t i = begin; i < end; ++i) {
    if (!std::isfinite(series.y[i])) {
      gap = i;
      continue;
    }
    if (first == end) first = lowest = highest = i;
    last = i;
    if (series.y[i] < series.y[lowest]) lowest = i;
    if (series.y[i] > series.y[highest]) highest = i;
  }
  for (const std::size_t i : {first, lowest, highest, last, gap}) {
    if (i != end) kept.insert(i);
  }
}

}  // namespace

ThinnedSeries thinned(const io::MeasuredCurve& curve, const io::MeasuredSeries& series, std::size_t stretches) {
  if (curve.x.size() <= kPointsOfAStretch * stretches) return {curve.x, series.y};
  std::vector<double> places;
  for (const double x : curve.x) places.push_back(along(curve.x_axis, x));
  double low = INFINITY, high = -INFINITY;
  for (const double place : places) {
    if (!std::isfinite(place)) continue;
    low = std::min(low, place);
    high = std::max(high, place);
  }
  if (!(high > low)) return {curve.x, series.y};
  const auto stretch = [&](std::size_t i) {
    const double share = std::isfinite(places[i]) ? (places[i] - low) / (high - low) : 0;
    return std::min(stretches - 1, static_cast<std::size_t>(share * static_cast<double>(stretches)));
  };
  std::set<std::size_t> kept;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && stretch(end) == stretch(begin)) ++end;
    keep(series, begin, end, kept);
  }
  ThinnedSeries few;
  for (const std::size_t i : kept) {
    few.x.push_back(curve.x[i]);
    few.y.push_back(series.y[i]);
  }
  return few;
}

}  // namespace ringfilm::report
