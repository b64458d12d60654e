#pragma once
#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Length of the molecules of an oil: a thinner film is not a liquid [m].
inline constexpr double kMolecules = 1e-9;
/// About the diameter of an atom: a thinner separation is not a film [m].
inline constexpr double kAtom = 1e-10;

/// Separations that are tried: below the first no continuum describes a film, beyond the second neither a wedge nor
/// contact is left [m].
inline constexpr double kThinnest = 1e-12;
double thickest(const FilmProblem& problem);

/// Largest relative change of film or pressure in the last Newton step: by its quadratic convergence what is left is of
/// the order of the tolerance. Polynomials of contact have a kink where they end, at which that order is lost.
double enough_of_newton(const FilmProblem& problem);

/// W_a per length of circumference at the separation h_m, eq-asperity-load [N/m], and its slope there [N/m2].
double asperity_load(const FilmProblem& problem, double h_m, double* slope = nullptr);

/// Lift of the honing per length of circumference at the separation h_m, over the local film thickness, eq-land-load
/// [N/m], and its slope there [N/m2]. 0 where the problem has no land.
double land_load(const FilmProblem& problem, const FilmInputs& inputs, double h_m, double* slope = nullptr);

/// By how much the honing changes the mean shear stress of both walls, eq-land-friction, per length of circumference,
/// with the sign of U [N/m].
double land_shear(const FilmProblem& problem, const FilmInputs& inputs, double h_m);

/// W_h per length of circumference, that of the honing included, eq-hydrodynamic-load [N/m].
double hydrodynamic_load(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state);

/// What gas and cavities alone carry, eq-pressure-bound: every film carries more [N/m].
double least_hydrodynamic_load(const FilmProblem& problem, const FilmInputs& inputs);

/// What the pressures at the edges carry, each up to the lowest place of the face, whether the edges are in oil or in
/// gas, eq-asperity-load-share [N/m].
double edge_pressure_load(const FilmProblem& problem, FilmInputs inputs);

}  // namespace ringfilm::film
