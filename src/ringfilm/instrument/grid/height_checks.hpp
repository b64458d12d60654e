#pragma once
#include <string>
#include <vector>

#include "ringfilm/instrument/grid/channel.hpp"
#include "ringfilm/surface/topography/topography.hpp"

/// Checks of heights after any reader: a file can be read without an error and not be a surface.
namespace ringfilm::instrument {

/// The unit in which the file, or the user, states heights.
struct HeightUnit {
  std::string name;     ///< e.g. "um"
  double size_m = 1.0;  ///< [m]
};

/// What cannot be a measured surface, or hardly: rows and columns of one value or written twice, edges that are numbers
/// or places, heights far outside all others, values that come too often, ranges that end, slopes, roughness and
/// curvatures beyond those of surfaces, a length in front of a profile. Empty for fewer than eight measured points.
/// Points of one value that alone make the map impossible are to be taken as missing (Doubt::Weight::kMissing).
std::vector<Doubt> height_doubts(const surface::HeightMap& map, const HeightUnit& unit);

/// Takes points of a map as missing.
void set_missing(surface::HeightMap& map, const std::vector<std::size_t>& points);

/// Leading values of a text that count the values behind them: the head of the file was read as heights.
/// @param value as the file has them, in their order
std::vector<Doubt> count_doubts(const std::vector<double>& value);

}  // namespace ringfilm::instrument
