#pragma once
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// A film to start from when there is none: solved on ever finer grids, from the coarsest that halving the cells gives.
FilmState first_guess(const FilmProblem& problem, const FilmInputs& inputs);

}  // namespace ringfilm::film
