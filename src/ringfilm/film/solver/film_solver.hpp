#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"

namespace ringfilm::film {

/// Scratch memory of the solver; the caller owns one per thread and may use it for any number of problems with the
/// same number of cells.
class FilmWorkspace {
 public:
  explicit FilmWorkspace(const FilmProblem& problem) : newton_(*problem.kernels, 1, problem.grid.n_cells()) {}

 private:
  friend class FilmSolve;
  LaneNewton newton_;
};

/// Finds pressure, film content and h_m together such that mass, cavitation and load balance (eq-load-balance).
///
/// By LaneNewton in one lane, with the fitted laws if the oil has them; a film whose pressure leaves their range is
/// solved again with the laws themselves. If Newton's method fails: a bracketed search on ln h_m around Newton
/// solves of the film alone, with the laws themselves (the load carried falls with h_m).
///
/// @param previous the state one time step ago; only its `mass_per_area` enters
/// @param state in: first guess; out: the solution if `converged`, else unusable
FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      FilmWorkspace& workspace);

/// Finds pressure and film content for a given separation: the h_m of `state`, which stays. `inputs.load` is only the
/// scale of pressures.
FilmReport solve_film_at_separation(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                    FilmState& state, FilmWorkspace& workspace);

}  // namespace ringfilm::film
