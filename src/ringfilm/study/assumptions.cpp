#include "ringfilm/study/assumptions.hpp"

#include <cstdio>
#include <utility>

namespace ringfilm::study {
namespace {

using cycle::Case;

template <typename... Values>
std::string text(const char* format, Values... values) {
  char buffer[640];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

Assumption assumption(const std::string& topic, std::string statement, std::string consequence,
                      std::vector<Alternative> alternatives = {}) {
  LedgerEntry entry;
  entry.topic = topic;
  entry.statement = std::move(statement);
  entry.consequence = std::move(consequence);
  entry.source = "docs/theory/assumptions.md#" + topic;
  entry.can_be_lifted = !alternatives.empty();
  return {std::move(entry), std::move(alternatives)};
}

template <typename Choice>
struct Named {
  Choice choice;
  const char* name;
};

/// The other choices of a key, each as an alternative; `say` receives the name of the one in use.
template <typename Choice, std::size_t n>
std::vector<Alternative> other_choices(const char* key, Choice in_use, const Named<Choice> (&all)[n],
                                       Choice& (*ref)(Case&), std::string& say) {
  std::vector<Alternative> others;
  for (const auto& [choice, name] : all) {
    if (choice == in_use) {
      say = name;
    } else {
      others.push_back(
          {std::string(key) + " = \"" + name + "\"", [ref, choice = choice](Case& c) { ref(c) = choice; }});
    }
  }
  return others;
}

// --- choices of model -------------------------------------------------------------------------------------------

Assumption cavitation(const Case& c) {
  using enum cycle::Cavitation;
  std::string name;
  auto others = other_choices(
      "film.cavitation", c.film.cavitation,
      {Named<cycle::Cavitation>{kReynoldsExit, "reynolds-exit"}, {kMassConserving, "mass-conserving"}},
      +[](Case& x) -> cycle::Cavitation& { return x.film.cavitation; }, name);
  return assumption("cavitation-model", "the film ruptures and forms again after the \"" + name + "\" model",
                    "the paper gives the exit condition and nothing on how the film forms again", std::move(others));
}

Assumption orientation(const Case& c) {
  using enum cycle::Orientation;
  std::string name;
  auto others = other_choices(
      "ring.face.orientation", c.ring.face.orientation,
      {Named<cycle::Orientation>{kX0Chamber, "x0-chamber"},
       {kX0Crankcase, "x0-crankcase"},
       {kLeadingEdge, "leading-edge"}},
      +[](Case& x) -> cycle::Orientation& { return x.ring.face.orientation; }, name);
  return assumption("face-orientation", "the face is installed as \"" + name + "\"",
                    "a face trace does not tell which of its ends looks at the chamber", std::move(others));
}

Assumption contact_integrals(const Case& c) {
  using enum cycle::ContactIntegrals;
  std::string name;
  auto others = other_choices(
      "contact.integrals", c.contact.integrals,
      {Named<cycle::ContactIntegrals>{kExact, "exact"},
       {kPolynomial4Digit, "polynomial-4-digit"},
       {kPolynomialAsPrinted, "polynomial-as-printed"}},
      +[](Case& x) -> cycle::ContactIntegrals& { return x.contact.integrals; }, name);
  return assumption("contact-integrals", "the integrals of the contact model are taken as \"" + name + "\"",
                    "the polynomial as printed rises again beyond a film parameter of 1.9", std::move(others));
}

Assumption film_parameter(const Case& c) {
  using enum cycle::FilmParameter;
  std::string name;
  auto others = other_choices(
      "contact.film_parameter", c.contact.film_parameter,
      {Named<cycle::FilmParameter>{kLocal, "local"}, {kNominal, "nominal"}},
      +[](Case& x) -> cycle::FilmParameter& { return x.contact.film_parameter; }, name);
  return assumption("film-parameter", "contact is summed over the face with the \"" + name + "\" film parameter",
                    "nominal puts the whole face at the minimum film", std::move(others));
}

Assumption roughness_measure(const Case& c) {
  using enum cycle::RoughnessMeasure;
  std::string name;
  auto others = other_choices(
      "contact.roughness_measure", c.contact.roughness_measure,
      {Named<cycle::RoughnessMeasure>{kAsGiven, "as-given"}, {kRaToRq, "ra-to-rq"}},
      +[](Case& x) -> cycle::RoughnessMeasure& { return x.contact.roughness_measure; }, name);
  return assumption(
      "roughness-measure", text("the roughness %.3g um is used \"%s\"", c.contact.roughness * 1e6, name.c_str()),
      "a root-sum-square of Ra is about 1/1.25 of the rms height that the contact model wants", std::move(others));
}

// --- inputs that sources leave open -----------------------------------------------------------------------------

Assumption composite_modulus(const cycle::Setup& setup) {
  static constexpr double kOther = 190e9;
  return assumption(
      "composite-modulus", text("E' is %.1f GPa; the coating's own modulus is not known", setup.E_prime / 1e9),
      "contact spots are far smaller than the coating is thick, so that its modulus rules; near 190 GPa both film "
      "parameters of the paper are met",
      {{"contact.composite_modulus = \"190 GPa\"", [](Case& c) { c.contact.composite_modulus = kOther; }}});
}

Assumption elastic_pressure(const cycle::Setup& setup) {
  const auto scaled = [&](double factor) -> Alternative {
    const double p_e = setup.elastic_pressure * factor;
    return {text("ring.elastic_pressure = \"%.3g MPa\"", p_e / 1e6), [p_e](Case& c) {
              c.ring.tangential_force.reset();
              c.ring.free_gap.reset();
              c.ring.radial_thickness.reset();
              c.ring.elastic_pressure = p_e;
            }};
  };
  return assumption("ring-tension",
                    text("the ring presses with %.3g MPa by its own tension", setup.elastic_pressure / 1e6), "",
                    {scaled(0.8), scaled(1.2)});
}

Assumption cavitation_pressure(const Case& c) {
  static constexpr double kOther = 0.2e5;
  return assumption(
      "cavitation-pressure",
      text("the film ruptures at %.3g bar absolute, or at the lower edge pressure", c.film.cavitation_pressure / 1e5),
      "", {{"film.cavitation_pressure = \"0.2 bar\"", [](Case& x) { x.film.cavitation_pressure = kOther; }}});
}

Assumption pressure_behind_ring(const Case& c) {
  const double other = c.gas.pressure_behind_ring == 1.0 ? 0.9 : 1.0;
  return assumption(
      "pressure-behind-ring",
      text("%.0f %% of the gas pressure acts behind the ring at once", 100 * c.gas.pressure_behind_ring),
      "the groove fills through the side clearance, with a delay and a loss",
      {{text("gas.pressure_behind_ring = %.1f", other), [other](Case& x) { x.gas.pressure_behind_ring = other; }}});
}

Assumption pressure_under_ring(const Case& c) {
  const char* topic = "pressure-under-ring";
  const char* consequence = "the second land holds gas at a pressure between chamber and crankcase";
  if (c.gas.crankcase_trace) {
    return assumption(topic, "the pressure straight under the ring is that of the crankcase trace", consequence);
  }
  static constexpr double kOther = 3e5;
  return assumption(
      topic,
      text("the pressure straight under the ring is that of the crankcase, %.3g bar", c.gas.crankcase_pressure / 1e5),
      consequence, {{"gas.crankcase_pressure = \"3 bar\"", [](Case& x) { x.gas.crankcase_pressure = kOther; }}});
}

Assumption oil_temperature(const Case& c) {
  const auto warmer = [&](double by) -> Alternative {
    const double T = c.operating.oil_temperature + by;
    return {text("operating.oil_temperature = \"%.4g degC\"", T - 273.15),
            [T](Case& x) { x.operating.oil_temperature = T; }};
  };
  return assumption("one-oil-temperature",
                    text("all oil is at %.4g degC; it is not heated in the film and the walls do not differ",
                         c.operating.oil_temperature - 273.15),
                    "shear heats the oil by a few kelvin at the most; the temperatures of ring and liner decide, and "
                    "they vary along the stroke",
                    {warmer(-20), warmer(+20)});
}

// --- what this program cannot lift yet ----------------------------------------------------------------------------

Assumption flooded_inlet(const cycle::Setup& setup) {
  return assumption(
      "flooded-inlet",
      text("both edges are flooded with oil; at the chamber edge it stands at up to %.3g bar",
           setup.cylinder_pressure.peak() / 1e5),
      "physically that is gas: with gas at the chamber edge friction falls by 30 to 45 %, with the oil that earlier "
      "strokes left as supply most of that comes back");
}

std::vector<Assumption> always_open(const Case& c) {
  return {
      assumption("round-bore", "the bore is round; static, thermal and dynamic deformation are zero",
                 "a ring follows smooth distortions of low order; what it cannot follow opens gaps"),
      assumption("rigid-surfaces", "ring and liner do not deform under the film pressure",
                 "holds where film pressures stay far below the moduli, as in gasoline engines"),
      assumption("ring-gap", "the ends of the ring's gap are left out",
                 "their share is about that of the gap in the "
                 "circumference"),
      assumption("dry-shear-strength",
                 text("the boundary shear strength coefficient %.4g was measured dry, on other spots than N, beta and "
                      "sigma",
                      c.contact.boundary_shear_strength_coefficient),
                 "boundary friction is proportional to it; additives lower it"),
      assumption("gaussian-summits", "asperity summits are Gaussian, of one radius, and in elastic contact",
                 "run-in and plateau-honed surfaces are skewed"),
      assumption("newtonian-oil", "the oil is Newtonian at any shear rate",
                 "multigrade oils lose viscosity from about 1e6 1/s on"),
      assumption("smooth-gap-flow", "roughness does not hinder the flow (no flow factors)",
                 "flow factors move the mean friction by -19 to +9 % with the lay of the roughness"),
  };
}

}  // namespace

std::vector<Assumption> assumptions_of(const cycle::Setup& setup) {
  const Case& c = setup.input;
  std::vector<Assumption> all = {
      flooded_inlet(setup),     pressure_behind_ring(c), pressure_under_ring(c), oil_temperature(c),
      composite_modulus(setup), elastic_pressure(setup), orientation(c),         cavitation(c),
      cavitation_pressure(c),   contact_integrals(c),    film_parameter(c),      roughness_measure(c)};
  if (c.gas.model == cycle::GasModel::kTrace && c.gas.trace_origin == cycle::TraceOrigin::kSynthetic) {
    all.insert(all.begin(), assumption("synthetic-trace", "the cylinder pressure is SYNTHETIC: computed, not measured",
                                       "load, film and boundary friction around firing TDC follow it"));
  }
  for (Assumption& open : always_open(c)) all.push_back(std::move(open));
  return all;
}

}  // namespace ringfilm::study
