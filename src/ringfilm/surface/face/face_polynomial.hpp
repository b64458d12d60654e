#pragma once
#include <utility>
#include <vector>

/// A polynomial through a trace, in the units of the ring's case.
namespace ringfilm::surface {

/// h = sum of coefficients[k] x^(degree - k), x in mm and h in um as in Table 4 of styles2014.
class FacePolynomial {
 public:
  FacePolynomial() = default;
  /// From its powers, highest first [um, mm], over the width [m].
  FacePolynomial(std::vector<double> coefficients_mm_um, double width_m)
      : coefficients_(std::move(coefficients_mm_um)), width_m_(width_m) {}

  /// Least squares over the length of the trace from 0 to `width_m`, eq-face-fit, in Legendre polynomials, which are
  /// independent of each other there; the powers come from them afterwards. Throws InputError for too few points.
  static FacePolynomial fit(const std::vector<double>& x_m, const std::vector<double>& height_m, double width_m,
                            int degree);

  double height_m(double x_m) const;  ///< from the powers, as a case evaluates them [m]
  double slope(double x_m) const;     ///< [-]
  /// Places between 0 and the width where it turns [m], rising.
  std::vector<double> turning_points_m() const;

  const std::vector<double>& coefficients_mm_um() const { return coefficients_; }  ///< highest power first
  double width_m() const { return width_m_; }

 private:
  std::vector<double> coefficients_;
  double width_m_ = 0;
};

}  // namespace ringfilm::surface
