#pragma once
#include <vector>

#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/surface/contact/rough_contact.hpp"
#include "ringfilm/surface/topography/preparation.hpp"

namespace ringfilm::instrument {

/// What is asked of the film of a land on a liner.
struct LandAnalysis {
  surface::Preparation preparation;  ///< form and filters of each map, before both are added
  surface::MapEdges edges = surface::MapEdges::mirrored;
  double width = 0;                   ///< width of the land along the motion, that is, along the rows [m]
  double speed = 0;                   ///< [m/s]
  double viscosity = 0;               ///< [Pa s]
  double ambient_pressure = 101325;   ///< at both edges, absolute [Pa]
  double cavitation_pressure = 0;     ///< absolute [Pa]
  int patches = 4;                    ///< number of patches of the map, at most
  std::vector<double> separations_m;  ///< distances of the mean planes, in the order of the table
};

/// Lift and friction of a flat land on a liner: table, curves, fit. Throws InputError where the maps do not suit each
/// other or the land, and as pad::land_film does.
/// @param land its own map; nullptr: it is smooth
io::Measurement land_measurement(const SurfaceFile& liner, const SurfaceFile* land, const LandAnalysis& analysis);

}  // namespace ringfilm::instrument
