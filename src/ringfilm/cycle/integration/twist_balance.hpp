#pragma once
#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::cycle {

/// Twist at which a ring is in balance with its film, its gas, its inertia and its flanks, eq-section-twist [rad].
/// @param setup of a case whose ring twists @param problem with the gap of the film @param previous as of
/// film::film_integrals
double balanced_twist(const Setup& setup, const RingConditions& at, const film::FilmProblem& problem,
                      const film::FilmState& previous, const film::FilmState& state);

}  // namespace ringfilm::cycle
