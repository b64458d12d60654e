#pragma once
#include <vector>

#include "ringfilm/base/tridiagonal.hpp"
#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {

/// Scratch memory of the solver; the caller owns one per thread and may use it for any number of problems.
class FilmWorkspace {
 public:
  explicit FilmWorkspace(const FilmProblem& problem);

 private:
  friend class CoupledNewton;
  NodalOil oil_;
  std::vector<double> z_, multiplier_;
  base::BorderedTridiagonal system_;
  KinkedUpdate update_;
};

/// Finds pressure, fill and h_m together such that mass, cavitation and load balance (eq-load-balance).
///
/// Method: Newton on (z, ln h_m) with one bordered tridiagonal solve an iteration; a node that would cross the
/// cavitation kink stops at it; h_m moves by at most -60 % or +150 % an iteration; if that fails, a bracketed search on
/// ln h_m around Newton solves of the film alone (the load carried falls with h_m). Stops when an iteration moves
/// nothing across the kink and changes film and pressure by less than sqrt(tolerance): what is left is then of the
/// order of the tolerance, by quadratic convergence.
///
/// @param previous the state one time step ago; only its `content` enters
/// @param state in: first guess; out: the solution if `converged`, else unusable
FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      FilmWorkspace& workspace);

/// The same at the h_m of `state`, which stays: finds pressure and fill for a separation that is given. `inputs.load`
/// is only the scale of pressures.
FilmReport solve_film_at_separation(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                    FilmState& state, FilmWorkspace& workspace);

}  // namespace ringfilm::film
