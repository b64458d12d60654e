#pragma once
#include <functional>

#include "ringfilm/film/factors/factor_laws.hpp"

namespace ringfilm::film {

/// Films whose factors follow from the film itself: solved with factors that are held, which are then taken anew, until
/// they no longer change (docs/theory/flow-factors.md).
class FactorIteration {
 public:
  /// Solves a film with the factors in the inputs, from the state on: film::solve_film or one like it.
  using Solve = std::function<FilmReport(const FilmInputs&, FilmState&)>;

  /// @param problem with Terms::kAll where the laws are not those of a plain film; must outlive the iteration
  FactorIteration(const FilmProblem& problem, FactorLaws laws) : problem_(problem), laws_(std::move(laws)) {}

  /// @param state as of film::solve_film @returns the report of the last film, with the iterations of all
  FilmReport solve(const FilmInputs& inputs, FilmState& state, const Solve& solve) const;

 private:
  const FilmProblem& problem_;
  FactorLaws laws_;
};

}  // namespace ringfilm::film
