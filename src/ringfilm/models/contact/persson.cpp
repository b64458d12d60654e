#include "ringfilm/models/contact/persson.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ringfilm::models {

double persson_area(double p, double E_star_slope) { return std::erf(std::numbers::sqrt2 * p / E_star_slope); }

PerssonArea persson_area(double p, double E_star_slope, double hardness) {
  constexpr double kNegligible = 45;  // exponent beyond which terms of the series are negligible
  const double x = p / hardness, spread = E_star_slope * E_star_slope / (8 * hardness * hardness);
  if (!(x > 0)) return {0, 0};
  const double decay = std::numbers::pi * std::numbers::pi * spread;
  // Series of the diffusion of pressure between 0 and the hardness: without spread it is a sum that does not converge,
  // and the contact elastic.
  if (decay < 1e-5) return {persson_area(p, E_star_slope), 0};
  double at_hardness = x, lost = 1 - x;
  for (int n = 1; n * n * decay < kNegligible; ++n) {
    const double term = 2 / (std::numbers::pi * n) * std::sin(n * std::numbers::pi * x) * std::exp(-n * n * decay);
    at_hardness += n % 2 == 0 ? term : -term;
    lost -= term;
  }
  const double plastic = std::clamp(at_hardness, 0.0, 1.0);
  return {std::clamp(1 - plastic - lost, 0.0, 1.0), plastic};
}

}  // namespace ringfilm::models
