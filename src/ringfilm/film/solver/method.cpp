#include "ringfilm/film/solver/method.hpp"

namespace ringfilm::film {

FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      MethodWorkspace& workspace) {
  if (auto* relaxation = std::get_if<RelaxationWorkspace>(&workspace)) {
    return solve_by_point_relaxation(problem, inputs, previous, state, *relaxation);
  }
  return solve_film(problem, inputs, previous, state, std::get<FilmWorkspace>(workspace));
}

}  // namespace ringfilm::film
