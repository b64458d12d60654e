#include "ringfilm/study/statistics/weighted_mean.hpp"

#include <cmath>

namespace ringfilm::study {

std::optional<double> weighted_mean(const Plan& plan, const std::vector<double>& values, std::size_t base) {
  const std::vector<WeightedPoint>& points = plan.study().sampling.points;
  double sum = 0, weights = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    sum += points[p].weight * values[plan.scenario(base, p)];
    weights += points[p].weight;
  }
  if (points.empty() || !std::isfinite(sum)) return std::nullopt;
  return sum / weights;
}

}  // namespace ringfilm::study
