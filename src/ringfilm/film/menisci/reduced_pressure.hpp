#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/models/oil/polynomial.hpp"

namespace ringfilm::film {

/// Pressure and density of an oil at one temperature over its reduced pressure Phi = int_0^p rho/eta dp
/// [kg/(m3 s)], eq-reduced-pressure: polynomials through Lobatto's points in pressure, linear beyond them. Where the
/// viscosity rises by much, they are those of ln(1 - c Phi), which follows a law that is exponential in pressure.
class ReducedPressure {
 public:
  /// Served from 0 to `high` [Pa], which the caller chooses near the highest pressure of the film: the polynomials
  /// leave 1e-6 of it at the most.
  ReducedPressure(const models::OilAtTemperature& oil, double high);

  /// Oil at a reduced pressure.
  struct Oil {
    double pressure;  ///< absolute [Pa]
    double slope;     ///< dp/dPhi = eta/rho [m2/s]
    double density;   ///< [kg/m3]
  };
  Oil at(double reduced) const {
    const double served = reduced < 0 ? 0 : reduced > reduced_high_ ? reduced_high_ : reduced;
    const double inner = curvature_ > 0 ? 1 / (1 - curvature_ * served) : 1;
    const double place = curvature_ > 0 ? std::log(inner) / curvature_ : served;
    const double t = (place - centre_) * inverse_half_width_;
    const auto p = models::polynomial_and_slope(pressure_, t);
    const double slope = p.slope * inverse_half_width_ * inner;
    return {p.value + slope * (reduced - served), slope, models::polynomial(density_, t)};
  }

  /// The same at many reduced pressures. @param pressure,slope,density as long as `reduced` at the least
  void at(std::span<const double> reduced, std::vector<double>& pressure, std::vector<double>& slope,
          std::vector<double>& density) const;

  /// The reduced pressure of a pressure [kg/(m3 s)].
  double of(double pressure) const;
  double high() const { return high_; }  ///< highest pressure that is served [Pa]

 private:
  static constexpr std::size_t kNodes = 9, kDensityNodes = 5;

  double high_, reduced_high_;                 ///< ends of the range of p and of Phi
  double curvature_ = 0;                       ///< c; 0: the polynomials are those of Phi itself
  double centre_, inverse_half_width_;         ///< middle and width of the range of the variable of the polynomials
  std::array<double, kNodes> pressure_;        ///< coefficients, lowest power first [Pa]
  std::array<double, kDensityNodes> density_;  ///< coefficients, lowest power first [kg/m3]
};

}  // namespace ringfilm::film
