#include "ringfilm/cycle/setup/contact_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/models/contact/summit_contact.hpp"

namespace ringfilm::cycle {

bool is_closed_form(const Contact& contact) {
  return contact.model == ContactLaw::kGreenwoodTripp && contact.asperity == AsperityLaw::kElastic &&
         contact.summit_plane == SummitPlane::kSurface && contact.moments == ContactMoments::kPair &&
         !contact.plateau.is_stated();
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

std::optional<models::PlateauCurve> plateau_curve(const Contact& contact) {
  const Plateau& plateau = contact.plateau;
  if (contact.model == ContactLaw::kTable || !plateau.is_stated()) return std::nullopt;
  // Of a curve that is stated in part, the rules report what is missing.
  if (plateau.Rpq && plateau.Rvq && plateau.Rmq) return models::PlateauCurve{*plateau.Rpq, *plateau.Rvq, *plateau.Rmq};
  if (!(plateau.Rk && plateau.Rpk && plateau.Rvk && plateau.Mr2)) return std::nullopt;
  return models::plateau_curve({*plateau.Rk, *plateau.Rpk, *plateau.Rvk, *plateau.Mr2});
}

std::optional<models::PlateauPlanes> plateau_planes(const Contact& contact) {
  const auto curve = plateau_curve(contact);
  if (!curve) return std::nullopt;
  models::PlateauPlanes planes = models::plateau_planes(*curve);
  planes.rms = contact.plateau.surface_roughness.value_or(planes.rms);
  const double raised = contact.plateau.offset.value_or(planes.plateau) - planes.plateau;
  planes.plateau += raised;
  planes.valleys += raised;
  return planes;
}

std::string roughness_keys(const Contact& contact) {
  return contact.plateau.is_stated() ? "[contact.plateau]" : "contact.roughness";
}

double plateau_offset(const Contact& contact) {
  const auto planes = plateau_planes(contact);
  return planes ? planes->plateau : 0;
}

Case without_plateau(Case c) {
  c.contact.roughness = roughness(c);
  c.contact.roughness_measure = RoughnessMeasure::kAsGiven;
  c.contact.ring_roughness_share = ring_roughness_share(c);
  c.contact.plateau = {};
  return c;
}

Case with_plateau_roughness(Case c, double Rpq) {
  const auto before = plateau_curve(c.contact);
  if (!before || before->Rpq == Rpq) return c;
  const models::PlateauCurve after{Rpq, before->Rvq, before->Rmq};
  const models::PlateauPlanes from = models::plateau_planes(*before), to = models::plateau_planes(after);
  Plateau plateau;
  plateau.Rpq = after.Rpq;
  plateau.Rvq = after.Rvq;
  plateau.Rmq = after.Rmq;
  plateau.ring_roughness = c.contact.plateau.ring_roughness;
  if (const auto& measured = c.contact.plateau.surface_roughness) {
    plateau.surface_roughness = *measured * to.rms / from.rms;
  }
  if (const auto& measured = c.contact.plateau.offset) plateau.offset = *measured + to.plateau - from.plateau;
  c.contact.plateau = plateau;
  return c;
}

double roughness(const Case& c) {
  if (c.contact.model == ContactLaw::kTable) return c.contact.law->composite_roughness;
  if (const auto planes = plateau_planes(c.contact)) return std::hypot(c.contact.plateau.ring_roughness, planes->rms);
  return c.contact.roughness * (c.contact.roughness_measure == RoughnessMeasure::kRaToRq ? kRqOverRa : 1.0);
}

double asperity_roughness(const Case& c) {
  const auto curve = plateau_curve(c.contact);
  return curve ? std::hypot(c.contact.plateau.ring_roughness, curve->Rpq) : roughness(c);
}

double ring_roughness_share(const Case& c) {
  if (!plateau_curve(c.contact)) return c.contact.ring_roughness_share;
  const double share = c.contact.plateau.ring_roughness / roughness(c);
  return share * share;
}

std::optional<models::GreenwoodTripp::Parameters> asperities(const Case& c) {
  if (c.contact.model == ContactLaw::kTable) return std::nullopt;
  using Form = models::ContactIntegralForm;
  const Form form = c.contact.integrals == ContactIntegrals::kExact              ? Form::kExact
                    : c.contact.integrals == ContactIntegrals::kPolynomial4Digit ? Form::kPolynomial4Digit
                                                                                 : Form::kPolynomialAsPrinted;
  return models::GreenwoodTripp::Parameters{c.contact.asperity_density, c.contact.asperity_radius,
                                            asperity_roughness(c), composite_modulus(c), form};
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
  models::ContactFunction law = models::summit_contact(pair, choice);
  double scale = pair.sigma;
  if (const auto curve = plateau_curve(contact)) {
    models::GreenwoodTripp::Parameters valleys = pair;
    valleys.sigma = std::hypot(contact.plateau.ring_roughness, curve->Rvq);
    const models::PlateauPlanes planes = *plateau_planes(contact);
    law = models::plateau_contact(std::move(law), models::summit_contact(valleys, choice), planes);
    // The table has 400 rows at most, a tenth of this apart: they must go beyond the plateau.
    constexpr double kBeyondPlateau = 9, kRowsOfScale = 40;
    scale = std::max(scale, (planes.plateau + kBeyondPlateau * scale) / kRowsOfScale);
  }
  const models::ContactTable table = tabulated(law, scale);
  return std::make_shared<models::TabulatedContact>(table, table.h.back());
}

}  // namespace ringfilm::cycle
