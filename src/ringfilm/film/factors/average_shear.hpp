#pragma once
#include "ringfilm/film/film_state.hpp"

/// Shear stress and shear rate of a solved film, whose oil may thin and whose walls may be rough
/// (docs/theory/flow-factors.md).
namespace ringfilm::film {

/// Slope of the pressure at a node, over both neighbouring cells, at an edge over one; 0 within a cavity [Pa/m].
double pressure_slope(const FilmProblem& problem, const FilmState& state, int i);

/// Shear by a slope of the pressure, as a stress: the root mean square across the film of that of a parabolic velocity,
/// h |p'|/(2 sqrt 3); eq-shear-rate [Pa].
double pressure_shear(double h, double slope);

/// Shear forces on the walls, eq-average-shear [N/m].
struct AverageShear {
  double mean;             ///< mean of the shear forces on both walls
  double half_difference;  ///< half the difference of these forces, moving less fixed wall
};
/// Average shear of a film with flow factors. @param deficit of the nodes as shear counts it
AverageShear average_shear(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state,
                           const double* deficit);

/// Largest shear rate at a node, eq-shear-rate [1/s]. @param deficit as in average_shear(): 1 where gas fills the gap
/// @param inside_squared that of inner nodes whose oil does not thin, squared [1/s2]
double peak_shear_rate(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state,
                       const double* deficit, double inside_squared);

}  // namespace ringfilm::film
