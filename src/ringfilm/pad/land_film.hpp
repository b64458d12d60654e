#pragma once
#include <vector>

#include "ringfilm/film/film2d.hpp"
#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::pad {

/// A flat land over a rough liner: its film over the real gap of patches of the map (docs/theory/land.md). The motion
/// is along the rows.
struct LandFilmProblem {
  surface::HeightMap surface;              ///< sum of both surfaces, about its mean plane, away from the liner
  double width = 0;                        ///< width of the land along the motion [m]
  double speed = 0;                        ///< [m/s]
  double viscosity = 0;                    ///< [Pa s]
  double ambient_pressure = 101325;        ///< at both edges of the land, absolute [Pa]
  double cavitation_pressure = 0;          ///< absolute, not above ambient [Pa]
  film::Ends sides = film::Ends::kClosed;  ///< sides of a patch: its mirror images follow, or, joined, the map again
  int patches = 4;                         ///< at most
  std::vector<double> separations;         ///< distances of the mean planes [m]
};

/// What the film does at one separation: means over the patches, and their standard deviation.
struct LandFilmPoint {
  double separation = 0;                ///< [m]
  double lift = 0;                      ///< mean film pressure above ambient [Pa]
  double lift_scatter = 0;              ///< standard deviation over patches; 0 of one [Pa]
  double friction_stress = 0;           ///< mean shear stress on the land [Pa]
  double friction_scatter = 0;          ///< standard deviation over patches; 0 of one [Pa]
  double flow = 0;                      ///< volume flow past the land over its speed [m]
  double mean_gap = 0, lowest_gap = 0;  ///< over the patches [m]
  double cavitated_fraction = 0;        ///< share of the nodes [-]
  double speed_exponent = 1;            ///< d ln lift/d ln speed; NaN without lift [-]
  int iterations = 0;                   ///< largest number of cavities that were tried on the finest grid
};

struct LandFilm {
  std::vector<LandFilmPoint> points;  ///< in the order asked for
  int patches = 0;
  double patch_length = 0;  ///< across the motion [m]
  int cells_along = 0, cells_across = 0;
  double highest = 0;    ///< highest point of the map above the mean plane [m]
  double roughness = 0;  ///< rms height of the map [m]
};

/// Throws InputError where the map is smaller than the land or has points without a height, and where the surfaces
/// touch; ConvergenceError where no film is found.
LandFilm land_film(const LandFilmProblem& problem);

}  // namespace ringfilm::pad
