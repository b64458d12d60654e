#include "ringfilm/cycle/setup/contact_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/models/contact/summit_contact.hpp"

namespace ringfilm::cycle {

bool is_closed_form(const Contact& contact) {
  return contact.model == ContactLaw::kGreenwoodTripp && contact.asperity == AsperityLaw::kElastic &&
         contact.summit_plane == SummitPlane::kSurface && contact.moments == ContactMoments::kPair;
}

namespace {

const double kRqOverRa = std::sqrt(std::numbers::pi / 2);

models::ContactModel summit_model(ContactLaw law) {
  switch (law) {
    case ContactLaw::kGreenwoodWilliamson:
      return models::ContactModel::kGreenwoodWilliamson;
    case ContactLaw::kBushGibsonThomas:
      return models::ContactModel::kBushGibsonThomas;
    case ContactLaw::kPlastic:
      return models::ContactModel::kPlastic;
    case ContactLaw::kGreenwoodTripp:
    case ContactLaw::kTable:
      break;
  }
  return models::ContactModel::kGreenwoodTripp;
}

/// The table of the case, moved and scaled as it states. Rows that move to 0 or below are omitted.
std::shared_ptr<const models::AsperityContact> measured_contact(const Contact& contact) {
  models::ContactTable rows;
  for (std::size_t k = 0; k < contact.law->rows.h.size(); ++k) {
    const double h = contact.law->rows.h[k] + contact.law_shift;
    if (!(h > 0)) continue;
    rows.h.push_back(h);
    rows.pressure.push_back(contact.law_factor * contact.law->rows.pressure[k]);
    rows.area_share.push_back(contact.law_factor * contact.law->rows.area_share[k]);
  }
  if (rows.h.size() < std::min(contact.law->rows.h.size(), models::TabulatedContact::kMinRows)) {
    throw InputError("contact.law_shift moves all of contact.law but " + std::to_string(rows.h.size()) +
                         " of its rows to separations below 0",
                     "state a shift of less than its separations");
  }
  return std::make_shared<models::TabulatedContact>(rows, contact.law->last_supported_separation + contact.law_shift);
}

}  // namespace

double composite_modulus(const Case& c) {
  if (c.contact.model == ContactLaw::kTable) return c.contact.law->composite_modulus;
  if (c.contact.composite_modulus) return *c.contact.composite_modulus;
  const Coating& coating = c.ring.coating;
  const bool of_coating = coating.youngs_modulus && coating.contact_modulus == ContactModulus::kCoating;
  const double E_1 = of_coating ? *coating.youngs_modulus : c.ring.youngs_modulus;
  const double nu_1 = of_coating ? coating.poissons_ratio : c.ring.poissons_ratio;
  return models::composite_modulus(E_1, nu_1, c.liner.youngs_modulus, c.liner.poissons_ratio);
}

double roughness(const Case& c) {
  if (c.contact.model == ContactLaw::kTable) return c.contact.law->composite_roughness;
  return c.contact.roughness * (c.contact.roughness_measure == RoughnessMeasure::kRaToRq ? kRqOverRa : 1.0);
}

std::optional<models::GreenwoodTripp::Parameters> asperities(const Case& c) {
  if (c.contact.model == ContactLaw::kTable) return std::nullopt;
  using Form = models::ContactIntegralForm;
  const Form form = c.contact.integrals == ContactIntegrals::kExact              ? Form::kExact
                    : c.contact.integrals == ContactIntegrals::kPolynomial4Digit ? Form::kPolynomial4Digit
                                                                                 : Form::kPolynomialAsPrinted;
  return models::GreenwoodTripp::Parameters{c.contact.asperity_density, c.contact.asperity_radius, roughness(c),
                                            composite_modulus(c), form};
}

std::shared_ptr<const models::AsperityContact> asperity_contact(const Case& c) {
  const Contact& contact = c.contact;
  if (contact.model == ContactLaw::kTable) {
    return measured_contact(contact);
  }
  const models::GreenwoodTripp::Parameters pair = *asperities(c);
  if (is_closed_form(contact)) return std::make_shared<models::GreenwoodTripp>(pair);
  models::SummitContactChoice choice;
  choice.model = summit_model(contact.model);
  choice.asperity = contact.asperity;
  choice.plane = contact.summit_plane;
  choice.moments = contact.moments;
  choice.hardness = contact.hardness.value_or(0);
  choice.nu = c.liner.poissons_ratio;
  const models::ContactTable table = tabulated(models::summit_contact(pair, choice), pair.sigma);
  return std::make_shared<models::TabulatedContact>(table, table.h.back());
}

}  // namespace ringfilm::cycle
