#include "ringfilm/models/oil/shear_thinning.hpp"

#include <cmath>

namespace ringfilm::models {

double ShearThinning::ratio(double rate) const {
  const double R = second_newtonian;
  if (law == ShearThinningLaw::kCross) {
    return R + (1 - R) / (1 + (exponent == 1 ? rate : std::pow(rate, exponent)));
  }
  return R + (1 - R) * std::pow(1 + rate * rate, 0.5 * (exponent - 1));
}

double ShearThinning::ratio(double slide, double stress) const {
  if (stress == 0) return ratio(slide);
  // From 1 down: a smaller viscosity makes the shear rate larger and the viscosity smaller again.
  constexpr int kMax = 500;
  constexpr double kEnough = 1e-13;
  double eta = 1;
  for (int k = 0; k < kMax; ++k) {
    const double by_pressure = stress / eta;
    const double next = ratio(std::sqrt(slide * slide + by_pressure * by_pressure));
    if (eta - next <= kEnough * eta) return next;
    eta = next;
  }
  return eta;
}

double ShearThinning::rate(double ratio) const {
  const double share = (ratio - second_newtonian) / (1 - second_newtonian);
  if (law == ShearThinningLaw::kCross) return std::pow(1 / share - 1, 1 / exponent);
  return std::sqrt(std::pow(share, 2 / (exponent - 1)) - 1);
}

double usual_exponent(ShearThinningLaw law) { return law == ShearThinningLaw::kCross ? 1.0 : 0.5; }

}  // namespace ringfilm::models
