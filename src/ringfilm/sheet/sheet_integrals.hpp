#pragma once
#include <vector>

#include "ringfilm/film/film_integrals.hpp"
#include "ringfilm/sheet/sheet.hpp"

namespace ringfilm::sheet {

/// What one strip does, per length in y.
struct StripIntegrals {
  double hydrodynamic_load = 0, asperity_load = 0;        ///< [N/m]
  double shear_couette = 0, shear_poiseuille = 0;         ///< [N/m]
  double flow_left = 0, flow_middle = 0, flow_right = 0;  ///< mass flux in +x [kg/(m s)]
  double peak_pressure = 0;                               ///< [Pa]
  double cavitated_fraction = 0;                          ///< share of the width [-]
  double min_film_thickness = 0;                          ///< [m]
};

/// What a solved sheet does to its surroundings.
struct SheetIntegrals {
  /// Means over y; the peak is that of the sheet, `mass_defect` that of the whole, per length in y. `cavities` are
  /// those of the strip halfway.
  film::FilmIntegrals mean;
  double flow_low = 0, flow_high = 0;  ///< mass flow out of the sheet through y = 0 and y = length [kg/s]
  std::vector<StripIntegrals> strips;
};

/// Integrals of `state`, solved with `inputs` from `previous`.
SheetIntegrals sheet_integrals(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& previous,
                               const film::FilmState& state);

}  // namespace ringfilm::sheet
