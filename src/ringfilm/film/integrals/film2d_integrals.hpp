#pragma once
#include <vector>

#include "ringfilm/film/film2d.hpp"
#include "ringfilm/film/integrals/film_integrals.hpp"

namespace ringfilm::film {

/// What one strip does, per length in y.
struct StripIntegrals {
  double hydrodynamic_load = 0, asperity_load = 0;        ///< [N/m]
  double asperity_area = 0;                               ///< [m2/m]
  double shear_couette = 0, shear_poiseuille = 0;         ///< [N/m]
  double flow_left = 0, flow_middle = 0, flow_right = 0;  ///< mass flux in +x [kg/(m s)]
  double peak_pressure = 0;                               ///< [Pa]
  double cavitated_fraction = 0;                          ///< share of the width [-]
  double min_film_thickness = 0;                          ///< [m]
};

/// What a solved two-dimensional film does to its surroundings.
struct Film2dIntegrals {
  /// Means over y; the peak is that of the two-dimensional film, `mass_defect` that of the whole, per length in y.
  /// `cavities` are those of the strip halfway.
  FilmIntegrals mean;
  double flow_low = 0,
         flow_high = 0;  ///< mass flow out of the two-dimensional film through y = 0 and y = length [kg/s]
  std::vector<StripIntegrals> strips;
};

/// Integrals of `state`, solved with `inputs` from `previous`.
Film2dIntegrals film2d_integrals(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous,
                                 const FilmState& state);

}  // namespace ringfilm::film
