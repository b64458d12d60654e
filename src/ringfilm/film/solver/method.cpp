#include "ringfilm/film/solver/method.hpp"

namespace ringfilm::film {

MethodWorkspace workspace_of(Method method, const FilmProblem& problem) {
  if (method == Method::kPointRelaxation) return RelaxationWorkspace();
  if (method == Method::kNestedSecant) return SecantWorkspace(problem);
  return FilmWorkspace(problem);
}

FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      MethodWorkspace& workspace) {
  const auto solve = [&](auto& own) {
    using Own = std::decay_t<decltype(own)>;
    if constexpr (std::is_same_v<Own, RelaxationWorkspace>) {
      return solve_by_point_relaxation(problem, inputs, previous, state, own);
    } else if constexpr (std::is_same_v<Own, SecantWorkspace>) {
      return solve_by_nested_secant(problem, inputs, previous, state, own);
    } else {
      return solve_film(problem, inputs, previous, state, own);
    }
  };
  return std::visit(solve, workspace);
}

}  // namespace ringfilm::film
