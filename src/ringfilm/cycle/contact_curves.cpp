#include "ringfilm/cycle/contact_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::cycle {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Choice {
  const char *name, *label;
  ContactLaw model;
  AsperityLaw asperity;
  SummitPlane plane;
  ContactMoments moments;
};
constexpr Choice kChoices[] = {
    {"as_fed", "Greenwood-Tripp, summits counted from the plane of the surface", ContactLaw::kGreenwoodTripp,
     AsperityLaw::kElastic, SummitPlane::kSurface, ContactMoments::kPair},
    {"one_surface", "Greenwood-Tripp, N and beta of one surface, plane of the summits", ContactLaw::kGreenwoodTripp,
     AsperityLaw::kElastic, SummitPlane::kNayak, ContactMoments::kOneSurface},
    {"summits", "Greenwood-Williamson, plane of the summits, elastic", ContactLaw::kGreenwoodWilliamson,
     AsperityLaw::kElastic, SummitPlane::kNayak, ContactMoments::kPair},
    {"summits_that_flow", "Greenwood-Williamson, plane of the summits, Zhao-Maietta-Chang",
     ContactLaw::kGreenwoodWilliamson, AsperityLaw::kZhaoMaiettaChang, SummitPlane::kNayak, ContactMoments::kPair},
    {"elliptic_summits", "Bush-Gibson-Thomas", ContactLaw::kBushGibsonThomas, AsperityLaw::kElastic,
     SummitPlane::kSurface, ContactMoments::kPair},
    {"plastic", "plastic: hardness times material ratio", ContactLaw::kPlastic, AsperityLaw::kElastic,
     SummitPlane::kSurface, ContactMoments::kPair},
};

/// Has the law what it requires of hardness and surfaces?
bool is_possible(const Case& c) {
  const Contact& contact = c.contact;
  const bool flows = contact.model == ContactLaw::kPlastic || contact.asperity != AsperityLaw::kElastic;
  const bool has_plane = contact.summit_plane == SummitPlane::kNayak || contact.model == ContactLaw::kBushGibsonThomas;
  return (!flows || contact.hardness) && (!has_plane || models::summit_statistics(*asperities(c)));
}

std::vector<double> pressures(const Case& c, const std::vector<double>& h) {
  const auto law = asperity_contact(c);
  std::vector<double> p;
  for (const double at : h) p.push_back(law->contact(at).pressure);
  return p;
}

/// By shift of the separation and scale of the pressure, eq-law-band.
std::vector<double> deviation_of_table(const Case& c, const std::vector<double>& h) {
  const ContactLawTable& table = *c.contact.law;
  const double shift = table.shift_deviation.value_or(0),
               scale = table.factor_deviation.value_or(0) / c.contact.law_factor;
  const double covariance = table.shift_factor_correlation.value_or(0) * shift * scale;
  std::vector<double> deviation(h.size(), kUnknown);
  if (!table.shift_deviation && !table.factor_deviation) return deviation;
  const auto law = asperity_contact(c);
  for (std::size_t k = 0; k < h.size(); ++k) {
    const auto at = law->contact(h[k]);
    if (!(at.pressure > 0)) continue;
    const double slope = at.pressure_slope / at.pressure;
    deviation[k] = std::sqrt(std::max(0.0, slope * slope * shift * shift + scale * scale - 2 * slope * covariance));
  }
  return deviation;
}

