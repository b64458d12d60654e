#pragma once
#include "ringfilm/cycle/integration/sampling.hpp"
#include "ringfilm/cycle/integration/time_integration.hpp"

namespace ringfilm::cycle::testing {

/// The sample at 75 degree of a film with these integrals. @param h_m separation [m] @param above,below pressures at
/// the edges of the face [Pa]
inline Sample sample_between_pressures(const Case& c, double h_m, double above, double below,
                                       const film::FilmIntegrals& integrals) {
  const cycle::Setup setup = prepare(c);
  const TimeIntegration integration(setup);
  film::FilmState state;
  state.h_m = h_m;
  Instant instant;
  instant.crank_angle_deg = 75;
  instant.at = ring_conditions(setup, instant.crank_angle_deg, film::kSteady);
  instant.at.inputs.left.pressure = above;
  instant.at.inputs.right.pressure = below;
  instant.state = &state;
  return sample(setup, integration.problem(), instant, integrals);
}

}  // namespace ringfilm::cycle::testing
