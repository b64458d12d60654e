#pragma once
#include <optional>
#include <span>
#include <vector>

/// Evaporation of an oil of several fractions (docs/theory/oil-consumption.md).
namespace ringfilm::models {

/// A fraction of an oil by its boiling point.
struct OilFraction {
  double share = 0;                  ///< share of the mass of the fresh oil [-]
  double boiling_point = 0;          ///< T_b, at 1.01325 bar [K]
  std::optional<double> molar_mass;  ///< M; absent: molar_mass_of_boiling_point() [kg/mol]

  double molar_mass_or_correlated() const;  ///< M, stated or from the boiling point [kg/mol]
};

/// The boiling point at which molar_mass_of_boiling_point() ends [K].
inline constexpr double kMaxBoilingPoint = 1080;

/// Molar mass of a petroleum fraction, eq-molar-mass, after @cite riazi1996 [kg/mol].
/// @param boiling_point below kMaxBoilingPoint [K]
double molar_mass_of_boiling_point(double boiling_point);

/// Vapour pressure of a fraction, eq-vapour-pressure [Pa]. @param boiling_point at 1.01325 bar [K] @param T [K]
double vapour_pressure(double boiling_point, double T);

/// Vapour of a pure fraction next to its liquid, p_v/(R T) [mol/m3].
double vapour_concentration(double boiling_point, double T);

/// Evaporates a film into gas without vapour, by Raoult's law and in closed form, eq-depletion.
/// @param moles of each fraction on the area, at least 0; those that remain [mol/m2]
/// @param concentration of each pure fraction, vapour_concentration(), above 0 [mol/m3]
/// @param exposure integral of the mass transfer coefficient over time [m]
void evaporate(std::span<double> moles, std::span<const double> concentration, double exposure);

/// Least and largest Noack loss that distillation_of_noack() takes [-].
inline constexpr double kMinNoackLoss = 0.01, kMaxNoackLoss = 0.4;

/// Share of its mass that an oil loses in the Noack test (ASTM D5800: 250 degC, 1 h), eq-noack [-].
double noack_loss(std::span<const OilFraction> fractions);

/// Fractions of a typical engine oil with boiling points shifted together until they lose `loss` in the Noack test,
/// eq-noack; assumed. @param loss from kMinNoackLoss to kMaxNoackLoss [-]
std::vector<OilFraction> distillation_of_noack(double loss);

}  // namespace ringfilm::models
