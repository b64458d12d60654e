#pragma once
#include "ringfilm/film/film2d.hpp"

namespace ringfilm::film {

/// A first guess of the film below a ring that bends. Each strip carries load by asperities and by a film. The film's
/// load beyond the load of its edges falls with the separation by a power. The energy of this ring is convex, so that
/// damped Newton steps find its balance from anywhere.
/// @param across steady film below a straight ring of the mean load
FilmState guess_of_bent_ring(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& across);

}  // namespace ringfilm::film
