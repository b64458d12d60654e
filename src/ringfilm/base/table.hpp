#pragma once
#include <span>
#include <vector>

namespace ringfilm {

/// Linear interpolation of samples y at increasing x, continued with the slope of the nearest interval beyond the ends.
/// One sample alone is a constant; throws InputError unless there are as many x as y. The unit is that of y.
double interpolate_linear(std::span<const double> x, std::span<const double> y, double at);

/// Piecewise cubic through all samples that is monotone wherever they are, after Fritsch and Carlson. Beyond its end
/// points it continues with the slope there. Continuous with its first derivative.
class MonotoneCubic {
 public:
  /// @param x increasing, two samples or more; @param y as many, or InputError
  MonotoneCubic(std::vector<double> x, std::vector<double> y);

  struct ValueAndSlope {
    double value, slope;
  };
  ValueAndSlope at(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

/// Cubic from one point to another that leaves and arrives with given slopes, as far as it stays monotone with them:
/// a slope against the way is taken as zero, one of over three times the secant as three times the secant.
class MonotoneBlend {
 public:
  struct End {
    double x, y, slope;
  };
  /// @param from, to with from.x < to.x
  MonotoneBlend(const End& from, const End& to);

  double at(double x) const;  ///< within the two ends

 private:
  End from_, to_;
};

}  // namespace ringfilm
