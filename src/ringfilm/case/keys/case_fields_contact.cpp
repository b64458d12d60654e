#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

bool has_asperities(const Case& c) { return c.contact.model != ContactLaw::kTable; }
bool has_summits(const Case& c) {
  return c.contact.model == ContactLaw::kGreenwoodTripp || c.contact.model == ContactLaw::kGreenwoodWilliamson;
}

constexpr When kContact{[](const Case& c) { return c.has_contact(); },
                        "the case is not a pad, or contact.composite_modulus is stated"};
constexpr When kRoughness{
    [](const Case& c) {
      return (c.has_contact() && has_asperities(c)) || (c.problem == Problem::kPad && c.film.is_rough());
    },
    "contact.model is not \"table\"; of a pad, contact.composite_modulus is stated, or film.flow_factors, "
    "film.shear_flow, film.stress_factors or film.average_gap is not that of smooth walls"};
constexpr When kNoTable{has_asperities, "contact.model is not \"table\""};
constexpr When kAsperities{[](const Case& c) { return c.has_contact() && has_asperities(c); },
                           "contact.model is not \"table\"; of a pad, contact.composite_modulus is stated"};
constexpr When kSummits{[](const Case& c) { return c.has_contact() && has_summits(c); },
                        "contact.model = \"greenwood-tripp\" or \"greenwood-williamson\""};
constexpr When kPairs{[](const Case& c) { return c.has_contact() && c.contact.model == ContactLaw::kGreenwoodTripp; },
                      "contact.model = \"greenwood-tripp\""};
constexpr When kTable{[](const Case& c) { return c.contact.model == ContactLaw::kTable; }, "contact.model = \"table\""};
constexpr When kOwnFriction{[](const Case& c) { return c.has_contact() && !c.contact.friction_pair; },
                            "the case is not a pad, or contact.composite_modulus is stated; contact.friction_pair is "
                            "not stated"};
constexpr When kShearFlow{[](const Case& c) { return c.film.shear_flow == Roughness::kPatirCheng; },
                          "film.shear_flow = \"patir-cheng\""};

}  // namespace

