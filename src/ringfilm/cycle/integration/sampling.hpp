#pragma once
#include "ringfilm/cycle/integration/time_integration.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/film/integrals/film_integrals.hpp"

namespace ringfilm::cycle {

/// Friction of what touches [N/m], eq-boundary-friction.
/// @param load of it [N/m] @param area of it [m2/m]
double boundary_friction(const Contact& contact, double load, double area);

/// Every quantity of one solved instant, for the whole ring. @param problem face and contact of the film
/// @param integrals of the instant's state, of an unrolled film its means
Sample sample(const Setup& setup, const film::FilmProblem& problem, const Instant& instant,
              const film::FilmIntegrals& integrals);

/// Film, pressure, film content, lambda ratio and asperity pressure along the face (of an unrolled film along the strip
/// halfway), x from the chamber edge; appended to `fields`.
void append_fields(const Setup& setup, const TimeIntegration& integration, const Instant& instant, FaceFields& fields);

/// x and the face as installed (orientation "leading-edge": as given), from its lowest point or from the zero of the
/// input, as the case asks. @param grid of the face without load
FaceFields empty_fields(const Setup& setup, const film::FilmGrid& grid);

}  // namespace ringfilm::cycle
