#include "ringfilm/cycle/between_samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

constexpr double kStrokeDeg = 180;
/// Angles closer than this are the same [degree].
constexpr double kSameAngle = 1e-9;
/// Largest ratio of the lengths of neighbouring steps that a parabola joins.
constexpr double kMaxUnequal = 8;

}  // namespace

BetweenSamples::BetweenSamples(std::vector<double> crank_angle_deg)
    : cycle_(kCycleDeg), angle_(std::move(crank_angle_deg)) {
  length_.reserve(size());
  for (std::size_t k = 0; k < size(); ++k) {
    length_.push_back(k + 1 < size() ? angle_[k + 1] - angle_[k] : angle_[0] + cycle_ - angle_[k]);
  }
  set_slopes();
  set_weights();
}

/// Whether the step after sample k holds no dead centre.
bool BetweenSamples::is_smooth(std::size_t k) const {
  const double next = kStrokeDeg * (std::floor((angle_[k] + kSameAngle) / kStrokeDeg) + 1);
  return angle_[k] + length_[k] < next + kSameAngle;
}

BetweenSamples::Slope BetweenSamples::secant(std::size_t k) const {
  return {{k, after(k), k}, {-1 / length_[k], 1 / length_[k], 0}, false};
}

/// Slope of the parabola through `first` and the two samples after it. @param at distance from the first one [degree]
BetweenSamples::Slope BetweenSamples::parabola(std::size_t first, double at) const {
  const std::size_t second = after(first);
  const double x_1 = length_[first], x_2 = x_1 + length_[second];
  return {
      {first, second, after(second)},
      {(2 * at - x_1 - x_2) / (x_1 * x_2), (2 * at - x_2) / (x_1 * (x_1 - x_2)), (2 * at - x_1) / (x_2 * (x_2 - x_1))},
      at != x_1};
}

void BetweenSamples::set_slopes() {
  // Does a parabola go through the ends of step k and of the one after it? Of very unequal steps the shorter one shows
  // the iteration's rounding.
  const auto joins_next = [this](std::size_t k) {
    const double end = angle_[k] + length_[k], next = length_[after(k)];
    const bool at_dead_centre = std::abs(end - kStrokeDeg * std::floor(end / kStrokeDeg + 0.5)) < kSameAngle;
    const bool is_alike = std::max(length_[k], next) <= kMaxUnequal * std::min(length_[k], next);
    return size() > 2 && is_alike && is_smooth(k) && is_smooth(after(k)) && !at_dead_centre;
  };
  slope_from_.reserve(size());
  slope_to_.reserve(size());
  for (std::size_t k = 0; k < size(); ++k) {
    const bool with_before = joins_next(before(k)), with_next = joins_next(k);
    const double end = length_[k];
    if (with_before) {
      slope_from_.push_back(parabola(before(k), length_[before(k)]));
    } else {
      slope_from_.push_back(with_next ? parabola(k, 0) : secant(k));
    }
    if (with_next) {
      slope_to_.push_back(parabola(k, end));
    } else {
      slope_to_.push_back(with_before ? parabola(before(k), length_[before(k)] + end) : secant(k));
    }
  }
}

/// The integral of a cubic over its step: that of the straight line, and the difference of its slopes.
void BetweenSamples::set_weights() {
  for (std::vector<double>& of_stroke : weight_) of_stroke.assign(size(), 0.0);
  for (std::size_t k = 0; k < size(); ++k) {
    const double middle = std::fmod(angle_[k] + 0.5 * length_[k], cycle_);
    std::vector<double>& weight = weight_[std::min<std::size_t>(static_cast<std::size_t>(middle / kStrokeDeg), 3)];
    weight[k] += 0.5 * length_[k];
    weight[after(k)] += 0.5 * length_[k];
    const double share = length_[k] * length_[k] / 12;
    for (int i = 0; i < 3; ++i) {
      weight[slope_from_[k].sample[i]] += share * slope_from_[k].weight[i];
      weight[slope_to_[k].sample[i]] -= share * slope_to_[k].weight[i];
    }
  }
  mean_weight_.assign(size(), 0.0);
  for (std::size_t k = 0; k < size(); ++k) {
    for (const std::vector<double>& of_stroke : weight_) mean_weight_[k] += of_stroke[k] / cycle_;
  }
}

BetweenSamples::Place BetweenSamples::highest(std::size_t k, const Cubic& cubic) const {
  // Its slope is c_1 + 2 c_2 s + 3 c_3 s^2, and falls at a maximum.
  const double root = cubic.c_2 * cubic.c_2 - 3 * cubic.c_1 * cubic.c_3;
  double share = cubic.at(1) > cubic.at(0) ? 1 : 0;
  if (root > 0) {
    const double below = -cubic.c_2 + std::sqrt(root);
    const double top = below > 0 ? cubic.c_1 / below : 2;
    if (top > 0 && top < 1 && cubic.at(top) > cubic.at(share)) share = top;
  }
  return {cubic.at(share), std::fmod(angle_[k] + share * length_[k], cycle_)};
}

std::size_t BetweenSamples::interval_of(double crank_angle_deg) const {
  const auto next = std::upper_bound(angle_.begin(), angle_.end(), crank_angle_deg);
  return next == angle_.begin() ? size() - 1 : static_cast<std::size_t>(next - angle_.begin()) - 1;
}

double BetweenSamples::share_of(std::size_t k, double crank_angle_deg) const {
  const double passed = crank_angle_deg - angle_[k];
  return (passed < 0 ? passed + cycle_ : passed) / length_[k];
}

}  // namespace ringfilm::cycle
