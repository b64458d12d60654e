#pragma once

namespace ringfilm::base {

/// Standard atmosphere: the zero of gauge pressures and the reference of the density law [Pa].
inline constexpr double kAtmosphere = 101325;

/// Zero of the Celsius scale [K].
inline constexpr double kZeroCelsius = 273.15;

/// Molar gas constant [J/(mol K)].
inline constexpr double kMolarGasConstant = 8.314462618;

/// The four-stroke cycle in crank angle [degree].
inline constexpr double kCycleDeg = 720;

}  // namespace ringfilm::base
