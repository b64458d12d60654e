#pragma once
#include <optional>

#include "ringfilm/base/constants.hpp"

namespace ringfilm::models {

/// Temperatures between which the pressure of saturated water holds [K].
inline constexpr double kColdestWater = base::kZeroCelsius, kHottestWater = 647;

/// Pressure of saturated water vapour by Antoine's equation @cite antoine1888 with two sets of constants, that of 1 to
/// 100 degC and that of 99 to 374 degC, of which the smaller value counts, eq-antoine [Pa].
/// @param T from kColdestWater to kHottestWater [K]
double water_saturation_pressure(double T);

/// Temperature at which water vapour of that partial pressure is saturated [K]; nothing below kColdestWater; at the
/// most kHottestWater. @param p partial pressure of the water [Pa]
std::optional<double> dew_point(double p);

/// Mass of water above saturation in a gas at a wall, over the mass of the gas, eq-condensable-water [-].
/// @param water mass share of water in the gas @param molar_mass of the gas with its water [kg/mol] @param p [Pa]
/// @param wall temperature of the wall [K]
double condensable_water(double water, double molar_mass, double p, double wall);

}  // namespace ringfilm::models
