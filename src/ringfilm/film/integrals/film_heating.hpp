#pragma once
#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/gas_reach.hpp"

namespace ringfilm::film {

/// What heats the full part of a film and what carries the heat away, per unit length around the ring
/// (eq-viscous-heating). Cavities and gas are not counted.
struct FilmHeating {
  double dissipation = 0;  ///< int phi_f eta U^2/h + phi_x h^3 (dp/dx)^2/(12 eta) dx [W/m]
  double conductance = 0;  ///< int phi_f dx/h [-]
  double mass_flow = 0;    ///< modulus of the mean mass flux, in the frame of the face [kg/(m s)]

  /// Mean temperature of the oil above the mean of its walls; 0 where there is no full film [K].
  /// @param conductivity k [W/(m K)] @param specific_heat c_p [J/(kg K)]
  double rise(double conductivity, double specific_heat) const;
};

/// Heating of the film of a state that was solved with `inputs`.
/// @param strip strip of an unrolled film, whose strips follow each other in the state; 0 for a film across the face
FilmHeating film_heating(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state, int strip = 0,
                         double rise = 0);

/// Heating of a film across the face, from its sums. @param full sums over its full cells
FilmHeating film_heating(const FilmProblem& problem, const FilmInputs& inputs, const GasReach& reach,
                         const FilmView& film, LaneLaws laws, const HeatingSums& full);

}  // namespace ringfilm::film
