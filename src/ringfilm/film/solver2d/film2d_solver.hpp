#pragma once
#include <memory>

#include "ringfilm/film/film2d.hpp"

namespace ringfilm::film {

/// Memory of a solver, for one problem at a time. The caller owns it.
class Film2dWorkspace {
 public:
  explicit Film2dWorkspace(const Film2dProblem& problem);
  Film2dWorkspace(Film2dWorkspace&&) noexcept;
  Film2dWorkspace& operator=(Film2dWorkspace&&) noexcept;
  ~Film2dWorkspace();

 private:
  friend class Film2dSearch;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// Finds pressure, film content and the one separation of the whole two-dimensional film such that mass, cavitation and
/// load balance (eq-film-2d-balance); of a ring that bends the separation of each strip (eq-film-2d-ring).
///
/// By Newton's method on all nodes and ln h_m, or the separations; its linear systems by GMRES, preconditioned by
/// strips: each solved as in film/, the slow changes in y on coarser two-dimensional films
/// (docs/theory/two-dimensional-film.md, "the solver"). A film whose pressure leaves the range of the fitted laws is
/// solved again with the laws themselves. If Newton's method fails: a bracketed search on ln h_m, as in film/; for a
/// ring that bends none: take a shorter step.
///
/// @param previous the state one time step ago; only its `mass_per_area` enters
/// @param state in: first guess; out: the solution if `converged`, else unusable
film::FilmReport solve_film2d(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous,
                              FilmState& state, Film2dWorkspace& workspace);

/// Solves the film at the separation of `state`, which stays. `inputs.strip.load` is only the scale of pressures.
film::FilmReport solve_film2d_at_separation(const Film2dProblem& problem, const Film2dInputs& inputs,
                                            const FilmState& previous, FilmState& state, Film2dWorkspace& workspace);

/// Every strip like the one of a film across.
film::FilmState of_strips(const Film2dProblem& problem, const FilmState& strip);

/// rho theta h of every node, from pressure, deficit and h_m, by the laws that `state.laws` names and the factors in
/// `inputs`.
void complete_state(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state);

/// W_h + W_a per length in y [N/m].
double mean_load(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& state);

}  // namespace ringfilm::film
