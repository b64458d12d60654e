#pragma once
#include <boost/container/small_vector.hpp>

#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/integrals/film_heating.hpp"

namespace ringfilm::film {

/// A stretch of the gap that the film does not fill. Its ends lie between nodes, where the pressure of the film
/// beside them extrapolates to p_c; a cavity that is open to an edge ends there.
struct Cavity {
  double begin = 0, end = 0;  ///< [m]
};

/// What a solved film does to its surroundings, per unit length around the ring.
struct FilmIntegrals {
  double hydrodynamic_load = 0;                ///< int p dx, and the lift of the honing [N/m]
  double land_lift = 0;                        ///< part of hydrodynamic_load by the honing, eq-land-load [N/m]
  double asperity_load = 0;                    ///< int p_a dx [N/m]
  double asperity_load_beyond_polynomial = 0;  ///< part of asperity_load from where the law is not trusted [N/m]
  double asperity_area = 0;                    ///< int A_a/A dx [m]
  /// int eta U/h dx, in the cavity weighted by theta if mass is conserved: half the sum of both walls [N/m].
  double shear_couette = 0;
  double shear_poiseuille = 0;  ///< int h/2 dp/dx dx: half the difference of both walls, the moving one first [N/m]
  double peak_shear_rate = 0;   ///< eq-shear-rate, the largest at a node that oil fills or passes [1/s]
  double flow_left = 0;         ///< mass flux in +x through x = 0 [kg/(m s)]
  double flow_middle = 0;       ///< through x = b/2
  double flow_right = 0;        ///< through x = b
  double mass_defect = 0;  ///< storage + outflow - inflow of the whole film [kg/(m s)]; round-off if mass is conserved
  double peak_pressure = 0;                 ///< [Pa]
  double cavitated_fraction = 0;            ///< share of the width that is a cavity, without the gas of an edge [-]
  double wetted_begin = 0, wetted_end = 0;  ///< between them lies no gas of an edge [m]
  FilmHeating heating;
  bool is_broken_through = false;                      ///< gas of an edge blows through the narrowest stretch
  boost::container::small_vector<Cavity, 4> cavities;  ///< from x = 0 on
};

/// Replaces what the asperities carry by that at the separation h_m.
void set_contact(const FilmProblem& problem, double h_m, FilmIntegrals& sums);

/// Integrals of `state`, solved with `inputs` from `previous`.
FilmIntegrals film_integrals(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                             const FilmState& state);

}  // namespace ringfilm::film
