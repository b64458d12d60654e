#pragma once
#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"

/// Two loops, one inside the other, as an independent reference: a secant on ln h_m for the load around Newton solves
/// of the film at fixed h_m (eq-nested-secant). Shares the balance of mass and the kink with the coupled Newton, not
/// its way to h_m.
namespace ringfilm::film {

/// Scratch memory; one per thread, for any number of problems of one number of cells.
class SecantWorkspace {
 public:
  explicit SecantWorkspace(const FilmProblem& problem) : newton_(*problem.kernels, 1, problem.grid.n_cells()) {}

 private:
  friend class NestedSecant;
  LaneNewton newton_;
};

/// Finds pressure, film content and h_m together such that mass, cavitation and load balance.
///
/// Stops when the load is met to `tolerance`, with films of which the last Newton step was below sqrt(tolerance) and
/// crossed no kink. Once the load is bracketed it stays so (Illinois). A report that is not `converged` comes after a
/// bounded number of iterations.
///
/// @param previous the state one time step ago; only its `mass_per_area` enters
/// @param state in: first guess; out: the solution if `converged`, else unusable
FilmReport solve_by_nested_secant(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                  FilmState& state, SecantWorkspace& workspace);

}  // namespace ringfilm::film
