#pragma once
#include <optional>
#include <vector>

#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/surface/contact/contact_law.hpp"
#include "ringfilm/surface/topography/preparation.hpp"

namespace ringfilm::instrument {

/// What is asked of the contact of a pair.
struct ContactAnalysis {
  surface::Preparation preparation;  ///< form and filters of each map, before both are added
  surface::MapEdges edges = surface::MapEdges::mirrored;
  surface::ContactMaterial material;
  std::vector<double> separations_m;                 ///< in the order of the table; empty: surface::usual_separations
  std::size_t shifts = 1;                            ///< relative positions of both surfaces
  std::size_t regions_across = 1, regions_down = 1;  ///< whose laws scatter
  bool has_flow = false;                             ///< with the factors of the flow through the gap
};

/// The contact law of a pair of measured surfaces: table, curves, contact map. Throws InputError where maps do not
/// belong together, and as surface::contact_law does.
/// @param second nullptr: a smooth flat
io::Measurement contact_measurement(const SurfaceFile& first, const SurfaceFile* second,
                                    const ContactAnalysis& analysis);

}  // namespace ringfilm::instrument
