#pragma once
#include <span>
#include <vector>

namespace ringfilm {

/// Linear interpolation of samples y at increasing x, continued with the slope of the nearest interval beyond the ends.
/// One sample alone is a constant. The unit is that of y.
double interpolate_linear(std::span<const double> x, std::span<const double> y, double at);

/// Cubic through all samples that stays monotone wherever they are, after Fritsch and Carlson; continued with the slope
/// of its end points. Continuous with its first derivative.
class MonotoneCubic {
 public:
  /// @param x increasing, two samples or more; @param y as many
  MonotoneCubic(std::vector<double> x, std::vector<double> y);

  struct ValueAndSlope {
    double value, slope;
  };
  ValueAndSlope at(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace ringfilm
