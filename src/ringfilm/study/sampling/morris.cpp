#include "ringfilm/study/sampling/morris.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::study {

/// One walk: where it begins, and its steps.
struct MorrisTrajectories::Trajectory {
  std::vector<std::size_t> first;  ///< level of each factor, from 0
  std::vector<bool> rises;         ///< does its step go up?
  std::vector<std::size_t> order;  ///< factor of each step
};

MorrisTrajectories::MorrisTrajectories(std::size_t n_factors, std::size_t n_levels, std::uint64_t seed)
    : n_factors_(n_factors), n_levels_(n_levels), seed_(seed) {
  if (n_levels < 2 || n_levels % 2 != 0) throw std::invalid_argument("an even number of levels is required");
}

MorrisTrajectories::Trajectory MorrisTrajectories::trajectory(std::uint64_t i) const {
  const std::uint64_t seed = hash(seed_, i);
  const std::size_t half = n_levels_ / 2;
  Trajectory walk{std::vector<std::size_t>(n_factors_), std::vector<bool>(n_factors_),
                  std::vector<std::size_t>(n_factors_)};
  for (std::size_t j = 0; j < n_factors_; ++j) {
    walk.rises[j] = (hash(seed, 0, j) >> 63) != 0;
    walk.first[j] = below(half, hash(seed, 1, j)) + (walk.rises[j] ? 0 : half);
  }
  std::iota(walk.order.begin(), walk.order.end(), std::size_t{0});
  for (std::size_t j = n_factors_; j > 1; --j) std::swap(walk.order[j - 1], walk.order[below(j, hash(seed, 2, j))]);
  return walk;
}

std::vector<double> MorrisTrajectories::point(std::uint64_t i) const {
  const Trajectory walk = trajectory(i / points_per_trajectory());
  std::vector<std::size_t> levels = walk.first;
  const std::size_t steps = i % points_per_trajectory(), half = n_levels_ / 2;
  for (std::size_t s = 0; s < steps; ++s) {
    const std::size_t j = walk.order[s];
    levels[j] = walk.rises[j] ? levels[j] + half : levels[j] - half;
  }
  std::vector<double> shares;
  for (const std::size_t level : levels)
    shares.push_back(static_cast<double>(level) / static_cast<double>(n_levels_ - 1));
  return shares;
}

std::optional<MorrisTrajectories::Step> MorrisTrajectories::step_to(std::uint64_t i) const {
  const std::size_t steps = i % points_per_trajectory();
  if (steps == 0) return std::nullopt;
  const Trajectory walk = trajectory(i / points_per_trajectory());
  const std::size_t j = walk.order[steps - 1];
  const double change = static_cast<double>(n_levels_ / 2) / static_cast<double>(n_levels_ - 1);
  return Step{j, walk.rises[j] ? change : -change};
}

std::vector<std::optional<MorrisEffect>> morris_effects(const MorrisTrajectories& trajectories,
                                                        std::span<const double> values) {
  const std::size_t n_factors = trajectories.points_per_trajectory() - 1;
  std::vector<std::vector<double>> effects(n_factors);
  std::vector<std::uint64_t> omitted(n_factors, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto step = trajectories.step_to(i);
    if (!step) continue;
    const double effect = (values[i] - values[i - 1]) / step->change;
    if (std::isfinite(effect)) {
      effects[step->factor].push_back(effect);
    } else {
      ++omitted[step->factor];
    }
  }
  std::vector<std::optional<MorrisEffect>> results(n_factors);
  for (std::size_t j = 0; j < n_factors; ++j) {
    const auto n = static_cast<double>(effects[j].size());
    if (effects[j].size() < 2) continue;
    MorrisEffect result;
    for (const double effect : effects[j]) {
      result.mean += effect / n;
      result.mean_absolute += std::abs(effect) / n;
    }
    double square = 0, square_of_absolute = 0;
    for (const double effect : effects[j]) {
      square += (effect - result.mean) * (effect - result.mean);
      square_of_absolute += (std::abs(effect) - result.mean_absolute) * (std::abs(effect) - result.mean_absolute);
    }
    result.deviation = std::sqrt(square / (n - 1));
    result.mean_absolute_error = std::sqrt(square_of_absolute / (n - 1) / n);
    result.count = effects[j].size();
    result.omitted = omitted[j];
    results[j] = result;
  }
  return results;
}

}  // namespace ringfilm::study
