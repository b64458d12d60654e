#include "ringfilm/cycle/oil_settling.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "ringfilm/cycle/cycle_run.hpp"

namespace ringfilm::cycle {
namespace {

/// Cycles that are mixed at the most, the latest among them.
constexpr std::size_t kDepth = 5;
/// Share of the squared differences of `moved` that the weights leave to the scatter of the cycles, which follows the
/// steps.
constexpr double kScatter = 1e-3;
/// A mixture that moves so many times as much oil as the cycle before led astray: mixing begins anew.
constexpr double kAstray = 2;
/// No cell has less than this share of what the last cycle has left there.
constexpr double kMinShare = 0.1;
/// What moves less than this share of what moved before comes to rest by itself.
constexpr double kFast = 0.25;
/// Keeps the weight of a cell finite above which there is nothing.
constexpr double kNothing = 1e-60;

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
  return d;
}

}  // namespace

double AndersonMixing::product(const std::vector<double>& a, const std::vector<double>& b) const {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i] * weight_[i];
  return sum;
}

void AndersonMixing::add(const std::vector<double>& argument, const std::vector<double>& image) {
  Pair now{image, difference(image, argument), 0, share_elsewhere(image, argument)};
  std::partial_sum(now.moved.begin(), now.moved.end(), now.moved.begin());
  weight_.resize(image.size());
  std::partial_sum(image.begin(), image.end(), weight_.begin());
  for (double& above : weight_) above = 1 / std::max({above * above, least_ * least_, kNothing});
  now.norm = std::sqrt(product(now.moved, now.moved));
  if (!history_.empty() && now.norm > kAstray * moved()) history_.clear();
  history_.push_back(std::move(now));
  if (history_.size() > kDepth) history_.erase(history_.begin());
}

std::vector<double> AndersonMixing::mixture() const {
  const Pair& now = history_.back();
  std::vector<double> mixed = now.image;
  const std::size_t n = history_.size() - 1;
  std::vector<std::vector<double>> changes;
  for (std::size_t i = 0; i < n; ++i) changes.push_back(difference(now.moved, history_[i].moved));
  Eigen::MatrixXd normal(n, n);
  Eigen::VectorXd weight(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) normal(i, j) = product(changes[i], changes[j]);
    normal(i, i) += kScatter * normal(i, i) + std::numeric_limits<double>::min();
    weight(i) = product(changes[i], now.moved);
  }
  weight = normal.llt().solve(weight);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < mixed.size(); ++c) mixed[c] -= weight[i] * (now.image[c] - history_[i].image[c]);
  }
  for (std::size_t c = 0; c < mixed.size(); ++c) mixed[c] = std::max(mixed[c], kMinShare * now.image[c]);
  return mixed;
}

double AndersonMixing::cycles_ahead() const {
  if (!can_mix()) return kUnknownApproach;
  const Pair& now = history_.back();
  if (now.share == 0) return 0;
  double cycles = 0;
  for (std::size_t i = 0; i + 1 < history_.size(); ++i) {
    const std::vector<double> slower = difference(now.moved, history_[i].moved);
    std::vector<double> apart = difference(now.image, history_[i].image);
    std::partial_sum(apart.begin(), apart.end(), apart.begin());
    cycles = std::max(cycles, std::sqrt(product(apart, apart) / product(slower, slower)));
  }
  return cycles;
}

void OilSettling::end_cycle(const std::vector<double>& oil) {
  moved_before_ = mixing_.moved();
  mixing_.add(begin_, oil);
}

std::optional<std::vector<double>> OilSettling::mixture() const {
  const bool is_slow = mixing_.can_mix() && mixing_.moved() > kFast * moved_before_;
  if (iteration_ != OilIteration::kMixed || !is_slow) return std::nullopt;
  return mixing_.mixture();
}

void OilSettling::begin_next_cycle(LinerFilm& liner, std::span<CycleRun* const> rings) {
  end_cycle(liner.mass_per_area());
  for (CycleRun* ring : rings) {
    ring->expect_oil_to_move(ahead(), mixing_.cycles_ahead());
    ring->compare_with_last_cycle();
  }
  if (!rings.front()->oil_repeats()) {
    if (std::optional<std::vector<double>> mixed = mixture()) {
      liner.replace(*std::move(mixed));
      for (CycleRun* ring : rings) ring->forget_last_cycle();
    }
  }
  begin(liner);
}

}  // namespace ringfilm::cycle
