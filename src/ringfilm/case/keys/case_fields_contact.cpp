#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

bool has_asperities(const Case& c) { return c.contact.model != ContactLaw::kTable; }
bool has_summits(const Case& c) {
  return c.contact.model == ContactLaw::kGreenwoodTripp || c.contact.model == ContactLaw::kGreenwoodWilliamson;
}

constexpr When kContact{[](const Case& c) { return c.has_contact(); },
                        "the case is not a pad, or contact.composite_modulus is stated"};
bool has_heights(const Case& c) {
  return (c.has_contact() && has_asperities(c)) || (c.problem == Problem::kPad && c.film.is_rough());
}
bool has_plateau(const Case& c) { return c.contact.plateau.is_stated(); }

constexpr When kHeights{has_heights,
                        "contact.model is not \"table\"; of a pad, contact.composite_modulus is stated, or "
                        "film.flow_factors, film.shear_flow, film.stress_factors or film.average_gap is not that of "
                        "smooth walls"};
constexpr When kRoughness{
    [](const Case& c) { return has_heights(c) && !has_plateau(c); },
    "contact.model is not \"table\" and [contact.plateau] is not stated; of a pad, contact.composite_modulus is "
    "stated, or film.flow_factors, film.shear_flow, film.stress_factors or film.average_gap is not that of smooth "
    "walls"};
constexpr When kPlateau{[](const Case& c) { return has_heights(c) && has_plateau(c); },
                        "contact.plateau states a material ratio curve"};
constexpr When kNoTable{has_asperities, "contact.model is not \"table\""};
constexpr When kAsperities{[](const Case& c) { return c.has_contact() && has_asperities(c); },
                           "contact.model is not \"table\"; of a pad, contact.composite_modulus is stated"};
constexpr When kSummits{[](const Case& c) { return c.has_contact() && has_summits(c); },
                        "contact.model = \"greenwood-tripp\" or \"greenwood-williamson\""};
constexpr When kPairs{[](const Case& c) { return c.has_contact() && c.contact.model == ContactLaw::kGreenwoodTripp; },
                      "contact.model = \"greenwood-tripp\""};
constexpr When kIntegrals{[](const Case& c) { return kPairs.holds(c) && !has_plateau(c); },
                          "contact.model = \"greenwood-tripp\", and [contact.plateau] is not stated"};
constexpr When kTable{[](const Case& c) { return c.contact.model == ContactLaw::kTable; }, "contact.model = \"table\""};
constexpr When kOwnFriction{[](const Case& c) { return c.has_contact() && !c.contact.friction_pair; },
                            "the case is not a pad, or contact.composite_modulus is stated; contact.friction_pair is "
                            "not stated"};
constexpr When kShearFlow{[](const Case& c) { return c.film.shear_flow == Roughness::kPatirCheng && !has_plateau(c); },
                          "film.shear_flow = \"patir-cheng\", and [contact.plateau] is not stated"};

template <auto Member>
Field plateau_number(const char* key, const DisplayUnit& unit, Range range, const char* help, const char* example) {
  return field({.key = std::string("contact.plateau.") + key,
                .kind = OptionalNumberKind{member<&Case::contact, &Contact::plateau, Member>},
                .unit = unit,
                .range = range,
                .need = Need::kOptional,
                .when = kHeights,
                .help = help,
                .example = example,
                .uses = {.pad = true}});
}

}  // namespace

