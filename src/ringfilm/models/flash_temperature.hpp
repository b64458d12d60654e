#pragma once

namespace ringfilm::models {

/// A solid that heat flows into.
struct HeatedSolid {
  double conductivity;   ///< k [W/(m K)]
  double density;        ///< rho [kg/m3]
  double specific_heat;  ///< c [J/(kg K)]
};

/// Mean rise of the surface temperature of a half-space under a band of uniform heat that slides on it at constant
/// speed, once the temperature moves along with the band; eq-flash-temperature, after Jaeger @cite jaeger1942 [K].
/// 0 at rest, where the heat of friction is.
/// @param heat_flux into the solid [W/m2] @param width of the band along the motion [m] @param speed modulus [m/s]
double flash_temperature(double heat_flux, double width, double speed, const HeatedSolid& solid);

}  // namespace ringfilm::models
