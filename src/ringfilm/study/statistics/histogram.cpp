#include "ringfilm/study/statistics/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/study/statistics/statistics.hpp"

namespace ringfilm::study {
namespace {

constexpr double kTail = 0.005;
/// A range so many times that without the tails is cut down to it.
constexpr double kThinned = 1.5;
constexpr double kMinBins = 8, kMaxBins = 50;

struct Limits {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void take(double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  }
};

}  // namespace

Histogram histogram(const std::vector<std::vector<double>>& sorted) {
  Limits whole, inner;
  std::size_t most = 0;
  for (const std::vector<double>& values : sorted) {
    if (values.empty()) continue;
    most = std::max(most, values.size());
    whole.take(values.front(), values.back());
    inner.take(quantile_of(values, kTail).value, quantile_of(values, 1 - kTail).value);
  }
  Histogram result;
  result.counts.resize(sorted.size());
  result.below.assign(sorted.size(), 0);
  result.above.assign(sorted.size(), 0);
  if (most == 0) return result;
  Limits range = whole.high - whole.low > kThinned * (inner.high - inner.low) && inner.high > inner.low ? inner : whole;
  if (range.low == range.high) {
    // All alike: one bin about them.
    const double half = range.low == 0 ? 0.5 : 0.005 * std::abs(range.low);
    range = {range.low - half, range.high + half};
  }
  const double requested = std::sqrt(static_cast<double>(most));
  const auto n_bins = static_cast<std::size_t>(std::clamp(requested, kMinBins, kMaxBins));
  const double step = (range.high - range.low) / static_cast<double>(n_bins);
  for (std::size_t k = 0; k <= n_bins; ++k) result.edges.push_back(range.low + static_cast<double>(k) * step);
  result.edges.back() = range.high;
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    result.counts[s].assign(n_bins, 0);
    for (const double value : sorted[s]) {
      if (value < range.low) {
        ++result.below[s];
      } else if (value > range.high) {
        ++result.above[s];
      } else {
        const auto bin = static_cast<std::size_t>((value - range.low) / step);
        ++result.counts[s][std::min(bin, n_bins - 1)];
      }
    }
  }
  return result;
}

}  // namespace ringfilm::study