/// By N, beta and sigma with their correlations, to first order.
std::vector<double> deviation_of_asperities(const Case& c, const std::vector<double>& h, const std::vector<double>& p) {
  const MeasuredContact& measured = c.contact.measured;
  std::vector<double> deviation(h.size(), kUnknown);
  if (!measured.asperity_density_deviation || !measured.asperity_radius_deviation || !measured.roughness_deviation) {
    return deviation;
  }
  Case by[] = {c, c, c};
  by[0].contact.asperity_density += *measured.asperity_density_deviation;
  by[1].contact.asperity_radius += *measured.asperity_radius_deviation;
  by[2].contact.roughness += *measured.roughness_deviation;
  if (!std::all_of(std::begin(by), std::end(by), is_possible)) return deviation;
  std::array<std::vector<double>, 3> moved;
  for (std::size_t k = 0; k < 3; ++k) moved[k] = pressures(by[k], h);
  const double of_density_radius = measured.density_radius_correlation.value_or(0),
               of_density_roughness = measured.density_roughness_correlation.value_or(0),
               of_radius_roughness = measured.radius_roughness_correlation.value_or(0);
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (!(p[k] > 0)) continue;
    const double a = std::log(moved[0][k] / p[k]), b = std::log(moved[1][k] / p[k]), s = std::log(moved[2][k] / p[k]);
    const double variance =
        a * a + b * b + s * s +
        2 * (of_density_radius * a * b + of_density_roughness * a * s + of_radius_roughness * b * s);
    deviation[k] = std::sqrt(std::max(variance, 0.0));
  }
  return deviation;
}

void append(const std::vector<double>& values, std::vector<double>& to) {
  to.insert(to.end(), values.begin(), values.end());
}

void add_law(const char* name, const std::string& label, const Case& c, ContactCurves& to) {
  const std::vector<double> p = pressures(c, to.separation);
  to.laws.push_back({name, label});
  append(p, to.pressure);
  append(c.contact.model == ContactLaw::kTable ? deviation_of_table(c, to.separation)
                                               : deviation_of_asperities(c, to.separation, p),
         to.log_deviation);
}

/// Those of the gap of a measured pair, used by the film or not, else those that the film uses.
void add_flow(const Case& c, ContactCurves& to) {
  const double sigma = roughness(c);
  const film::FactorLaws laws = factor_laws(c, sigma, std::nullopt);
  std::shared_ptr<const models::MeasuredFlow> measured;
  if (c.contact.model == ContactLaw::kTable && c.contact.law->flow) {
    measured = std::make_shared<const models::MeasuredFlow>(c.contact.law->flow->shifted(c.contact.law_shift));
  }
  for (const double h : to.separation) {
    if (measured) {
      to.phi_x.push_back(measured->pressure_flow(h));
      to.phi_y.push_back(measured->pressure_flow_across(h));
      to.phi_s.push_back(measured->shear_flow(h));
      continue;
    }
    if (laws.pressure_flow) to.phi_x.push_back(laws.pressure_flow->pressure_flow(h / sigma));
    if (laws.cross_flow) to.phi_y.push_back(laws.cross_flow->pressure_flow(h / sigma));
    // As measured pairs count it: what the wall at rest holds back.
    if (laws.shear_flow) to.phi_s.push_back(-laws.share_difference * laws.shear_flow->shear_flow(h / sigma));
  }
}

}  // namespace

std::vector<OtherContactLaw> other_contact_laws(const Case& c) {
  std::vector<OtherContactLaw> others;
  if (c.contact.model == ContactLaw::kTable) return others;
  for (const Choice& choice : kChoices) {
    Case of = c;
    of.contact.model = choice.model;
    of.contact.asperity = choice.asperity;
    of.contact.summit_plane = choice.plane;
    of.contact.moments = choice.moments;
    const bool is_own = choice.model == c.contact.model && choice.asperity == c.contact.asperity &&
                        choice.plane == c.contact.summit_plane && choice.moments == c.contact.moments;
    if (!is_own && is_possible(of)) others.push_back({choice.name, choice.label, std::move(of)});
  }
  if (c.contact.plateau.is_stated()) {
    others.push_back({"whole_surface", "law of the case, the whole liner as a Gaussian surface", without_plateau(c)});
  }
  return others;
}

ContactCurves contact_curves(const Case& c) {
  ContactCurves curves;
  const double end = kLambdaOfCurves * roughness(c);
  for (int k = 0; k < kPlacesOfCurves; ++k) curves.separation.push_back(end * k / (kPlacesOfCurves - 1));
  add_law("of_the_case", "law of the case", c, curves);
  for (const OtherContactLaw& other : other_contact_laws(c)) add_law(other.name.c_str(), other.label, other.of, curves);
  const auto law = asperity_contact(c);
  for (const double h : curves.separation) curves.real_area.push_back(law->contact(h).area_share);
  add_flow(c, curves);
  return curves;
}

}  // namespace ringfilm::cycle
