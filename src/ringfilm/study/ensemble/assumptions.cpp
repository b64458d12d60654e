#include "ringfilm/study/ensemble/assumptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/study/ensemble/oil_assumptions.hpp"
#include "ringfilm/study/ensemble/twist_assumption.hpp"

namespace ringfilm::study {

Assumption assumption(const std::string& topic, std::string statement, std::string consequence,
                      std::vector<Alternative> alternatives) {
  LedgerEntry entry;
  entry.topic = topic;
  entry.statement = std::move(statement);
  entry.consequence = std::move(consequence);
  entry.source = "docs/theory/assumptions.md#" + topic;
  entry.can_be_lifted = !alternatives.empty();
  return {std::move(entry), std::move(alternatives)};
}

namespace {

using cycle::Case;

void append(std::vector<Alternative> more, std::vector<Alternative>& others) {
  std::move(more.begin(), more.end(), std::back_inserter(others));
}

/// What the choice of one key assumes. @param before and `after` the words about the name of the choice
Assumption of_choice(const char* topic, const char* key, const Case& c, const std::string& before,
                     const std::string& after, const char* consequence) {
  return assumption(topic, fmt::format("{} \"{}\"{}", before, chosen(key, c), after), consequence,
                    other_choices(key, c));
}

const models::ViscosityLaw& law_of(const Case& c) { return models::viscosity_law(c.lubricant.viscosity_pressure); }

/// Has each number that the law takes a default, or does the case state it?
bool is_known(const Case& c) {
  const auto& parameters = law_of(c).parameters;
  return std::all_of(parameters.begin(), parameters.end(), [&](const models::LawParameter& parameter) {
    return parameter.statement == models::Statement::kDefault || c.stated.contains("lubricant." + parameter.key);
  });
}

/// Does viscosity grow with pressure? Without that all laws are one.
bool thickens(const Case& c) {
  constexpr double kEta = 0.01, kPressure = 0;  // [Pa s], [Pa]
  double eta = 0, slope = 0;
  law_of(c).curve({kEta, kEta, c.lubricant.law_parameters})->viscosity({&kPressure, 1}, {&eta, 1}, {&slope, 1});
  return slope > 0;
}

Assumption oil_laws(const Case& c) {
  const char* topic = "oil-laws";
  if (c.lubricant.table_file) {
    return assumption(topic, "viscosity and density are interpolated in the table of the oil",
                      "beyond the pressures of the table its last slopes are continued");
  }
  std::vector<Alternative> others;
  for (Alternative& other : other_choices("lubricant.viscosity_pressure", c)) {
    Case changed = c;
    other.apply(changed);
    if (is_known(changed) && (thickens(c) || thickens(changed))) others.push_back(std::move(other));
  }
  append(other_choices("lubricant.compressibility", c), others);
  return assumption(topic,
                    "viscosity follows \"" + chosen("lubricant.viscosity_temperature", c) + "\" in temperature and \"" +
                        chosen("lubricant.viscosity_pressure", c) + "\" in pressure, density \"" +
                        chosen("lubricant.density_temperature", c) + "\" and \"" +
                        chosen("lubricant.compressibility", c) + "\"",
                    "the laws are continued beyond the measured temperatures, and film pressures lie far below those "
                    "for which the laws of pressure were made",
                    std::move(others));
}

// --- inputs that sources leave open -----------------------------------------------------------------------------

Assumption composite_modulus(const cycle::Setup& setup) {
  const Case& c = setup.input;
  if (c.ring.coating.youngs_modulus && !c.contact.composite_modulus) {
    const char* key = "ring.coating.contact_modulus";
    const bool of_coating = c.ring.coating.contact_modulus == cycle::ContactModulus::kCoating;
    return assumption(
        "composite-modulus",
        fmt::format("E' is {:.1f} GPa, with the modulus of the {}", number_in(setup.ring.E_prime, kGigapascal),
                    of_coating ? "coating" : "ring below its coating"),
        "contact spots are far smaller than the coating is thick: the modulus of the coating counts",
        other_choices(key, c));
  }
  const double other = other_than(setup.ring.E_prime, 190e9, 135e9);
  return assumption(
      "composite-modulus",
      fmt::format("E' is {:.1f} GPa, {}", number_in(setup.ring.E_prime, kGigapascal),
                  c.contact.composite_modulus ? "as stated" : "of ring and liner uncoated"),
      "contact spots are far smaller than a coating is thick: on a coated ring the modulus of the coating counts "
      "(ring.coating.youngs_modulus)",
      other_numbers("contact.composite_modulus", setup.input, setup.ring.E_prime, kGigapascal, {other}));
}

/// 20 % to either side of whatever states the tension; the elastic pressure is proportional to each of them.
std::vector<Alternative> other_tensions(const cycle::Ring& ring, const Case& c) {
  const auto scaled = [&](const char* key, double value, const DisplayUnit& unit) {
    return other_numbers(key, c, value, unit, {0.8 * value, 1.2 * value});
  };
  if (ring.elastic_pressure) return scaled("ring.elastic_pressure", *ring.elastic_pressure, kMegapascal);
  if (ring.tangential_force) return scaled("ring.tangential_force", *ring.tangential_force, si_unit("N"));
  if (ring.expander_force) return scaled("ring.expander_force", *ring.expander_force, si_unit("N"));
  if (ring.free_shape) return {};
  return scaled("ring.free_gap", ring.free_gap.value(), kMillimetre);
}

Assumption elastic_pressure(const cycle::Setup& setup) {
  return assumption(
      "ring-tension",
      "the ring presses with " + text_in(setup.ring.elastic_pressure, kMegapascal, 3) + " by its own tension", "",
      other_tensions(setup.input.ring, setup.input));
}

Assumption cavitation_pressure(const Case& c) {
  const double p = c.film.cavitation_pressure;
  return assumption("cavitation-pressure",
                    "the film ruptures at " + text_in(p, kBar, 3) + " absolute, or at the lower edge pressure", "",
                    other_numbers("film.cavitation_pressure", c, p, kBar, {other_than(p, 0.2e5, 1.013e5)}));
}

Assumption pressure_behind_ring(const Case& c) {
  const double share = c.gas.pressure_behind_ring;
  if (c.ring.gas_path.kind == cycle::RingKind::kOil) {
    return assumption("pressure-behind-ring",
                      "holes drain the groove of the oil ring: the pressure below acts behind it",
                      "holes that oil fills or that are narrow let the pressure above reach the groove");
  }
  return assumption("pressure-behind-ring",
                    share == 1
                        ? "the full gas pressure above the ring acts behind it at once"
                        : fmt::format("{:.3g} % of the excess of the gas pressure above the ring over that below it "
                                      "acts behind the ring at once",
                                      100 * share),
                    "the groove fills through the side clearance, with a delay and a loss",
                    other_numbers("gas.pressure_behind_ring", c, share, kPlainNumber, {other_than(share, 1.0, 0.9)}));
}

/// How the gas comes between the rings.
Assumption gas_path(const Case& c) {
  return assumption(
      "gas-path",
      fmt::format("the gas between the rings is that of volumes at constant temperatures, end gaps and side "
                  "clearances; rings \"{}\"",
                  chosen("gas_path.ring_motion", c)),
      c.gas_path.passes_films()
          ? "oil that remains in a broken film does not hinder the gas, the temperatures do not follow it"
          : "the film lets no gas pass, the temperatures do not follow the gas");
}

/// What the gas fills and leaks through at this ring.
Assumption gas_sizes(const Case& c) {
  const cycle::RingGasPath& gas = c.ring.gas_path;
  const double gap = gas.gap_area ? *gas.gap_area : c.ring.end_gap.value_or(0) * gas.land_clearance.value_or(0);
  std::string sizes = "end gap of " + text_in(gap, kSquareMillimetre, 3);
  if (gas.kind == cycle::RingKind::kCompression) {
    sizes += fmt::format(", groove of {} at {:.4g} K, side clearance of {}",
                         text_in(gas.groove_volume.value_or(0), kCubicMillimetre, 3), gas.groove_temperature,
                         text_in(gas.side_clearance.value_or(0), kMicrometre, 3));
  }
  if (gas.volume_below > 0) {
    sizes += fmt::format(", piston land below of {} at {:.4g} K", text_in(gas.volume_below, kCubicMillimetre, 3),
                         gas.temperature_below);
  }
  return assumption("gas-volumes", "the gas at the ring has an " + sizes,
                    "those of a hot engine are rarely known and differ from the drawing: end gaps close, blow-by is "
                    "nearly proportional to that of the ring that chokes, volumes set the pressure between the rings");
}

/// What the gas consists of.
Assumption composition_of_gas(const Case& c) {
  const cycle::GasComposition& of = c.gas.composition;
  return assumption(
      "gas-composition",
      fmt::format("the gas that enters the pack is a mixture of fresh charge and burnt gas, {} at lambda = {:.3g}, "
                  "burnt as \"{}\" from {:.3g} degree on",
                  chosen("gas.composition.fuel", c), of.excess_air_ratio, chosen("gas.composition.burn", c),
                  of.burn_begin_deg),
      "each volume is mixed, nothing diffuses, burns or condenses in the pack; unburnt fuel in the crankcase follows "
      "when the flame reaches the top piston land: \"wiebe\" takes the mean of the cylinder, \"step\" the end of the "
      "combustion");
}

Assumption pressure_under_ring(const Case& c) {
  if (c.ring.pressure_below.is_stated()) {
    return assumption("pressure-under-ring", "the pressure straight under the ring is that of ring.pressure_below",
                      "gas that flows past the rings is not computed");
  }
  const double p = c.gas.crankcase_pressure;
  std::vector<Alternative> others;
  if (!c.gas.crankcase_trace) {
    others = other_numbers("gas.crankcase_pressure", c, p, kBar, {other_than(p, 3e5, 1.013e5)});
  }
  return assumption("pressure-under-ring",
                    "the pressure straight under the ring is that of the crankcase" +
                        (c.gas.crankcase_trace ? " trace" : ", " + text_in(p, kBar, 3)),
                    "the second piston land holds gas at a pressure between chamber and crankcase", std::move(others));
}

Assumption oil_temperature(const Case& c) {
  const std::vector<Alternative> heating = other_choices("thermal.viscous_heating", c);
  const bool is_heated = c.thermal.is_heated();
  const char* words = is_heated ? "its mean rise by shear is added" : "it is not heated by shear";
  if (c.thermal.is_stated()) {
    std::vector<Alternative> others = other_choices("thermal.film", c);
    append(heating, others);
    return assumption("oil-temperature",
                      "the oil film has the temperature \"" + chosen("thermal.film", c) + "\" of its walls; " + words,
                      "the walls carry the heat of shear away; that of asperity friction does not reach the oil",
                      std::move(others));
  }
  const double T = c.operating.oil_temperature;
  std::vector<Alternative> others = other_numbers("operating.oil_temperature", c, T, kCelsius, {T - 20, T + 20});
  append(heating, others);
  return assumption(
      "oil-temperature", fmt::format("the walls of all oil are at {}; {}", text_in(T, kCelsius, 4), words),
      "the walls carry the heat of shear away; the temperatures of ring and liner decide, and they vary along the "
      "stroke",
      std::move(others));
}

// --- edges, gap and what this program cannot lift yet
// ----------------------------------------------------------------------------

std::vector<Alternative> other_supplies(const Case& c) {
  std::vector<Alternative> others;
  if (c.supply.film.size() == 1) {
    const double film = c.supply.film.front().value;
    others = other_numbers("supply.film", c, film, kMicrometre, {0.5 * film, 2 * film});
  }
  if (c.supply.reach) {
    const double reach = *c.supply.reach;
    append(other_numbers("supply.reach", c, reach, kMillimetre, {0.5 * reach}), others);
  }
  append(other_choices("film.supply", c), others);
  return others;
}

Assumption flooded_inlet(const cycle::Setup& setup) {
  const Case& c = setup.input;
  const char* topic = "oil-supply";
  std::vector<Alternative> others = other_choices("film.chamber_edge", c);
  append(other_choices("film.crankcase_edge", c), others);
  if (c.film.supply_at_inlet() != cycle::OilSupply::kFlooded) {
    append(other_supplies(c), others);
    const bool follows = c.film.supply == cycle::OilSupply::kFilmOnLiner;
    const std::string film = text_in(along_stroke(c.supply.film, 0.5 * c.engine.stroke), kMicrometre, 3);
    return assumption(
        topic,
        follows ? fmt::format("the ring finds on the liner what earlier strokes left, and below {} the film of the oil "
                              "ring, {} at midstroke",
                              text_in(*c.supply.reach, kMillimetre, 3), film)
                : "a film of " + film + " at midstroke is ahead of the ring on every stroke",
        "what the oil ring leaves is seldom known; below half of the film at which the asperities carry "
        "the load alone the ring runs dry",
        std::move(others));
  }
  if (!cycle::is_engine(c.conditions)) {
    // All at once: gas takes friction away, short oil and the walls of an engine add it.
    Alternative engine{"conditions = \"engine\"", [](Case& x) { set_conditions(cycle::Conditions::kEngine, x); }};
    Case changed = c;
    engine.apply(changed);
    if (cycle::broken_rules(changed).empty()) others.push_back(std::move(engine));
  }
  if (c.film.has_gas_edge()) {
    const char* where = c.film.chamber_edge == c.film.crankcase_edge    ? "either edge"
                        : c.film.chamber_edge == cycle::EdgeFluid::kGas ? "the chamber edge"
                                                                        : "the crankcase edge";
    return assumption(
        topic,
        fmt::format("the edge at which the film enters is flooded with oil; where it leaves through {} it meets "
                    "gas",
                    where),
        "what lies on the liner after earlier strokes may not flood the inlet: oil flow is an upper "
        "bound, friction a lower one",
        others);
  }
  return assumption(
      topic,
      "both edges are flooded with oil; at the chamber edge its pressure is up to " +
          text_in(setup.ring.lands.above.peak(), kBar, 3),
      "physically that is gas, which takes viscous friction away, and a thinner supply of oil, which adds boundary "
      "friction: friction may err either way; oil flow is an upper bound of that with less oil at the inlet",
      others);
}

/// Assumption about what passes while gas blows through the film.
Assumption broken_film(const Case& c) {
  const char* what = c.film.broken == cycle::BrokenFilm::kFreeSurface
                         ? "as much oil as a free surface carries against it"
                     : c.film.broken == cycle::BrokenFilm::kHalfPasses ? "half of the gap, as without gas,"
                                                                       : "no oil";
  return assumption("broken-film",
                    fmt::format("where gas of a higher pressure blows through the film against the motion, {} passes "
                                "the lowest place of the face",
                                what),
                    "what passes there was not measured; where a ring breaks through for long it decides what the next "
                    "stroke finds",
                    other_choices("film.broken", c));
}

/// Assumption about the ends of the ring. The ledger does not lift it for a film across the face, which requires a
/// separate case: the unrolled film costs more than all other choices of a ledger together.
Assumption ring_gap(const Case& c) {
  const char* topic = "ring-gap";
  if (!c.is_unrolled()) {
    Assumption omitted =
        assumption(topic, "the ends of the ring are omitted",
                   "their share is about that of the gap in the circumference; film.dimension = \"unrolled\" with "
                   "ring.end_gap computes them");
    omitted.entry.can_be_lifted = true;
    return omitted;
  }
  const auto others = other_choices("film.dimension", c);
  if (!c.ring.end_gap) {
    return assumption(topic, "the ring is closed: the unrolled film has no gap",
                      "all strips across the face are alike; ring.end_gap states a gap", others);
  }
  return assumption(
      topic,
      fmt::format("the ring has a gap of {}, at whose ends the film has the mean of the pressures at its edges; gas "
                  "that blows through it is not computed",
                  text_in(*c.ring.end_gap, kMillimetre, 4)),
      "oil that leaves the film for the gap, or comes from there, is reported; that the gap holds oil is an assumption "
      "like "
      "that of flooded edges",
      others);
}

/// Other laws and planes that the case allows; the plane of a law that has none is not in use.
std::vector<Alternative> other_contact_laws(const Case& c) {
  std::vector<Alternative> others;
  if (c.contact.model == cycle::ContactLaw::kTable) return others;
  for (const char* key : {"contact.summit_plane", "contact.model"}) {
    if (!cycle::is_active(*cycle::find_field(key), c)) continue;
    for (Alternative& other : other_choices(key, c)) {
      Case changed = c;
      other.apply(changed);
      const bool is_known = changed.contact.model != cycle::ContactLaw::kTable &&
                            changed.contact.model != cycle::ContactLaw::kGreenwoodWilliamson;
      if (is_known && cycle::broken_rules(changed).empty()) others.push_back(std::move(other));
    }
  }
  return others;
}

Assumption gaussian_summits(const cycle::Setup& setup) {
  if (setup.input.contact.model == cycle::ContactLaw::kTable) {
    const cycle::Contact& contact = setup.input.contact;
    std::vector<Alternative> others;
    if (const auto& deviation = contact.law->shift_deviation; deviation && *deviation > 0) {
      others = other_numbers("contact.law_shift", setup.input, contact.law_shift, kNanometre,
                             {contact.law_shift - *deviation, contact.law_shift + *deviation});
    }
    return assumption("contact-law", "contact follows the table " + contact.law_file,
                      "the maps are a sample of the faces, in the state in which they were measured", others);
  }
  constexpr double kLambda = 2;  // the ratio of load and area depends little on it
  const double separation = cycle::plateau_offset(setup.input.contact) + kLambda * setup.ring.asperities->sigma;
  const auto contact = setup.ring.contact->contact(separation);
  const bool is_elastic = setup.input.contact.is_elastic();
  std::string statement = "asperities are Gaussian, in contact after \"" + chosen("contact.model", setup.input) +
                          (is_elastic ? "\", elastic" : "\", flowing at the hardness");
  if (contact.area_share > 0) {
    statement += fmt::format(", with {} on the real area (at a lambda ratio of {:.0f})",
                             text_in(contact.pressure / contact.area_share, kGigapascal, 3), kLambda);
  }
  return assumption("contact-law", statement,
                    "run-in and plateau-honed surfaces are skewed: [contact.plateau] states the material ratio curve "
                    "of one, ringfilm contact computes the law of measured ones. "
                    "Beyond the hardness of the softer face load against film is a fit to N, beta and sigma; the "
                    "boundary friction coefficient remains, real area and spot size do not",
                    other_contact_laws(setup.input));
}

/// The plateau of the liner against a Gaussian surface that is as rough as the whole liner.
Assumption plateau(const cycle::Setup& setup) {
  const Case& c = setup.input;
  const models::PlateauCurve curve = *cycle::plateau_curve(c.contact);
  const double sigma = setup.ring.sigma;
  std::vector<Alternative> others =
      other_numbers("contact.roughness", cycle::without_plateau(c), 0, kMicrometre, {sigma});
  for (Alternative& other : others) {
    other = {other.setting + " without [contact.plateau]", [set = std::move(other.apply)](Case& x) {
               x = cycle::without_plateau(x);
               set(x);
             }};
  }
  return assumption(
      "plateau",
      fmt::format(
          "the plateau of the liner carries, with Rpq {}, Rvq {}, Rmq {:.3g} % and its mean plane {} above that "
          "of the liner; with the ring the composite roughness is {} of the plateau, {} of the whole",
          text_in(curve.Rpq, kMicrometre, 3), text_in(curve.Rvq, kMicrometre, 3), 100 * curve.Rmq,
          text_in(cycle::plateau_offset(c.contact), kMicrometre, 3),
          text_in(setup.ring.asperities->sigma, kMicrometre, 3), text_in(sigma, kMicrometre, 3)),
      "both parts are Gaussian with the same N and beta, and grooves of any direction count alike: where the valleys "
      "take more than a third of the area, the law of a measured pair is needed",
      std::move(others));
}

/// What the oils of data/lubricants determine by their HTHS the ledger runs; of others it would have to be made up.
Assumption newtonian_oil(const Case& c) {
  const char* topic = "shear-thinning";
  const cycle::Lubricant& oil = c.lubricant;
  const auto others = other_choices("lubricant.shear_thinning", c);
  if (!oil.thins()) {
    return assumption(topic, "the oil is Newtonian at any shear rate",
                      "multigrade oils lose viscosity from about 1e6 1/s on; lubricant.shear_thinning with "
                      "lubricant.hths_viscosity computes it",
                      others);
  }
  return assumption(
      topic,
      fmt::format("viscosity falls with the shear rate after the \"{}\" law, to {:.3g} of that without shear",
                  chosen("lubricant.shear_thinning", c), oil.second_newtonian_ratio),
      "the ratio is that of other oils as a rule; shear by pressure and by sliding act as one rate", others);
}

Assumption smooth_gap_flow(const Case& c) {
  const char* topic = "flow-factors";
  std::vector<Alternative> others = other_choices("film.flow_factors", c);
  if (c.film.flow_factors == cycle::Roughness::kNone) {
    return assumption(topic, "roughness does not hinder the flow (no flow factors)",
                      "friction may err either way, with the lay of the roughness, below a lambda ratio of about 3; "
                      "film.flow_factors with film.orientation computes it",
                      others);
  }
  if (c.film.flow_factors == cycle::Roughness::kMeasured) {
    return assumption(topic, "roughness changes the flow by pressure as the gap of the measured pair does",
                      "the maps are one sample of one state; waves longer than they are belong to face and bore",
                      others);
  }
  const double gamma = c.film.orientation;
  append(other_numbers("film.orientation", c, gamma, kPlainNumber, {1.0 / 3, 1, 3}), others);
  return assumption(topic,
                    fmt::format("roughness changes the flow by pressure as that of an orientation of {:.3g}", gamma),
                    "the factors are fits to Gaussian surfaces that may overlap and do not deform; below a lambda "
                    "ratio of about 1 they are extrapolated",
                    others);
}

Assumption conformity(const Case& c) {
  if (c.bends()) {
    return assumption(
        "bore-shape",
        std::string("the ring follows the bore as a thin beam with free ends; ") +
            (c.liner.dynamic_distortion ? "the cycle deforms the bore as liner.dynamic_distortion states; "
                                          "twist is zero"
                                        : "dynamic deformation (liner.dynamic_distortion is not stated) "
                                          "and twist are zero"),
        "where it cannot follow, the film is full of oil up to its edges, as elsewhere",
        other_choices("ring.conformity", c));
  }
  Assumption round = assumption("bore-shape", "the bore is round; static, thermal and dynamic deformation are zero",
                                "a ring follows smooth distortions of low order; what it cannot follow opens gaps; "
                                "ring.conformity = \"beam\" of an unrolled film computes it");
  round.entry.can_be_lifted = true;
  return round;
}

Assumption local_deformation(const Case& c) {
  const bool is_rigid = c.ring.local_deformation == cycle::LocalDeformation::kNone;
  return assumption("local-deformation",
                    is_rigid ? "ring and liner do not deform under the film pressure"
                             : "face and liner give way to the pressure between them as half-spaces in plane strain",
                    is_rigid ? "under piston rings they give way by a tenth of a micrometre, which changes the film by "
                               "some percent; ring.local_deformation = \"half-space\" computes it"
                             : "coating, edges and what lies behind the ring are omitted; what bends ring and liner "
                               "over more than the width of the face is not local",
                    other_choices("ring.local_deformation", c));
}

/// The band of a pair of the library gives the alternatives.
Assumption boundary_friction(const Case& c) {
  const char* key = "contact.boundary_shear_strength_coefficient";
  const double zeta = c.contact.boundary_shear_strength_coefficient;
  std::vector<Alternative> others;
  std::string statement =
      fmt::format("the boundary shear strength coefficient is {:.4g} at any temperature, speed and film", zeta);
  if (c.contact.friction_pair) {
    const models::FrictionPair& pair = *c.contact.pair;
    statement += " (\"" + pair.name + "\": " + pair.source + ")";
    if (pair.low) others = other_numbers(key, c, zeta, kPlainNumber, {*pair.low, *pair.high});
  }
  return assumption("boundary-shear-strength", statement,
                    "boundary friction is proportional to it; a value of lateral force microscopy is that of dry "
                    "surfaces at other spots than N, beta and sigma, and additives lower it",
                    others);
}

std::vector<Assumption> honing(const Case& c) {
  if (c.film.land_lift == cycle::LandLift::kNone) return {};
  std::vector<Alternative> others = other_choices("film.land_lift", c);
  if (const auto& deviation = c.film.land_law->log_lift_deviation; deviation && *deviation > 0) {
    append(other_numbers("film.land_factor", c, c.film.land_factor, kPlainNumber,
                         {c.film.land_factor * std::exp(-*deviation), c.film.land_factor * std::exp(*deviation)}),
           others);
  }
  return {assumption("land-lift", "the honing lifts the face as the table " + c.film.land_law_file + " states",
                     "the patches are a sample of the liner; the lift is that of a steady film with flooded edges, of "
                     "a land as wide as the one computed",
                     others)};
}

std::vector<Assumption> always_open(const cycle::Setup& setup) {
  const Case& c = setup.input;
  return {
      conformity(c),           local_deformation(c), ring_gap(c),        boundary_friction(c),
      gaussian_summits(setup), newtonian_oil(c),     smooth_gap_flow(c),
  };
}

/// Is the face its own mirror image, to rounding, so that its orientation has no effect?
bool is_symmetric(const models::RingFace& face) {
  constexpr int kPlaces = 200;
  constexpr double kRounding = 1e-9;  // tolerance over the deepest place compared
  double difference = 0, deepest = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const double x = face.face_width() * i / kPlaces, height = face.height(x);
    difference = std::max(difference, std::abs(height - face.height(face.face_width() - x)));
    deepest = std::max(deepest, std::abs(height));
  }
  return difference <= kRounding * deepest;
}

std::vector<Assumption> choices_of_film(const cycle::Setup& setup) {
  const Case& c = setup.input;
  std::vector<Assumption> all = {oil_temperature(c), composite_modulus(setup), elastic_pressure(setup)};
  for (Assumption& one : honing(c)) all.push_back(std::move(one));
  if (!is_symmetric(setup.ring.face)) {
    all.push_back(of_choice("face-orientation", "ring.face.orientation", c, "the face is installed as", "",
                            "a face trace does not show which end faces the chamber"));
  }
  // Neither has a contact law without integrals or without a roughness of its own such a choice, nor a flooded film.
  const auto add_if_used = [&](const char* topic, const char* key, const std::string& before, const std::string& after,
                               const char* consequence) {
    if (!cycle::is_active(*cycle::find_field(key), c)) return;
    all.push_back(of_choice(topic, key, c, before, after, consequence));
  };
  add_if_used("cavitation-model", "film.cavitation", "the film ruptures and forms again after the", " model",
              "the models differ in where the film forms again; Reynolds' exit does not keep mass there");
  all.push_back(cavitation_pressure(c));
  add_if_used("outlet", "film.outlet", "of oil that hangs on the face behind the film the liner takes along that of a",
              " outlet", "what a meniscus leaves in a gap of micrometres at the edge of a ring was not measured");
  add_if_used("contact-integrals", "contact.integrals", "the integrals of the contact model are taken as", "",
              "the polynomial as printed rises again beyond a lambda ratio of 1.9");
  add_if_used("lambda-ratio", "contact.lambda_ratio", "contact is summed over the face with the", " lambda ratio",
              "nominal puts the whole face at the minimum film");
  add_if_used("roughness-measure", "contact.roughness_measure",
              "the roughness " + text_in(c.contact.roughness, kMicrometre, 3) + " is used", "",
              "a root-sum-square of Ra is sqrt(2/pi) = 0.80 of the rms height that the contact model expects");
  all.push_back(oil_laws(c));
  return all;
}

}  // namespace

