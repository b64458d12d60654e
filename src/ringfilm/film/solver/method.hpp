#pragma once
#include <variant>

#include "ringfilm/film/solver/film_solver.hpp"
#include "ringfilm/film/solver/nested_secant.hpp"
#include "ringfilm/film/solver/point_relaxation.hpp"

namespace ringfilm::film {

/// How film and load balance are solved (docs/theory/film.md, "other methods").
enum class Method {
  kCoupledNewton,    ///< film_solver.hpp
  kPointRelaxation,  ///< point_relaxation.hpp, the paper's
  kNestedSecant,     ///< nested_secant.hpp
};

/// Scratch memory of one method; one per thread.
using MethodWorkspace = std::variant<FilmWorkspace, RelaxationWorkspace, SecantWorkspace>;
MethodWorkspace workspace_of(Method method, const FilmProblem& problem);

/// Finds pressure, film content and h_m by the method that the workspace belongs to; parameters as of `solve_film`.
FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      MethodWorkspace& workspace);

}  // namespace ringfilm::film
