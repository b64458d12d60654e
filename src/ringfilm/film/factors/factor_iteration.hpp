#pragma once
#include <functional>

#include "ringfilm/film/factors/factor_laws.hpp"

namespace ringfilm::film {

/// What the loop of a factor iteration requires of a film.
struct FilmOfFactors {
  using Factors = std::shared_ptr<const FlowFactors>;
  std::function<Factors(const FilmState&, double h_m)> factors;  ///< with these pressures at this separation
  std::function<double(const Factors&, const Factors&, const FilmState&)> difference;  ///< film::difference
  std::function<FilmReport(const Factors&, FilmState&)> solve;  ///< the film with factors that are held
};

/// Solves with factors that are taken anew until they no longer change by `enough`, from the state on.
FilmReport iterate_factors(const FilmOfFactors& film, double enough, FilmState& state);

/// Change of the factors that a problem lets through [-].
double enough_of_factors(const FilmProblem& problem);

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

  const FactorLaws& laws() const { return laws_; }

 private:
  const FilmProblem& problem_;
  FactorLaws laws_;
};

}  // namespace ringfilm::film
