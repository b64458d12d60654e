#include "ringfilm/io/start/start_values.hpp"

#include <cmath>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/io/data/shipped_surfaces.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {

namespace {

/// sigma/beta of 0.01 is at the smooth end of the usual range (docs/manual/guide/typical-inputs.md).
constexpr double kRadius = 10e-6, kProduct = 0.05;  // [m], [-]
/// Classes of the surfaces.
const std::string kLiner = "plateau-honed-grey-iron", kRing = "nitrided";

}  // namespace

std::vector<StartValue> start_contact(const std::string& state) {
  const Units units;
  const SurfaceClasses classes = shipped_surfaces(units);
  const LinerSurface liner = liner_of_name(classes, kLiner, state);
  const RingSurface ring = ring_of_name(classes, kRing, state);
  const auto micrometres = [](double value) { return quoted(text_in(value, kMicrometre, 4)); };
  const double sigma = std::hypot(liner.plateau.Rpq, ring.roughness);
  const std::string where = " (" + state + " in " + kSurfacesFile + ")";
  return {{"contact.model", quoted("greenwood-williamson"), "with the next three: docs/manual/guide/contact-law.md"},
          {"contact.asperity", quoted("zhao-maietta-chang"), "asperities flow from the hardness on"},
          {"contact.summit_plane", quoted("nayak"), "summits lie above the mean plane of the surface"},
          {"contact.hardness", quoted(text_in(*liner.hardness, kGigapascal, 4)), liner.source + ": " + liner.name},
          {"contact.asperity_density", quoted(text_in(kProduct / (kRadius * sigma), kPerSquareMicrometre, 3)),
           kAssumed + ": N beta sigma = 0.05, sigma of ring and plateau"},
          {"contact.asperity_radius", micrometres(kRadius), ""},
          {"contact.boundary_shear_strength_coefficient", "0.12", kAssumed + ": engine oil with anti-wear additive"},
          {"contact.plateau.Rpq", micrometres(liner.plateau.Rpq), liner.source + ": " + liner.name + where},
          {"contact.plateau.Rvq", micrometres(liner.plateau.Rvq), liner.source},
          {"contact.plateau.Rmq", number_text(liner.plateau.Rmq, 4), liner.source},
          {"contact.plateau.ring_roughness", micrometres(ring.roughness), ring.source + ": " + ring.name + where}};
}

std::vector<StartValue> start_walls(const StartPoint& point) {
  for (const StartValue& value : point.operation) {
    if (value.key == "thermal.liner") return {};
  }
  cycle::Case measured;
  set_conditions(cycle::Conditions::kEngine, measured);
  std::vector<std::string> liner;
  for (const auto& [distance, temperature] : measured.thermal.liner) {
    liner.push_back("[" + quoted(text_in(distance, kMillimetre, 3)) + ", " + quoted(text_in(temperature, kCelsius, 3)) +
                    "]");
  }
  return {{"thermal.ring", quoted(text_in(*measured.thermal.ring, kCelsius, 3)), ""},
          {"thermal.liner", "[" + joined(liner, ", ") + "]",
           "mean around the bore of a car engine, measured (docs/manual/guide/typical-inputs.md)"}};
}

}  // namespace ringfilm::io
