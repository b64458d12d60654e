#pragma once
#include <vector>

/// A smooth line through a noisy trace whose stiffness is a wavelength.
namespace ringfilm::surface {

/// Cubic spline with a knot at every point, eq-face-spline @cite reinsch1967: straight beyond its ends.
class SmoothingSpline {
 public:
  /// @param cutoff_m wavelength of which half the amplitude is let through [m]; longer ones pass, shorter ones do not
  /// Throws InputError for less than 8 points, places that do not rise, NaN, and a cut-off below four mean steps (it
  /// would follow the noise) or beyond the length of the trace.
  SmoothingSpline(std::vector<double> x_m, const std::vector<double>& height_m, double cutoff_m);

  const std::vector<double>& x_m() const { return x_m_; }
  const std::vector<double>& height_m() const { return height_m_; }  ///< at the points [m]
  double height_m(double x) const;                                   ///< between them [m]

  /// Standard error of the spline at x over that of a single point, eq-face-error, for noise without memory and an even
  /// grid; doubled towards the ends, where the spline has points on one side only.
  double error_share(double x) const;

 private:
  std::vector<double> x_m_, height_m_, curvature_;  ///< curvature: second derivative at the points [1/m]
  double cutoff_m_;
};

}  // namespace ringfilm::surface
