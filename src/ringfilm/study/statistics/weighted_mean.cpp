#include "ringfilm/study/statistics/weighted_mean.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::study {

std::optional<double> weighted_mean(const Plan& plan, const std::vector<double>& values, std::size_t base) {
  const std::vector<WeightedPoint>& points = plan.study().sampling.points;
  // Relative to the largest weight, so that no sum of them runs out of range.
  double largest = 0, sum = 0, weights = 0;
  for (const WeightedPoint& point : points) largest = std::max(largest, point.weight);
  for (std::size_t p = 0; p < points.size(); ++p) {
    sum += points[p].weight / largest * values[plan.scenario(base, p)];
    weights += points[p].weight / largest;
  }
  if (points.empty() || !std::isfinite(sum)) return std::nullopt;
  return sum / weights;
}

}  // namespace ringfilm::study
