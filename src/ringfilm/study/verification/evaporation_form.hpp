#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/models/oil/evaporation.hpp"

/// Laws of evaporation and of the transfer of heat at one state, with closed forms to compare with
/// (verification/oil_evaporation).
namespace ringfilm::study {

/// A film of oil that evaporates, or the state of a gas next to it. What a quantity does not use is 0.
struct EvaporationForm {
  std::vector<models::OilFraction> fractions;  ///< fractions of the fresh oil
  double temperature = 0;                      ///< temperature of the film, or of the gas [K]
  double mass_transfer_coefficient = 0;        ///< beta [m/s]
  double mass = 0;                             ///< mass of the film per area [kg/m2]
  double time = 0;                             ///< over which it evaporates [s]
  // gas in the cylinder
  double bore = 0;      ///< [m]
  double pressure = 0;  ///< [Pa]
  double velocity = 0;  ///< [m/s]
};

/// vapour_pressure and molar_mass of the first fraction; mass_left (share of the film after a time), mole_fraction (of
/// the first fraction then); noack_loss; heat_transfer_coefficient after Woschni.
const std::vector<cycle::Quantity>& evaporation_quantities();

/// Is it a quantity of the gas, not of a film?
bool is_of_heat_transfer(const std::string& quantity);

/// @param quantity one of evaporation_quantities() @returns [SI]
double evaporation_value(const EvaporationForm& form, const std::string& quantity);

}  // namespace ringfilm::study
