#pragma once
#include <optional>
#include <vector>

#include "ringfilm/instrument/documents/surface_measurement.hpp"

namespace ringfilm::instrument {

/// Parameters of the material ratio curve with their standards: core, two lines, material ratio at a depth, oil
/// retention volume, volumes of a map, cavities. Those of a map have the names of ISO 25178-2.
/// @param two_steps lines of a surface made in two steps; nothing: it has no plateau over deeper valleys
io::MeasuredGroup material_ratio_group(const PreparedSurface& surface, const std::vector<double>& falling_heights_m,
                                       const SurfaceAnalysis& analysis,
                                       const std::optional<surface::ProbabilityRoughness>& two_steps);

/// Area, autocorrelation and cross-hatch of a map, with their standards. Throws InputError for a map that is too small.
io::MeasuredGroup texture_group(const PreparedSurface& surface);

}  // namespace ringfilm::instrument
