#include "ringfilm/instrument/grid/even_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "ringfilm/base/display.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kWidestHole = 3;  ///< in steps; assumed
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The height at a place of a rising list, linear between two of its places; NaN in a hole.
double height_between(const std::vector<double>& x, const std::vector<double>& height, double place, double widest) {
  const auto next = std::lower_bound(x.begin(), x.end(), place);
  if (next == x.end()) return height.back();
  const auto k = static_cast<std::size_t>(next - x.begin());
  if (*next == place || k == 0) return height[k];
  if (x[k] - x[k - 1] > widest) return kUnknown;
  return height[k - 1] + (height[k] - height[k - 1]) * (place - x[k - 1]) / (x[k] - x[k - 1]);
}

}  // namespace

void resample_evenly(ChannelValues& values) {
  const std::size_t n = values.x.size();
  std::vector<double> measured = values.value, even_x(n), even(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (values.is_missing(i)) measured[i] = kUnknown;
  }
  const double first = values.x.front(), step = (values.x.back() - first) / static_cast<double>(n - 1);
  double shortest = step, longest = step;
  for (std::size_t i = 1; i < n; ++i) {
    shortest = std::min(shortest, values.x[i] - values.x[i - 1]);
    longest = std::max(longest, values.x[i] - values.x[i - 1]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    even_x[i] = i + 1 == n ? values.x.back() : first + step * static_cast<double>(i);
    even[i] = height_between(values.x, measured, even_x[i], kWidestHole * step);
  }
  double sum = 0, mean = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double difference = height_between(even_x, even, values.x[i], kWidestHole * step) - measured[i];
    if (std::isnan(difference)) continue;
    sum += difference * difference;
    mean += measured[i];
    squares += measured[i] * measured[i];
    ++count;
  }
  const double off = std::sqrt(sum / count),
               rq = std::sqrt(std::max(0.0, squares / count - mean / count * mean / count));
  values.notes.push_back(fmt::format(
      "the places are uneven, in steps of {:.4g} to {:.4g} {}: the heights were interpolated linearly to even steps of "
      "{:.4g}; interpolated back they differ from the measured ones by {} (rms), {:.2g} % of Rq",
      shortest, longest, values.step_unit, step, text_in(off, kMicrometre, 3), rq > 0 ? 100 * off / rq : 0));
  values.x.clear();
  values.step_x = step;
  values.missing.clear();
  values.value = std::move(even);
  values.set_missing_where_nan();
}

}  // namespace ringfilm::instrument
