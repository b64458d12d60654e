#pragma once
#include "ringfilm/film/film2d.hpp"

namespace ringfilm::film {

/// A steady, mass-conserving film at the separation of `state`, by the active set of its cavities
/// (eq-active-set of docs/theory/land.md): every set is one linear system, solved by elimination, so
/// that neither steep gaps nor many small cavities stop the iteration. For smooth walls, flooded edges and a rigid
/// face (Terms::kPlain). Oil that depends on pressure is taken at the pressures of the set before.
/// @param inputs time_step is kSteady  @param state guess, then the film; its mass is that of the film
FilmReport solve_steady_film2d(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state);

/// Is this film of the kind that solve_steady_film2d() solves?
bool has_active_set(const Film2dProblem& problem, const Film2dInputs& inputs);

}  // namespace ringfilm::film
