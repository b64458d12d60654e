#include "ringfilm/models/flash_temperature.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>

namespace ringfilm::models {
namespace {

/// e^x K_n(x) for large x, by its asymptotic series.
double scaled_bessel_k(int order, double x) {
  double term = 1, sum = 1;
  for (int k = 1; k <= 12; ++k) {
    term *= (4.0 * order * order - (2 * k - 1) * (2 * k - 1)) / (k * 8 * x);
    sum += term;
  }
  return std::sqrt(boost::math::constants::half_pi<double>() / x) * sum;
}

/// Mean rise in units of 2 kappa q/(pi k U), at x = U b/(2 kappa).
double mean_rise(double x) {
  constexpr double kSmall = 1e-3, kLarge = 30;  // beyond these the closed form loses digits, or overflows
  if (x < kSmall) return x * (1.5 - boost::math::constants::euler<double>() - std::log(0.5 * x));
  double k_0, k_1;  // e^x K_0, e^x K_1
  if (x > kLarge) {
    k_0 = scaled_bessel_k(0, x);
    k_1 = scaled_bessel_k(1, x);
  } else {
    k_0 = std::exp(x) * boost::math::cyl_bessel_k(0, x);
    k_1 = std::exp(x) * boost::math::cyl_bessel_k(1, x);
  }
  const double decay = std::exp(-2 * x);
  return 2 * x / 3 * (k_0 + k_1 + decay * (k_0 - k_1)) + (1 + decay) * k_1 / 3 - 2 / (3 * x);
}

}  // namespace

double flash_temperature(double heat_flux, double width, double speed, const HeatedSolid& solid) {
  const double diffusivity = solid.conductivity / (solid.density * solid.specific_heat);
  const double x = speed * width / (2 * diffusivity);
  if (heat_flux == 0 || x == 0) return 0;
  return heat_flux * width * mean_rise(x) / (boost::math::constants::pi<double>() * solid.conductivity * x);
}

}  // namespace ringfilm::models