void append_contact_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field("contact.model",
                choice<&Case::contact, &Contact::model>(
                    {"greenwood-tripp", "greenwood-williamson", "bush-gibson-thomas", "plastic", "table"}),
                kNoUnit, {}, Need::kDefault, kContact,
                {"law of the asperity contact: pairs of summits, summits against a flat, the same with their joint "
                 "distribution of heights and curvatures, hardness times the material ratio, or the table of a "
                 "measured pair",
                 "\"greenwood-tripp\""}),
          field("contact.law", FileKind{member<&Case::contact, &Contact::law_file>}, kNoUnit, {}, Need::kRequired,
                kTable, {"contact law that ringfilm contact --output wrote", "\"law.nc\""}),
          field("contact.law_shift", NumberKind{member<&Case::contact, &Contact::law_shift>}, {"m", "nm"},
                between(-1e-5, 1e-5), Need::kDefault, kTable,
                {"shift of the contact law to larger separations; studies sample the measured one", "\"20 nm\""}),
          field("contact.law_factor", NumberKind{member<&Case::contact, &Contact::law_factor>}, kPlainNumber,
                above(0, 1e3), Need::kDefault, kTable,
                {"factor of pressure and area of the contact law; studies sample the measured one", "1.0"}),
          field("contact.asperity",
                choice<&Case::contact, &Contact::asperity>(
                    {"elastic", "zhao-maietta-chang", "kogut-etsion", "jackson-green"}),
                kNoUnit, {}, Need::kDefault, kSummits,
                {"how one asperity deforms; all but elastic need contact.hardness", "\"elastic\""}),
          field("contact.summit_plane", choice<&Case::contact, &Contact::summit_plane>({"surface", "nayak"}), kNoUnit,
                {}, Need::kDefault, kSummits,
                {"plane from which summits are counted: that of the surface, as in styles2014, or that of the summits "
                 "by their bandwidth parameter",
                 "\"surface\""}),
          field(
              "contact.moments", choice<&Case::contact, &Contact::moments>({"pair", "one-surface"}), kNoUnit, {},
              Need::kDefault, kPairs,
              {"N and beta as stated, of the sum of both surfaces, or those of one of two like surfaces with that sum",
               "\"pair\""}),
          field("contact.asperity_density", NumberKind{member<&Case::contact, &Contact::asperity_density>},
                {"m-2", "um-2"}, above(0, 1e18), Need::kRequired, kAsperities,
                {"asperity peaks per area of the pair, N", "\"0.097 um-2\""}),
          field("contact.asperity_radius", NumberKind{member<&Case::contact, &Contact::asperity_radius>}, {"m", "um"},
                above(0, 1e-2), Need::kRequired, kAsperities,
                {"mean radius of the asperity summits, beta", "\"1.56 um\""}),
          field("contact.roughness", NumberKind{member<&Case::contact, &Contact::roughness>}, {"m", "um"},
                above(0, 1e-4), Need::kRequired, kRoughness, {"composite roughness of the pair, sigma", "\"0.48 um\""}),
          field("contact.ring_roughness_share", NumberKind{member<&Case::contact, &Contact::ring_roughness_share>},
                kPlainNumber, between(0, 1), Need::kRequired, kShearFlow,
                {"share of the ring, or of a pad's fixed surface, in the square of the composite roughness: "
                 "sigma_ring^2/sigma^2; 0: only the other wall is rough, 0.5: both alike",
                 "0.7"}),
          field(
              "contact.roughness_measure",
              choice<&Case::contact, &Contact::roughness_measure>({"as-given", "ra-to-rq"}), kNoUnit, {},
              Need::kDefault, kRoughness,
              {"use sigma as given, or take it as Ra and multiply by sqrt(pi/2) = 1.2533 for the rms", "\"as-given\""}),
          field(
              "contact.boundary_shear_strength_coefficient",
              NumberKind{member<&Case::contact, &Contact::boundary_shear_strength_coefficient>}, kPlainNumber,
              between(0, 5), Need::kRequiredInCycle, kOwnFriction,
              {"boundary shear strength over contact pressure, zeta; measured by lateral force microscopy; 0 if a pad "
               "does not state it",
               "0.3581"}),
          field("contact.friction_pair", OptionalTextKind{member<&Case::contact, &Contact::friction_pair>}, kNoUnit, {},
                Need::kOptional, kContact,
                {"pair of coating and liner of the shipped library (`ringfilm pairs` lists them), which states "
                 "boundary_shear_strength_coefficient and, unless the case does, the hardness",
                 "\"crn-on-grey-iron\""}),
          field("contact.eyring_shear_stress", NumberKind{member<&Case::contact, &Contact::eyring_shear_stress>},
                {"Pa", "MPa"}, between(0, 1e10), Need::kDefault, kContact,
                {"Eyring shear stress of the boundary film, tau_0", "\"2 MPa\""}),
          field("contact.composite_modulus", OptionalNumberKind{member<&Case::contact, &Contact::composite_modulus>},
                {"Pa", "GPa"}, between(1e8, 1e13), Need::kOptional, kNoTable,
                {"E' of 2/E' = sum (1 - nu^2)/E, instead of the moduli of ring and liner; in a pad the key that adds "
                 "asperity contact",
                 "\"134.8 GPa\""}),
          field("contact.hardness", OptionalNumberKind{member<&Case::contact, &Contact::hardness>}, {"Pa", "GPa"},
                between(1e6, 1e12), Need::kOptional, {},
                {"indentation hardness of the softer face, H: the pressure at which asperities flow; of elastic ones "
                 "it shows by how much their pressure is beyond what the material bears",
                 "\"2.5 GPa\""}),
          field("contact.integrals",
                choice<&Case::contact, &Contact::integrals>({"exact", "polynomial-4-digit", "polynomial-as-printed"}),
                kNoUnit, {}, Need::kDefault, kPairs,
                {"Gaussian height integrals F_2 and F_5/2: exact, or one of two published fits", "\"exact\""}),
          field("contact.lambda_ratio", choice<&Case::contact, &Contact::lambda_ratio>({"local", "nominal"}), kNoUnit,
                {}, Need::kDefault, kContact,
                {"contact pressure from h(x)/sigma over the face, or from h_m/sigma on the whole face", "\"local\""}),
      });
}

}  // namespace ringfilm::cycle::table
