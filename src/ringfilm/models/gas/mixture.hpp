#pragma once
#include <array>
#include <cstddef>

namespace ringfilm::models {

/// A component of the gas in an engine.
enum class Species {
  kNitrogen,
  kOxygen,
  kArgon,
  kCarbonDioxide,
  kWater,
  kHydrogen,
  kMethane,
  kGasoline,  ///< vapour of a mean molecule of gasoline
  kDiesel     ///< vapour of a mean molecule of diesel fuel
};
inline constexpr std::size_t kNSpecies = 9;

/// Share of each species, in the order of Species [-].
using Shares = std::array<double, kNSpecies>;

inline double& share(Shares& shares, Species of) { return shares[static_cast<std::size_t>(of)]; }
inline double share(const Shares& shares, Species of) { return shares[static_cast<std::size_t>(of)]; }

/// Temperatures between which the heat capacities of the species hold [K].
inline constexpr double kColdestMixture = 250, kHottestMixture = 1000;

double molar_mass(Species of);  ///< [kg/mol]

/// Heat capacity of a species at constant pressure as an ideal gas, eq-species-heat [J/(kg K)]. @param T from
/// kColdestMixture to kHottestMixture [K]
double specific_heat(Species of, double T);

/// Viscosity of a species at low pressure by Sutherland's law @cite white2006, eq-sutherland [Pa s]. @param T [K]
double viscosity(Species of, double T);

/// Molar mass of a mixture, eq-mixture-mass [kg/mol]. @param mass mass shares, sum 1
double molar_mass(const Shares& mass);

/// Mole shares of a mixture. @param mass mass shares, sum 1
Shares mole_shares(const Shares& mass);

/// Properties of a gas that has one composition and one temperature.
struct MixtureProperties {
  double gas_constant = 0;         ///< R [J/(kg K)]
  double heat_capacity_ratio = 0;  ///< gamma [-]
  double viscosity = 0;            ///< mu [Pa s]
};

/// Gas constant by the mean molar mass, heat capacity weighted by mass, viscosity by Wilke's rule @cite wilke1950,
/// eq-mixture-mass, eq-mixture-heat, eq-wilke. That of a single species is the species' own.
/// @param mass mass shares, sum 1 @param T from kColdestMixture to kHottestMixture [K]
MixtureProperties mixture_properties(const Shares& mass, double T);

/// The mixture of two, by mass. @param second share of the second [-]
Shares mixed(const Shares& first, const Shares& other, double second);

}  // namespace ringfilm::models
