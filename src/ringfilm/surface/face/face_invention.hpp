#pragma once
#include <vector>

#include "ringfilm/surface/face/face_fit.hpp"

namespace ringfilm::surface {

/// What a polynomial has that its trace has not, and the other way round. The difference of both is smoothed, not the
/// trace: where the polynomial is right nothing but noise is left, whatever the shape, and the spline adds no bias.
class Departure {
 public:
  Departure(const Trace& gap, const FacePolynomial& polynomial, double cutoff_m);

  double noise_m() const { return noise_m_; }  ///< rms of what neither follows [m]
  std::vector<FitArtifact> invented() const;   ///< from x = 0 on

 private:
  double error_m(double x) const;  ///< standard error of the smoothed difference [m]
  double traced_m(double x) const { return polynomial_.height_m(x) + spline_.height_m(x); }
  void append_departures(std::vector<FitArtifact>& all) const;
  void append_turns(std::vector<FitArtifact>& all) const;

  const FacePolynomial& polynomial_;
  SmoothingSpline spline_;
  double noise_m_ = 0;
  double memory_ = 1;        ///< by how much correlated neighbours widen the error, as a variance
  double polynomial_m_ = 0;  ///< standard error of the polynomial [m]
};

}  // namespace ringfilm::surface
