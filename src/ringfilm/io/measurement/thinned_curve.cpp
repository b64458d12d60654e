#include "ringfilm/io/measurement/thinned_curve.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace ringfilm::io {
namespace {

constexpr std::size_t kPointsOfAStretch = 4;

/// Where a place lies on the drawn axis; NaN where it has no place there.
double along(const MeasuredAxis& axis, double x) {
  if (!axis.logarithmic) return x;
  return x > 0 ? std::log(x) : std::nan("");
}

/// The points of one stretch that are kept, and one gap if it has any.
void keep(const MeasuredSeries& series, std::size_t begin, std::size_t end, std::set<std::size_t>& kept) {
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

/// The axis in `stretches` even parts (even on its scale); has none where its places are all the same.
class Stretches {
 public:
  Stretches(const MeasuredCurve& curve, std::size_t count) : curve_(curve), count_(count) {
    for (const double x : curve.x) {
      const double place = along(curve.x_axis, x);
      if (!std::isfinite(place)) continue;
      low_ = std::min(low_, place);
      high_ = std::max(high_, place);
    }
  }

  bool any() const { return high_ > low_; }

  std::size_t of(std::size_t i) const {
    const double place = along(curve_.x_axis, curve_.x[i]);
    const double share = std::isfinite(place) ? (place - low_) / (high_ - low_) : 0;
    return std::min(count_ - 1, static_cast<std::size_t>(share * static_cast<double>(count_)));
  }

 private:
  const MeasuredCurve& curve_;
  std::size_t count_;
  double low_ = INFINITY, high_ = -INFINITY;
};

void keep(const MeasuredSeries& series, const Stretches& stretches, std::set<std::size_t>& kept) {
  const std::size_t n = series.y.size();
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    const std::size_t stretch = stretches.of(begin);
    while (end < n && stretches.of(end) == stretch) ++end;
    keep(series, begin, end, kept);
  }
}

}  // namespace

ThinnedSeries thinned(const MeasuredCurve& curve, const MeasuredSeries& series, std::size_t stretches) {
  if (curve.x.size() <= kPointsOfAStretch * stretches) return {curve.x, series.y};
  const Stretches parts(curve, stretches);
  if (!parts.any()) return {curve.x, series.y};
  std::set<std::size_t> kept;
  keep(series, parts, kept);
  ThinnedSeries few;
  for (const std::size_t i : kept) {
    few.x.push_back(curve.x[i]);
    few.y.push_back(series.y[i]);
  }
  return few;
}

std::optional<MeasuredCurve> thinned(const MeasuredCurve& curve, std::size_t most_points) {
  if (curve.x.size() <= most_points || curve.series.empty()) return std::nullopt;
  // One point more for the gap that a stretch may have.
  const Stretches parts(curve, std::max<std::size_t>(1, most_points / ((kPointsOfAStretch + 1) * curve.series.size())));
  if (!parts.any()) return std::nullopt;
  std::set<std::size_t> kept;
  for (const MeasuredSeries& one : curve.series) keep(one, parts, kept);
  MeasuredCurve few{curve.name, curve.title, curve.caption, curve.x_axis, curve.y_axis, {}, {}, curve.marks};
  for (const std::size_t i : kept) few.x.push_back(curve.x[i]);
  for (const MeasuredSeries& one : curve.series) {
    few.series.push_back({one.name, one.label, {}, one.points});
    for (const std::size_t i : kept) few.series.back().y.push_back(one.y[i]);
  }
  return few;
}

}  // namespace ringfilm::io
