#pragma once
#include <functional>
#include <memory>

#include "ringfilm/film/factors/factor_laws.hpp"
#include "ringfilm/film/film2d.hpp"

/// Flow factors of two-dimensional films: the factors of each strip along the motion, as for a film across the face,
/// and the factor of the flow between strips (docs/theory/two-dimensional-film.md).
namespace ringfilm::film {

/// The factors of all strips, each with its pressures and its own separation where that of the film is h_m [m].
std::shared_ptr<const FlowFactors> film2d_factors(const FactorLaws& laws, const Film2dProblem& problem,
                                                  const Film2dInputs& inputs, const FilmState& state, double h_m);

/// film::FactorIteration of two-dimensional films: solves a film with the factors in `inputs.strip`.
using SolveFilm2d = std::function<FilmReport(const Film2dInputs& held, FilmState& state)>;

/// Solves with factors that are taken anew until they no longer change; with the laws of a plain film once.
FilmReport solve_with_factors(const FactorLaws& laws, const Film2dProblem& problem, const Film2dInputs& inputs,
                              FilmState& state, const SolveFilm2d& solve);

}  // namespace ringfilm::film