std::vector<Assumption> assumptions_of(const cycle::Setup& setup) {
  const Case& c = setup.input;
  std::vector<Assumption> all = {flooded_inlet(setup)};
  if (cycle::is_active(*cycle::find_field("film.broken"), c)) all.push_back(broken_film(c));
  if (c.gas_path.is_computed()) {
    all.push_back(gas_path(c));
    all.push_back(gas_sizes(c));
    if (c.gas.composition.is_stated()) all.push_back(composition_of_gas(c));
    if (c.ring.gas_path.kind == cycle::RingKind::kOil) all.push_back(pressure_behind_ring(c));
  } else {
    all.push_back(pressure_behind_ring(c));
    all.push_back(pressure_under_ring(c));
  }
  if (c.follows_oil() && !c.ring.pressure_above.is_stated()) {
    for (Assumption& one : oil_consumption_assumptions(c)) all.push_back(std::move(one));
  }
  for (Assumption& one : choices_of_film(setup)) all.push_back(std::move(one));
  if (c.gas.model == cycle::GasModel::kTrace && c.gas.trace_origin == cycle::TraceOrigin::kSynthetic) {
    all.insert(all.begin(), assumption("synthetic-trace", "the cylinder pressure is SYNTHETIC: computed, not measured",
                                       "load, film and boundary friction around firing TDC follow it"));
  }
  for (Assumption& open : always_open(setup)) all.push_back(std::move(open));
  if (c.ring.section.is_stated()) all.push_back(ring_twist(c));
  if (cycle::plateau_curve(c.contact)) all.push_back(plateau(setup));
  return all;
}

}  // namespace ringfilm::study
