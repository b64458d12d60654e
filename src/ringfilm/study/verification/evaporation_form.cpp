#include "ringfilm/study/verification/evaporation_form.hpp"

#include <cstddef>

#include "ringfilm/models/gas/heat_transfer.hpp"

namespace ringfilm::study {
namespace {

/// What remains of a film.
struct RemainingFilm {
  double mass_share;     ///< over the mass of the fresh film [-]
  double mole_fraction;  ///< mole fraction of the first fraction; 0 of a dry film [-]
};

RemainingFilm remaining_film(const EvaporationForm& form) {
  std::vector<double> moles, concentration;
  for (const models::OilFraction& fraction : form.fractions) {
    moles.push_back(form.mass * fraction.share / fraction.molar_mass_or_correlated());
    concentration.push_back(models::vapour_concentration(fraction.boiling_point, form.temperature));
  }
  models::evaporate(moles, concentration, form.mass_transfer_coefficient * form.time);
  double mass = 0, all = 0;
  for (std::size_t i = 0; i < moles.size(); ++i) {
    mass += moles[i] * form.fractions[i].molar_mass_or_correlated();
    all += moles[i];
  }
  return {mass / form.mass, all > 0 ? moles.front() / all : 0};
}

}  // namespace

const std::vector<cycle::Quantity>& evaporation_quantities() {
  static const std::vector<cycle::Quantity> all = {
      {"vapour_pressure", "Pa", "Pa", "vapour pressure", "p_v", "eq-vapour-pressure"},
      {"molar_mass", "kg/mol", "g/mol", "molar mass of the boiling point", "M", "eq-molar-mass"},
      {"mass_left", "1", "1", "share of the film that remains", "", "eq-depletion"},
      {"mole_fraction", "1", "1", "mole fraction of the lightest fraction", "x_1", "eq-depletion"},
      {"noack_loss", "1", "1", "loss of mass in the Noack test", "", "eq-noack"},
      {"heat_transfer_coefficient", "W/(m2 K)", "W/(m2 K)", "heat transfer coefficient", "alpha", "eq-woschni"}};
  return all;
}

bool is_of_heat_transfer(const std::string& quantity) { return quantity == "heat_transfer_coefficient"; }

double evaporation_value(const EvaporationForm& form, const std::string& quantity) {
  if (is_of_heat_transfer(quantity)) {
    return models::woschni_coefficient(form.bore, form.pressure, form.temperature, form.velocity);
  }
  if (quantity == "vapour_pressure") {
    return models::vapour_pressure(form.fractions.front().boiling_point, form.temperature);
  }
  if (quantity == "molar_mass") return models::molar_mass_of_boiling_point(form.fractions.front().boiling_point);
  if (quantity == "noack_loss") return models::noack_loss(form.fractions);
  const RemainingFilm film = remaining_film(form);
  return quantity == "mass_left" ? film.mass_share : film.mole_fraction;
}

}  // namespace ringfilm::study
