#include "ringfilm/study/swing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ringfilm/study/statistics.hpp"

namespace ringfilm::study {
namespace {

constexpr std::size_t kLeast = 3;

double median(std::vector<double> values) { return quantile_of(sorted_values(values), 0.5).value; }

}  // namespace

std::optional<Swing> swing_of(std::span<const double> factor, std::span<const double> values) {
  if (factor.size() != values.size()) throw std::invalid_argument("a factor and values of different scenarios");
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(factor[i]) && std::isfinite(values[i])) pairs.emplace_back(factor[i], values[i]);
  }
  std::sort(pairs.begin(), pairs.end());
  if (pairs.size() < 3 * kLeast || pairs.front().first == pairs.back().first) return std::nullopt;
  // Bounds by value, so that scenarios with one value of the factor stay together.
  const double low = pairs[(pairs.size() - 1) / 3].first, high = pairs[pairs.size() - 1 - (pairs.size() - 1) / 3].first;
  const bool is_coarse = low == high;
  std::vector<double> lows, highs;
  for (const auto& [x, y] : pairs) {
    if (x <= (is_coarse ? pairs.front().first : low)) lows.push_back(y);
    if (x >= (is_coarse ? pairs.back().first : high)) highs.push_back(y);
  }
  if (lows.size() < kLeast || highs.size() < kLeast) return std::nullopt;
  return Swing{median(std::move(lows)), median(std::move(highs))};
}

}  // namespace ringfilm::study
