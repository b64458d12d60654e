#pragma once
#include <algorithm>
#include <numbers>

#include "../unit/cycle/styles_case.hpp"
#include "repeatable_numbers.hpp"

namespace ringfilm::scenarios {

/// Engines and rings as people compute them: oil at 60-150 degC, peaks of 20-160 bar, sigma 0.1-1 um, the paper's faces
/// and parabolas that rise by 5-60 um, both cavitation models.
inline cycle::Case usual_engine(RepeatableNumbers& draw, double lowest_rpm, double highest_rpm) {
  static const cycle::Case kRings[] = {cycle::testing::styles_new_ring(), cycle::testing::styles_run_in_ring(),
                                       cycle::testing::styles_embedded_ring()};
  const int face = draw.one_of(4);
  cycle::Case c = kRings[std::min(face, 2)];
  if (face == 3) {
    c.ring.face = {};
    c.ring.face.form = cycle::FaceForm::kParabola;
    c.ring.face.crown_height = draw.log_between(5e-6, 60e-6);
    c.ring.face.apex = draw.between(0.3, 0.7);
    c.ring.face_width = draw.between(1e-3, 3e-3);
  }
  c.operating.speed = draw.log_between(lowest_rpm, highest_rpm) * 2 * std::numbers::pi / 60;
  c.operating.oil_temperature = 273.15 + draw.between(60, 150);
  const double load = draw.log_between(20, 160) / 62;
  cycle::SampledTrace trace = *c.gas.cylinder_pressure;
  for (double& p : trace.value) p = 1e5 + (p - 1e5) * (p > 1e5 ? load : 1);
  c.gas.cylinder_pressure = trace;
  c.contact.roughness = draw.log_between(0.1e-6, 1e-6);
  c.contact.asperity_density = 0.07 / (c.contact.asperity_radius * c.contact.roughness);
  c.ring.elastic_pressure = draw.log_between(0.05e6, 0.5e6);
  c.film.cavitation = draw.one_of(2) == 0 ? cycle::Cavitation::kReynoldsExit : cycle::Cavitation::kMassConserving;
  return c;
}

}  // namespace ringfilm::scenarios
