#include "ringfilm/models/gas/charge_mixture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ringfilm/base/constants.hpp"

namespace ringfilm::models {
namespace {

/// Atoms in a molecule of fuel.
struct FuelFormula {
  const char* name;
  Species species;
  double carbon, hydrogen;  ///< atoms [-]
};

/// In the order of Fuel, without kNone. Gasoline and diesel fuel after heywood1988, table D.4.
constexpr std::array<FuelFormula, 4> kFuels{{{"hydrogen", Species::kHydrogen, 0, 2},
                                             {"methane", Species::kMethane, 1, 4},
                                             {"gasoline", Species::kGasoline, 7.92, 14.81},
                                             {"diesel", Species::kDiesel, 12.3, 22.14}}};

/// Mole shares of dry air: nitrogen, oxygen, argon, carbon dioxide.
constexpr std::array<double, 4> kAirMoles{0.78084, 0.20946, 0.00934, 0.00036};

constexpr double kWiebeEfficiency = 6.907755278982137;  // ln 1000: 99.9 % at the end before it is made 1 [-]
constexpr double kWiebePower = 3;                       // form exponent 2, plus 1 [-]

const FuelFormula& formula(Fuel fuel) { return kFuels[static_cast<std::size_t>(fuel) - 1]; }

double oxygen_per_mole(const FuelFormula& fuel) { return fuel.carbon + fuel.hydrogen / 4; }

Shares normalised(Shares masses) {
  double sum = 0;
  for (const double one : masses) sum += one;
  for (double& one : masses) one /= sum;
  return masses;
}

/// Share of the combustion that is over.
double burned(const Burning& burning, double since_begin) {
  const double share = since_begin / burning.duration_deg;
  if (burning.law == BurnLaw::kStep || share >= 1) return share >= 1 ? 1 : 0;
  if (share <= 0) return 0;
  return -std::expm1(-kWiebeEfficiency * std::pow(share, kWiebePower)) / -std::expm1(-kWiebeEfficiency);
}

}  // namespace

Species fuel_species(Fuel fuel) { return formula(fuel).species; }

const char* fuel_name(Fuel fuel) { return fuel == Fuel::kNone ? "none" : formula(fuel).name; }

double stoichiometric_air_fuel_ratio(Fuel fuel) {
  const FuelFormula& of = formula(fuel);
  const double oxygen = oxygen_per_mole(of) * molar_mass(Species::kOxygen);
  return oxygen / share(dry_air(), Species::kOxygen) / molar_mass(of.species);
}

Shares dry_air() {
  Shares masses{};
  constexpr std::array kOf{Species::kNitrogen, Species::kOxygen, Species::kArgon, Species::kCarbonDioxide};
  for (std::size_t i = 0; i < kOf.size(); ++i) share(masses, kOf[i]) = kAirMoles[i] * molar_mass(kOf[i]);
  return normalised(masses);
}

Shares humid_air(double humidity) {
  Shares masses = dry_air();
  share(masses, Species::kWater) += humidity;
  return normalised(masses);
}

Shares fresh_charge(const ChargeMixture& mixture) {
  Shares masses = dry_air();
  share(masses, Species::kWater) += mixture.humidity;
  share(masses, fuel_species(mixture.fuel)) +=
      mixture.premixed_share / (mixture.excess_air_ratio * stoichiometric_air_fuel_ratio(mixture.fuel));
  return normalised(masses);
}

Shares burnt_gas(const ChargeMixture& mixture) {
  const FuelFormula& of = formula(mixture.fuel);
  Shares masses = dry_air();
  share(masses, Species::kWater) += mixture.humidity;
  const double ratio = stoichiometric_air_fuel_ratio(mixture.fuel);
  const double fuel = 1 / (mixture.excess_air_ratio * ratio), burns = std::min(fuel, 1 / ratio);
  const double moles = burns / molar_mass(of.species);
  double& oxygen = share(masses, Species::kOxygen);
  oxygen = std::max(oxygen - moles * oxygen_per_mole(of) * molar_mass(Species::kOxygen), 0.0);
  share(masses, Species::kCarbonDioxide) += moles * of.carbon * molar_mass(Species::kCarbonDioxide);
  share(masses, Species::kWater) += moles * of.hydrogen / 2 * molar_mass(Species::kWater);
  share(masses, of.species) += fuel - burns;
  return normalised(masses);
}

double burnt_share(const Burning& burning, const CrankSlider& crank, double angle_deg) {
  const double angle = std::remainder(angle_deg, base::kCycleDeg);  // firing TDC in the middle
  const double residual = burning.residual_share;
  constexpr double kIntakeEnds = -base::kCycleDeg / 4;
  if (angle < kIntakeEnds && angle < burning.begin_deg) {
    const double filled = crank.position(angle * std::numbers::pi / 180) / crank.stroke();
    return residual / (residual + (1 - residual) * std::clamp(filled, 0.0, 1.0));
  }
  return residual + (1 - residual) * burned(burning, angle - burning.begin_deg);
}

}  // namespace ringfilm::models
