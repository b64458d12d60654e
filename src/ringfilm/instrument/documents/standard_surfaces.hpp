#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/instrument/documents/surface_measurement.hpp"

/// The surfaces on which ISO 25178-2 defines areal parameters.
namespace ringfilm::instrument {

/// Form and nesting indices of the S-F and S-L surfaces of a map: as the analysis states them, else a polynomial of
/// degree 2 (assumed), for the S-filter the smallest index of the series of ISO 25178-3 of three steps or more, and for
/// the L-filter the largest that is not above the shorter side.
surface::Preparation standard_preparation(const surface::HeightMap& map, const surface::Preparation& stated);

/// Height parameters, Sdq and Sdr of the S-F and the S-L surface, each with form, filters and pixel beside it.
/// @param notes takes a line where the map is too small for one of them
std::vector<io::MeasuredGroup> standard_groups(const SurfaceFile& file, const SurfaceAnalysis& analysis,
                                               std::vector<std::string>& notes);

}  // namespace ringfilm::instrument
