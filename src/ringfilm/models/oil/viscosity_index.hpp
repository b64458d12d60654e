#pragma once
#include <optional>

/// Viscosity index of petroleum products, ASTM D2270 @cite astm_d2270, eq-viscosity-index: the viscosity at 40 degC
/// compared with those, L and H, of two reference oils of the index 0 and 100 that have the same viscosity at 100 degC.
namespace ringfilm::models {

inline constexpr double kLowIndexTemperature = 313.15, kHighIndexTemperature = 373.15;  ///< 40 and 100 degC [K]
/// Viscosity at 100 degC where the practice begins [m2/s].
inline constexpr double kMinIndexedViscosity = 2e-6;
/// Highest index that is taken as one of an oil: the best base oils have about 160, improved oils up to 300 [-].
inline constexpr double kMaxViscosityIndex = 400;

/// Index of the kinematic viscosities at 40 and 100 degC [m2/s]; nothing below 2 mm2/s at 100 degC, or where the
/// viscosity does not fall.
std::optional<double> viscosity_index(double at_40, double at_100);

/// Kinematic viscosity at 40 degC [m2/s] of an oil with this one at 100 degC [m2/s]; nothing outside of the practice.
std::optional<double> viscosity_at_40(double at_100, double index);

/// Kinematic viscosity at 100 degC [m2/s] of an oil with this one at 40 degC [m2/s]; nothing outside of the practice.
std::optional<double> viscosity_at_100(double at_40, double index);

}  // namespace ringfilm::models
