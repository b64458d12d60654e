#pragma once
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// W_a per length of circumference at the separation h_m, eq-asperity-load [N/m].
double asperity_load(const FilmProblem& problem, double h_m);

/// W_h per length of circumference, eq-hydrodynamic-load [N/m].
double hydrodynamic_load(const FilmProblem& problem, const FilmState& state);

}  // namespace ringfilm::film
