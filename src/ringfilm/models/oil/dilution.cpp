#include "ringfilm/models/oil/dilution.hpp"

#include <cmath>

namespace ringfilm::models {
namespace {

constexpr double kUnit = 1e6;          // the index takes mm2/s
constexpr double kIndexShift = 0.8;    // [mm2/s]
constexpr double kWaterDensity = 970;  // at 80 degC; 2 % either way from 20 to 120 degC [kg/m3]

double blending_index(double nu) { return std::log(std::log(nu * kUnit + kIndexShift)); }

}  // namespace

double blended_viscosity(double oil, double liquid, double share) {
  if (share == 0) return oil;
  if (share == 1) return liquid;
  const double index = (1 - share) * blending_index(oil) + share * blending_index(liquid);
  return (std::exp(std::exp(index)) - kIndexShift) / kUnit;
}

double emulsion_ratio(double volume, double water, double oil) {
  return 1 + 2.5 * volume * (water + 0.4 * oil) / (water + oil);
}

double water_viscosity(double T) { return 2.414e-5 * std::pow(10, 247.8 / (T - 140)); }

double water_volume_share(double mass_share, double oil_density) {
  const double water = mass_share / kWaterDensity;
  return water / (water + (1 - mass_share) / oil_density);
}

}  // namespace ringfilm::models
