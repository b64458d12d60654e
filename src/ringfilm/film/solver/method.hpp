#pragma once
#include <variant>

#include "ringfilm/film/solver/film_solver.hpp"
#include "ringfilm/film/solver/point_relaxation.hpp"

namespace ringfilm::film {

/// Scratch memory of one method of solution (docs/theory/film.md, "other methods"): of the coupled Newton or of point
/// relaxation; one per thread.
using MethodWorkspace = std::variant<FilmWorkspace, RelaxationWorkspace>;

/// Finds pressure, film content and h_m by the method that the workspace belongs to; parameters as of `solve_film`.
FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      MethodWorkspace& workspace);

}  // namespace ringfilm::film
