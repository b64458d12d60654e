#pragma once
#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas/mixture.hpp"

/// Composition of the charge before and after combustion, and when it burns (docs/theory/gas-composition.md).
namespace ringfilm::models {

/// `gas.composition.fuel`
enum class Fuel { kNone, kHydrogen, kMethane, kGasoline, kDiesel };

/// The species that a fuel is. Not defined for Fuel::kNone.
Species fuel_species(Fuel fuel);

/// "hydrogen", ...
const char* fuel_name(Fuel fuel);

/// Mass of dry air that burns a mass of fuel completely, eq-stoichiometry [-].
double stoichiometric_air_fuel_ratio(Fuel fuel);

/// Dry air, by mass.
Shares dry_air();

/// Air, fuel and moisture of a charge.
struct ChargeMixture {
  Fuel fuel = Fuel::kNone;
  double excess_air_ratio = 1;  ///< lambda [-]
  double premixed_share = 1;    ///< share of the fuel that is in the charge before it burns [-]
  double humidity = 0;          ///< water in the air, over its dry mass [-]
};

Shares humid_air(double humidity);  ///< by mass. @param humidity of ChargeMixture

/// Charge that has not burned, by mass, eq-fresh-charge.
Shares fresh_charge(const ChargeMixture& mixture);

/// Burnt gas by mass, eq-burnt-gas: carbon dioxide, water and what is left of air or fuel; no dissociation, and for
/// lambda < 1 the fuel that finds no oxygen remains.
Shares burnt_gas(const ChargeMixture& mixture);

/// `gas.composition.burn`: how the burnt share rises where the gas enters the ring pack.
enum class BurnLaw {
  kWiebe,  ///< the charge burns and is mixed at once
  kStep    ///< the flame arrives at the end of the combustion
};

/// When the charge burns, and what remains of it. Angles with 0 = firing TDC.
struct Burning {
  BurnLaw law = BurnLaw::kWiebe;
  double begin_deg = 0;       ///< begin of the combustion, -180 to 180 [degree]
  double duration_deg = 0;    ///< length of the combustion [degree]
  double residual_share = 0;  ///< burnt gas in the charge before it burns, by mass; above 0 [-]
};

/// Mass share of burnt gas in the cylinder, eq-burnt-share [-]. @param angle_deg any [degree]
double burnt_share(const Burning& burning, const CrankSlider& crank, double angle_deg);

}  // namespace ringfilm::models