void append_contact_fields(std::vector<Field>& fields) {
  const Range height = above(0, 1e-4), ratio = between(0, 1);  // bounds of a material ratio curve
  fields.insert(
      fields.end(),
      {
          field({.key = "contact.model",
                 .kind = choice<&Case::contact, &Contact::model>(
                     {{"greenwood-tripp", ContactLaw::kGreenwoodTripp},
                      {"greenwood-williamson", ContactLaw::kGreenwoodWilliamson},
                      {"bush-gibson-thomas", ContactLaw::kBushGibsonThomas},
                      {"plastic", ContactLaw::kPlastic},
                      {"table", ContactLaw::kTable}}),
                 .when = kContact,
                 .help =
                     "law of the asperity contact: pairs of summits, summits against a flat, the same with their joint "
                     "distribution of heights and curvatures, hardness times the material ratio, or the table of a "
                     "measured pair",
                 .example = "\"greenwood-tripp\"",
                 .uses = {.pad = true}}),
          field({.key = "contact.law",
                 .kind = FileKind{member<&Case::contact, &Contact::law_file>},
                 .need = Need::kRequired,
                 .when = kTable,
                 .help = "contact law that ringfilm contact --output wrote",
                 .example = "\"law.nc\""}),
          field({.key = "contact.law_shift",
                 .kind = NumberKind{member<&Case::contact, &Contact::law_shift>},
                 .unit = kNanometre,
                 .range = between(-1e-5, 1e-5),
                 .when = kTable,
                 .help = "shift of the contact law to larger separations; studies sample the measured one",
                 .example = "\"20 nm\""}),
          field({.key = "contact.law_factor",
                 .kind = NumberKind{member<&Case::contact, &Contact::law_factor>},
                 .unit = kPlainNumber,
                 .range = above(0, 1e3),
                 .when = kTable,
                 .help = "factor of pressure and area of the contact law; studies sample the measured one",
                 .example = "1.0"}),
          field({.key = "contact.asperity",
                 .kind =
                     choice<&Case::contact, &Contact::asperity>({{"elastic", AsperityLaw::kElastic},
                                                                 {"zhao-maietta-chang", AsperityLaw::kZhaoMaiettaChang},
                                                                 {"kogut-etsion", AsperityLaw::kKogutEtsion},
                                                                 {"jackson-green", AsperityLaw::kJacksonGreen}}),
                 .when = kSummits,
                 .help = "how one asperity deforms; all but elastic need contact.hardness",
                 .example = "\"elastic\""}),
          field({.key = "contact.summit_plane",
                 .kind = choice<&Case::contact, &Contact::summit_plane>(
                     {{"surface", SummitPlane::kSurface}, {"nayak", SummitPlane::kNayak}}),
                 .when = kSummits,
                 .help = "plane from which summits are counted: that of the surface, as in styles2014, or that of the "
                         "summits "
                         "by their bandwidth parameter",
                 .example = "\"surface\""}),
          field({.key = "contact.moments",
                 .kind = choice<&Case::contact, &Contact::moments>(
                     {{"pair", ContactMoments::kPair}, {"one-surface", ContactMoments::kOneSurface}}),
                 .when = kPairs,
                 .help = "N and beta as stated, of the sum of both surfaces, or those of one of two like surfaces with "
                         "that sum",
                 .example = "\"pair\""}),
          field({.key = "contact.asperity_density",
                 .kind = NumberKind{member<&Case::contact, &Contact::asperity_density>},
                 .unit = kPerSquareMicrometre,
                 .range = above(0, 1e18),
                 .need = Need::kRequired,
                 .when = kAsperities,
                 .help = "asperity peaks per area of the pair, N",
                 .example = "\"0.097 um-2\"",
                 .uses = {.pad = true}}),
          field({.key = "contact.asperity_radius",
                 .kind = NumberKind{member<&Case::contact, &Contact::asperity_radius>},
                 .unit = kMicrometre,
                 .range = above(0, 1e-2),
                 .need = Need::kRequired,
                 .when = kAsperities,
                 .help = "mean radius of the asperity summits, beta",
                 .example = "\"1.56 um\"",
                 .uses = {.pad = true}}),
          field({.key = "contact.roughness",
                 .kind = NumberKind{member<&Case::contact, &Contact::roughness>},
                 .unit = kMicrometre,
                 .range = above(0, 1e-4),
                 .need = Need::kRequired,
                 .when = kRoughness,
                 .help = "composite roughness of the pair, sigma",
                 .example = "\"0.48 um\"",
                 .uses = {.pad = true}}),
          field({.key = "contact.ring_roughness_share",
                 .kind = NumberKind{member<&Case::contact, &Contact::ring_roughness_share>},
                 .unit = kPlainNumber,
                 .range = between(0, 1),
                 .need = Need::kRequired,
                 .when = kShearFlow,
                 .help = "share of the ring, or of a pad's fixed surface, in the square of the composite roughness: "
                         "sigma_ring^2/sigma^2; 0: only the other wall is rough, 0.5: both alike",
                 .example = "0.7",
                 .uses = {.pad = true}}),
          field({.key = "contact.roughness_measure",
                 .kind = choice<&Case::contact, &Contact::roughness_measure>(
                     {{"as-given", RoughnessMeasure::kAsGiven}, {"ra-to-rq", RoughnessMeasure::kRaToRq}}),
                 .when = kRoughness,
                 .help = "use sigma as given, or take it as Ra and multiply by sqrt(pi/2) = 1.2533 for the rms",
                 .example = "\"as-given\"",
                 .uses = {.pad = true}}),
          field({.key = "contact.boundary_shear_strength_coefficient",
                 .kind = NumberKind{member<&Case::contact, &Contact::boundary_shear_strength_coefficient>},
                 .unit = kPlainNumber,
                 .range = between(0, 5),
                 .need = Need::kRequiredInCycle,
                 .when = kOwnFriction,
                 .help = "boundary shear strength over contact pressure, zeta; measured by lateral force microscopy; 0 "
                         "if a pad "
                         "does not state it",
                 .example = "0.3581",
                 .uses = {.pad = true}}),
          field({.key = "contact.friction_pair",
                 .kind = OptionalTextKind{member<&Case::contact, &Contact::friction_pair>},
                 .need = Need::kOptional,
                 .when = kContact,
                 .help = "pair of coating and liner of the shipped library (`ringfilm pairs` lists them), which states "
                         "boundary_shear_strength_coefficient and, unless the case does, the hardness",
                 .example = "\"crn-on-grey-iron\""}),
          field({.key = "contact.eyring_shear_stress",
                 .kind = NumberKind{member<&Case::contact, &Contact::eyring_shear_stress>},
                 .unit = kMegapascal,
                 .range = between(0, 1e10),
                 .when = kContact,
                 .help = "Eyring shear stress of the boundary film, tau_0",
                 .example = "\"2 MPa\"",
                 .uses = {.pad = true}}),
          field(
              {.key = "contact.composite_modulus",
               .kind = OptionalNumberKind{member<&Case::contact, &Contact::composite_modulus>},
               .unit = kGigapascal,
               .range = between(1e8, 1e13),
               .need = Need::kOptional,
               .when = kNoTable,
               .help =
                   "E' of 2/E' = sum (1 - nu^2)/E, instead of the moduli of ring and liner; in a pad the key that adds "
                   "asperity contact",
               .example = "\"134.8 GPa\"",
               .uses = {.pad = true}}),
          field(
              {.key = "contact.hardness",
               .kind = OptionalNumberKind{member<&Case::contact, &Contact::hardness>},
               .unit = kGigapascal,
               .range = between(1e6, 1e12),
               .need = Need::kOptional,
               .help =
                   "indentation hardness of the softer face, H: the pressure at which asperities flow; of elastic ones "
                   "it shows by how much their pressure is beyond what the material bears",
               .example = "\"2.5 GPa\""}),
          field({.key = "contact.integrals",
                 .kind = choice<&Case::contact, &Contact::integrals>(
                     {{"exact", ContactIntegrals::kExact},
                      {"polynomial-4-digit", ContactIntegrals::kPolynomial4Digit},
                      {"polynomial-as-printed", ContactIntegrals::kPolynomialAsPrinted}}),
                 .when = kIntegrals,
                 .help = "Gaussian height integrals F_2 and F_5/2: exact, or one of two published fits",
                 .example = "\"exact\"",
                 .uses = {.pad = true}}),
          field({.key = "contact.lambda_ratio",
                 .kind = choice<&Case::contact, &Contact::lambda_ratio>(
                     {{"local", LambdaRatio::kLocal}, {"nominal", LambdaRatio::kNominal}}),
                 .when = kContact,
                 .help = "contact pressure from h(x)/sigma over the face, or from h_m/sigma on the whole face",
                 .example = "\"local\"",
                 .uses = {.pad = true}}),
          plateau_number<&Plateau::Rpq>(
              "Rpq", kMicrometre, height,
              "rms of the plateau that carries, Rpq of ISO 21920-2; with Rvq and Rmq in place of contact.roughness",
              "\"0.08 um\""),
          plateau_number<&Plateau::Rvq>("Rvq", kMicrometre, height, "rms of its valleys, Rvq of ISO 21920-2; above Rpq",
                                        "\"0.9 um\""),
          plateau_number<&Plateau::Rmq>(
              "Rmq", kPlainNumber, ratio,
              "material ratio at which plateau and valleys meet, Rmq of ISO 21920-2; 82 % is 0.82", "0.82"),
          plateau_number<&Plateau::Rk>("Rk", kMicrometre, height,
                                       "height of the core, in place of Rpq, Rvq and Rmq with Rpk, Rvk and Mr2",
                                       "\"0.3 um\""),
          plateau_number<&Plateau::Rpk>("Rpk", kMicrometre, height, "height of the reduced peaks", "\"0.1 um\""),
          plateau_number<&Plateau::Rvk>("Rvk", kMicrometre, height, "depth of the reduced valleys", "\"1.2 um\""),
          plateau_number<&Plateau::Mr2>(
              "Mr2", kPlainNumber, ratio,
              "material ratio at which the valleys begin; below 0.9, that of one Gaussian surface", "0.8"),
          field({.key = "contact.plateau.ring_roughness",
                 .kind = NumberKind{member<&Case::contact, &Contact::plateau, &Plateau::ring_roughness>},
                 .unit = kMicrometre,
                 .range = between(0, 1e-4),
                 .need = Need::kRequired,
                 .when = kPlateau,
                 .help = "rms height Rq of the ring's face, or of a pad's fixed surface, taken as Gaussian; 0: smooth",
                 .example = "\"0.1 um\"",
                 .uses = {.pad = true}}),
          plateau_number<&Plateau::surface_roughness>(
              "surface_roughness", kMicrometre, height,
              "rms height Rq of the whole liner with its valleys; by default that of the curve", "\"0.4 um\""),
          plateau_number<&Plateau::offset>(
              "offset", kMicrometre, between(-1e-4, 1e-4),
              "measured mean plane of the plateau above that of the whole liner; by default that of the curve",
              "\"0.1 um\""),
      });
}

}  // namespace ringfilm::cycle::table
