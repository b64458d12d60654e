#pragma once

/// Oils whose viscosity falls with the shear rate (docs/theory/flow-factors.md).
namespace ringfilm::models {

/// Law of viscosity against the shear rate g.
enum class ShearThinningLaw {
  kNone,    ///< none: a Newtonian oil
  kCross,   ///< R + (1 - R)/(1 + (g/g_c)^m)
  kCarreau  ///< R + (1 - R)(1 + (g/g_c)^2)^((n - 1)/2)
};

/// At which shear rate the viscosity at a high shear rate (HTHS) is measured: ASTM D4683 [1/s].
inline constexpr double kHthsShearRate = 1e6;
/// And at which temperature [K].
inline constexpr double kHthsTemperature = 423.15;

/// Viscosity over that without shear, eq-cross. Immutable.
struct ShearThinning {
  ShearThinningLaw law;     ///< kCross or kCarreau
  double second_newtonian;  ///< R: at the highest shear rates, above 0 to 1 [-]
  double exponent;          ///< m of Cross' law, n of Carreau's [-]

  /// @param rate g/g_c: the shear rate over the critical one [-]
  double ratio(double rate) const;
  /// Ratio of an oil under a shear stress: g^2 = slide^2 + (stress/eta)^2 with its own viscosity eta.
  /// @param slide part of g that is known, over g_c [-] @param stress over g_c and the viscosity without shear [-]
  double ratio(double slide, double stress) const;
  /// g/g_c at which the ratio is `ratio`, above R and below 1 [-].
  double rate(double ratio) const;
};

/// The exponent of a law where none is stated: 1 of Cross', 0.5 of Carreau's (assumed) [-].
double usual_exponent(ShearThinningLaw law);

}  // namespace ringfilm::models
