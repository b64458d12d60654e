#include "ringfilm/models/gas/water_vapour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/models/gas/mixture.hpp"

namespace ringfilm::models {
namespace {

/// log10 p = A - B/(C + t), p in mmHg, t in degC.
struct AntoineConstants {
  double A, B, C;
};
/// 1 to 100 degC, and 99 to 374 degC; they meet at 108 degC.
constexpr std::array<AntoineConstants, 2> kWater{{{8.07131, 1730.63, 233.426}, {8.14019, 1810.94, 244.485}}};
constexpr double kMercury = 101325.0 / 760;  // [Pa/mmHg]

double antoine_pressure(const AntoineConstants& of, double T) {
  return kMercury * std::pow(10, of.A - of.B / (of.C + T - base::kZeroCelsius));
}

double antoine_temperature(const AntoineConstants& of, double p) {
  return of.B / (of.A - std::log10(p / kMercury)) - of.C + base::kZeroCelsius;
}

}  // namespace

double water_saturation_pressure(double T) {
  return std::min(antoine_pressure(kWater[0], T), antoine_pressure(kWater[1], T));
}

std::optional<double> dew_point(double p) {
  if (!(p > water_saturation_pressure(kColdestWater))) return std::nullopt;
  if (p >= water_saturation_pressure(kHottestWater)) return kHottestWater;
  return std::max(antoine_temperature(kWater[0], p), antoine_temperature(kWater[1], p));
}

double condensable_water(double water, double molar_mass_of_gas, double p, double wall) {
  const double saturated = water_saturation_pressure(std::clamp(wall, kColdestWater, kHottestWater)) / p;
  if (saturated >= 1) return 0;
  const double M_w = molar_mass(Species::kWater);
  const double dry_moles = 1 / molar_mass_of_gas - water / M_w;
  return std::max(water - M_w * dry_moles * saturated / (1 - saturated), 0.0);
}

}  // namespace ringfilm::models
