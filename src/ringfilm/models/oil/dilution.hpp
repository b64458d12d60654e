#pragma once

/// Oil that holds fuel or water (docs/theory/oil.md).
namespace ringfilm::models {

/// No liquid of a blend has less, where the rule ends [m2/s].
inline constexpr double kMinBlendedViscosity = 3e-7;

/// Kinematic viscosity of an oil with another liquid dissolved in it, at one temperature, by the viscosity blending
/// index of ASTM D7152 @cite astm_d7152 over shares of the mass, eq-blended-viscosity [m2/s]. Of no and of nothing but
/// the other liquid exactly that of oil and liquid.
/// @param oil @param liquid kinematic viscosities above kMinBlendedViscosity [m2/s] @param share mass share of the
/// liquid
double blended_viscosity(double oil, double liquid, double share);

/// Viscosity of an oil in which drops of water are dispersed, over that of the oil, for dilute emulsions
/// @cite taylor1932, eq-emulsion-viscosity [-]. @param volume share of the volume that is water @param water @param oil
/// viscosities [Pa s]
double emulsion_ratio(double volume, double water, double oil);

/// Viscosity of liquid water, Vogel's law, within 3 % from 0 to 150 degC [Pa s]. @param T [K]
double water_viscosity(double T);

/// Volume of water in the volume of an emulsion of that mass share [-]. @param oil_density [kg/m3]
double water_volume_share(double mass_share, double oil_density);

}  // namespace ringfilm::models
