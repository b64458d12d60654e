#include "ringfilm/study/statistics/one_at_a_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ringfilm/study/statistics/statistics.hpp"

namespace ringfilm::study {
namespace {

constexpr std::size_t kMin = 3;

double median(std::vector<double> values) { return quantile_of(sorted_values(values), 0.5).value; }

}  // namespace

SensitivityEnds sensitivity_ends(const Variation& variation) {
  const bool is_listed = std::holds_alternative<Levels>(variation) || std::holds_alternative<Choices>(variation);
  return is_listed ? SensitivityEnds::kValues : SensitivityEnds::kThirds;
}

std::optional<OneAtATimeSensitivity> one_at_a_time_sensitivity(std::span<const double> factor,
                                                               std::span<const double> values, SensitivityEnds ends) {
  if (factor.size() != values.size()) throw std::invalid_argument("a factor and values of different scenarios");
  std::vector<std::pair<double, double>> pairs;
  // A value of which no scenario was solved is an end nevertheless: another would be reported in its place.
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(factor[i])) continue;
    lowest = std::min(lowest, factor[i]);
    highest = std::max(highest, factor[i]);
    if (std::isfinite(values[i])) pairs.emplace_back(factor[i], values[i]);
  }
  const std::size_t least = ends == SensitivityEnds::kThirds ? 3 * kMin : 2 * kMin;
  if (pairs.size() < least || lowest == highest) return std::nullopt;
  std::sort(pairs.begin(), pairs.end());
  double low = lowest, high = highest;
  if (ends == SensitivityEnds::kThirds) {
    // Bounds by value, so that scenarios with one value of the factor stay together.
    const std::size_t third = (pairs.size() - 1) / 3;
    const double below = pairs[third].first, above = pairs[pairs.size() - 1 - third].first;
    const bool is_coarse = below == above;
    low = is_coarse ? pairs.front().first : below;
    high = is_coarse ? pairs.back().first : above;
  }
  std::vector<double> lows, highs;
  for (const auto& [x, y] : pairs) {
    if (x <= low) lows.push_back(y);
    if (x >= high) highs.push_back(y);
  }
  if (low >= high || lows.size() < kMin || highs.size() < kMin) return std::nullopt;
  return OneAtATimeSensitivity{median(std::move(lows)), median(std::move(highs))};
}

}  // namespace ringfilm::study
