#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ringfilm::cycle {

/// What lies between the samples of a cycle: of any quantity a cubic from sample to sample with the slopes of the
/// parabolas through a sample and its neighbours, eq-between-samples. At a dead centre, where curves have kinks, the
/// slope of each side is that of its own stroke. Where a step holds a dead centre, or a stroke has fewer than three
/// samples, it is a straight line. A quantity that is above zero and changes by factors between samples is passed as
/// its logarithm, so that its curve stays above zero.
class BetweenSamples {
 public:
  /// @param crank_angle_deg of the samples, increasing, within one cycle [degree]
  explicit BetweenSamples(std::vector<double> crank_angle_deg);

  std::size_t size() const { return angle_.size(); }

  /// Weights of the samples in the integral over a stroke, 0 ... 3 from firing TDC, over the crank angle [degree]. A
  /// step that a dead centre divides belongs to the stroke that has its middle.
  const std::vector<double>& weights(int stroke) const { return weight_[static_cast<std::size_t>(stroke)]; }

  /// Mean over the cycle. @param value of sample k
  template <class Value>
  double mean(const Value& value) const {
    double sum = 0;
    for (std::size_t k = 0; k < size(); ++k) sum += mean_weight_[k] * value(k);
    return sum;
  }

  /// A value at a crank angle in [0, 720) [degree].
  struct Place {
    double value, angle_deg;
  };
  /// The highest place of the cubics on both sides of sample k, which is at least that of the sample.
  template <class Value>
  Place largest_near(std::size_t k, const Value& value) const {
    const std::size_t before = this->before(k);
    const Place left = highest(before, cubic(before, value)), right = highest(k, cubic(k, value));
    const Place here{value(k), angle_[k]};
    const Place& higher = left.value > right.value ? left : right;
    return higher.value > here.value ? higher : here;
  }

  /// At a crank angle [degree].
  template <class Value>
  double at(double crank_angle_deg, const Value& value) const {
    const std::size_t k = interval_of(crank_angle_deg);
    return cubic(k, value).at(share_of(k, crank_angle_deg));
  }

 private:
  /// The weights of up to three samples in a slope [1/degree].
  struct Slope {
    std::array<std::size_t, 3> sample;
    std::array<double, 3> weight;
    bool is_extrapolated = false;  ///< beyond samples that are all on one side of the place
    template <class Value>
    double of(const Value& value) const {
      return weight[0] * value(sample[0]) + weight[1] * value(sample[1]) + weight[2] * value(sample[2]);
    }
  };
  /// Largest slope of a cubic at an end of its step, in rises over this step or the one beyond: up to 3 a cubic is
  /// monotone.
  static constexpr double kMaxSlope = 3;
  /// Over one step, by the share of the step that has passed.
  struct Cubic {
    double c_0, c_1, c_2, c_3;
    double at(double share) const { return c_0 + share * (c_1 + share * (c_2 + share * c_3)); }
  };

  std::size_t before(std::size_t k) const { return k == 0 ? size() - 1 : k - 1; }
  std::size_t after(std::size_t k) const { return k + 1 == size() ? 0 : k + 1; }
  template <class Value>
  Cubic cubic(std::size_t k, const Value& value) const {
    const std::size_t next = after(k);
    const double a = value(k), b = value(next), rise = b - a, length = length_[k];
    // Next to a jump the slope of the parabola would overshoot on the side without the jump. An extrapolated slope, as
    // next to a dead centre, may come from a jump one step away: the rise over its own step limits it.
    const double rise_before = (a - value(before(k))) * length / length_[before(k)];
    const double rise_after = (value(after(next)) - b) * length / length_[next];
    const auto slope = [&](const Slope& at, double rise_beyond) {
      return limited(length * at.of(value), rise, at.is_extrapolated ? 0 : rise_beyond);
    };
    const double from = slope(slope_from_[k], rise_after), to = slope(slope_to_[k], rise_before);
    return {a, from, 3 * rise - 2 * from - to, -2 * rise + from + to};
  }
  static double limited(double slope, double rise, double rise_beyond) {
    const double most = kMaxSlope * std::max(std::abs(rise), std::abs(rise_beyond));
    return std::clamp(slope, -most, most);
  }
  Place highest(std::size_t k, const Cubic& cubic) const;
  std::size_t interval_of(double crank_angle_deg) const;
  double share_of(std::size_t k, double crank_angle_deg) const;
  bool is_smooth(std::size_t k) const;
  Slope parabola(std::size_t first, double at) const;
  Slope secant(std::size_t k) const;
  void set_slopes();
  void set_weights();

  double cycle_;                               ///< length of the cycle [degree]
  std::vector<double> angle_;                  ///< [degree]
  std::vector<double> length_;                 ///< length of the step from sample k to the next one [degree]
  std::vector<Slope> slope_from_, slope_to_;   ///< at the begin and at the end of that step
  std::array<std::vector<double>, 4> weight_;  ///< [degree]
  std::vector<double> mean_weight_;            ///< [-]
};

}  // namespace ringfilm::cycle
