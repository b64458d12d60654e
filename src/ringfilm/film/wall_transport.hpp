#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Oil that passed the ends of the gap in a step, in the direction of the motion [kg/m].
struct PassedOil {
  double in = 0, out = 0;
};

/// Lays oil that moves with the wall next to the gas of an edge where the wall has brought it (eq-wall-transport). The
/// implicit balance spreads it over the way of a step. Mass is kept: what leaves earlier or later than by that balance
/// is in `passed.out`; what comes to the film is what the balance has taken from there.
/// @param before state that the step began with, of the same nodes  @param way of the wall in the step [m]
/// @param state end of the step: mass_per_area and deficit of nodes in gas that are less than half full may change
void move_with_wall(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& before, double way,
                    PassedOil& passed, FilmState& state);

/// Gives nodes in gas that would remember less than no oil what they lack from the ones next to them (eq-bdf2).
/// @returns the smallest that is left [kg/m2]
double spread_debt_in_gas(const FilmProblem& problem, const FilmInputs& inputs, std::vector<double>& remembered);

}  // namespace ringfilm::film
