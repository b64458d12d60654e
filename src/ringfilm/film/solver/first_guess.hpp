#pragma once
#include <optional>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// A film to start from when there is none: solved on ever finer grids, from the coarsest that halving the cells gives.
FilmState first_guess(const FilmProblem& problem, const FilmInputs& inputs);

/// A ring without film between edges of gas: asperities carry what the gas does not, and the walls have thin films
/// alone. Nothing where the asperities cannot carry that. @param on_wall oil on the liner [kg/m2]
std::optional<FilmState> dry_film(const FilmProblem& problem, const FilmInputs& inputs, double on_wall);

/// The film of a gap between gases whose wall bears as much oil [kg/m2], at most half full. @param h_m [m]
FilmState film_on_wall(const FilmProblem& problem, const FilmInputs& inputs, double h_m, double on_wall);

}  // namespace ringfilm::film
