#include "ringfilm/instrument/documents/contact_of_case.hpp"

#include <cmath>
#include <limits>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/contact_curves.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"

namespace ringfilm::instrument {
namespace {

using cycle::ContactLaw, cycle::SummitPlane;

std::string choice_of(const char* key, const cycle::Case& c) {
  const cycle::Field& field = *cycle::find_field(key);
  const auto& choice = std::get<cycle::ChoiceKind>(field.kind);
  return choice.names[static_cast<std::size_t>(choice.index(c))];
}

std::string law_text(const cycle::Case& c) {
  const ContactLaw model = c.contact.model;
  std::string text = "law: " + choice_of("contact.model", c);
  if (model == ContactLaw::kTable) return text + ", " + c.contact.law_file;
  if (model == ContactLaw::kGreenwoodTripp || model == ContactLaw::kGreenwoodWilliamson) {
    text += "; asperities " + choice_of("contact.asperity", c) + "; separation from the plane of the " +
            (c.contact.summit_plane == SummitPlane::kNayak ? "summits" : "surfaces");
  }
  if (model == ContactLaw::kGreenwoodTripp) text += "; N and beta of " + choice_of("contact.moments", c);
  if (c.contact.plateau.is_stated()) text += "; of the plateau of the liner";
  return text;
}

/// Stated, of the table, or usual [Pa].
double hardness_of(const cycle::Case& c) {
  const auto& stated = c.contact.model == ContactLaw::kTable ? c.contact.law->hardness : c.contact.hardness;
  return stated.value_or(cycle::kUsualHardness);
}

io::MeasuredGroup plateau_group(const cycle::Case& c, const models::PlateauCurve& curve) {
  Group group("Plateau of the liner", c.contact.plateau.has_core() ? "from Rk, Rpk, Rvk and Mr2" : "");
  group.add("Rpq", "rms of the plateau", "Rpq", "m", "um", curve.Rpq);
  group.add("Rvq", "rms of the valleys", "Rvq", "m", "um", curve.Rvq);
  group.add("Rmq", "material ratio where plateau and valleys meet", "Rmq", "1", "%", curve.Rmq);
  group.remark.clear();
  group.add("plateau_roughness", "composite roughness of ring and plateau", "sigma_p", "m", "um",
            asperity_roughness(c));
  group.add("plateau_offset", "mean plane of the plateau above that of the whole liner", "z_p", "m", "um",
            plateau_offset(c.contact));
  return group;
}

io::MeasuredGroup validity_group(const cycle::Case& c) {
  Group group("Validity");
  group.add("roughness", "composite roughness as the contact model uses it", "sigma", "m", "um", roughness(c));
  group.add("composite_modulus", "composite modulus", "E'", "Pa", "GPa", composite_modulus(c));
  const double hardness = hardness_of(c);
  group.add("hardness", "hardness of the softer face", "H", "Pa", "GPa", hardness);
  if (!c.contact.hardness && c.contact.model != ContactLaw::kTable) {
    group.values.back().remark = "assumed: grey iron; contact.hardness states it";
  }
  group.add("boundary_friction_coefficient", "boundary shear strength over contact pressure", "zeta", "1", "1",
            c.contact.boundary_shear_strength_coefficient);
  group.add("friction_at_hardness", "friction coefficient of asperities that flow, zeta + tau_0/H", "mu", "1", "1",
            c.contact.boundary_shear_strength_coefficient + c.contact.eyring_shear_stress / hardness);
  const auto pair = asperities(c);
  const auto summits = pair ? models::summit_statistics(*pair) : std::nullopt;
  if (!summits) return group;
  group.add("asperity_bandwidth", "bandwidth parameter", "alpha", "1", "1", summits->bandwidth);
  group.add("asperity_slope", "rms slope", "h'", "1", "1", summits->rms_slope);
  group.add("summit_plane_offset", "plane of the summits above that of the surface", "z_s", "m", "um",
            summits->summit_offset);
  group.add("summit_offset_ratio", "the same over the roughness", "z_s/sigma", "1", "1",
            summits->summit_offset / pair->sigma);
  group.add("summit_spread_ratio", "standard deviation of the summit heights over the roughness", "sigma_s/sigma", "1",
            "1", summits->summit_spread / pair->sigma);
  group.add("plasticity_index", "above 1 asperities deform plastically", "psi", "1", "1",
            plasticity_index(*pair, summits->summit_spread, hardness));
  group.add("slope_index", "E* h'/H; above 1 real pressure of elastic contact exceeds about a third of the hardness",
            "E* h'/H", "1", "1", 0.5 * pair->E_prime * summits->rms_slope / hardness);
  return group;
}

std::vector<std::string> validity_notes(const cycle::Case& c, const io::MeasuredTable& table) {
  std::vector<std::string> notes;
  const auto pair = asperities(c);
  if (pair && !models::summit_statistics(*pair)) {
    notes.push_back("no Gaussian surface has this asperity density, radius and roughness together");
  }
  double highest = 0;
  for (const double p : table.values[4]) {
    if (std::isfinite(p)) highest = std::max(highest, p);
  }
  if (highest > hardness_of(c)) {
    notes.push_back("mean pressure on the real area up to " + text_in(highest, kGigapascal, 3) +
                    ", beyond the hardness of " + text_in(hardness_of(c), kGigapascal, 3));
  }
  if (c.contact.model == ContactLaw::kTable) {
    const cycle::ContactLawTable& law = *c.contact.law;
    const double first = law.rows.h.front(), last = law.last_supported_separation;
    for (const double h : table.values[0]) {
      if (h >= first && h <= last) continue;
      notes.push_back("separations outside " + range_in(first, last, kMicrometre, 4) +
                      " are extrapolated from the table");
      break;
    }
  }
  return notes;
}

io::MeasuredCurve law_curves(const cycle::Case& c) {
  io::MeasuredCurve curve = curve_of(
      "laws", "Contact laws", "Pressure of several laws of the same surfaces against the lambda ratio, logarithmic.",
      {"lambda_ratio", "lambda ratio", "1", "1"}, {"contact_pressure", "contact pressure", "Pa", "MPa", true});
  const cycle::ContactCurves curves = cycle::contact_curves(c);
  const std::size_t places = curves.separation.size();
  for (int k = 0; k < cycle::kPlacesOfCurves; ++k) {
    curve.x.push_back(cycle::kLambdaOfCurves * k / (cycle::kPlacesOfCurves - 1));
  }
  for (std::size_t law = 0; law < curves.laws.size(); ++law) {
    io::MeasuredSeries series{curves.laws[law].name, curves.laws[law].label, {}, false};
    for (std::size_t k = 0; k < places; ++k) {
      const double p = curves.pressure[law * places + k];
      series.y.push_back(p > 0 ? p : std::numeric_limits<double>::quiet_NaN());
    }
    curve.series.push_back(std::move(series));
  }
  return curve;
}

}  // namespace

io::Measurement contact_of_case(const cycle::Case& whole, const std::vector<double>& lambda) {
  if (whole.problem == cycle::Problem::kPad) {
    throw InputError("a pad has no asperity contact", "name the case of a ring");
  }
  const cycle::Case& c = whole.rings.empty() ? whole : whole.rings.front();
  if (!(roughness(c) > 0)) {
    throw InputError("the case states no contact: contact.roughness is missing, with the keys of contact.model",
                     "state [contact], as ringfilm new does");
  }
  io::Measurement all;
  all.kind = "contact-of-case";
  all.title = "Contact law of " + (c.title.empty() ? std::string("a case") : c.title);
  all.statements = {law_text(c), "separation: lambda ratio times composite roughness"};
  if (!whole.rings.empty()) all.notes.push_back("of the pack the first ring is tabulated");

  const auto law = asperity_contact(c);
  const double sigma = roughness(c);
  io::MeasuredTable table{io::kContactLawTable, "Contact law", {}, {}, {}};
  add_column(table, "separation", "distance of the mean planes", "h", "m", "um");
  add_column(table, "lambda_ratio", "separation over roughness", "lambda", "1", "1");
  add_column(table, "contact_pressure", "contact pressure on the nominal area", "p", "Pa", "MPa");
  add_column(table, "real_area", "real contact area over the nominal one", "A", "1", "%");
  add_column(table, "mean_real_pressure", "mean pressure on the real area", "p/A", "Pa", "GPa");
  for (const double ratio : lambda) {
    const auto at = law->contact(ratio * sigma);
    const double real = at.area_share > 0 ? at.pressure / at.area_share : std::numeric_limits<double>::quiet_NaN();
    add_row(table, {ratio * sigma, ratio, at.pressure, at.area_share, real});
  }
  for (std::string& note : validity_notes(c, table)) all.notes.push_back(std::move(note));
  if (const auto curve = plateau_curve(c.contact)) all.groups.push_back(plateau_group(c, *curve));
  all.groups.push_back(validity_group(c));
  all.tables.push_back(std::move(table));
  all.curves.push_back(law_curves(c));
  return all;
}

}  // namespace ringfilm::instrument
