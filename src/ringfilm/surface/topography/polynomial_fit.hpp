#pragma once
#include <Eigen/Core>
#include <span>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// A smooth form and its derivatives at the centre of a map [m, -, 1/m].
struct FormAtCentre {
  double value = 0, slope_x = 0, slope_y = 0, curve_xx = 0, curve_xy = 0, curve_yy = 0;
};

/// A polynomial in x and y as a sum of products of Legendre polynomials in places scaled to -1..1.
class PolynomialForm {
 public:
  PolynomialForm(const HeightMap& map, Eigen::MatrixXd coefficients);

  /// Its heights in a row of the map [m].
  void row(std::size_t j, std::span<double> heights) const;
  FormAtCentre at_centre() const;

 private:
  std::size_t points_x_, points_y_;
  double half_x_m_, half_y_m_;
  Eigen::MatrixXd coefficients_;  // (power of x, power of y)
};

/// Least squares of a polynomial whose powers of x and y sum up to `degree` at most.
/// @throws InputError where the measured points do not determine it
PolynomialForm fit_polynomial(const HeightMap& map, int degree);

}  // namespace ringfilm::surface
