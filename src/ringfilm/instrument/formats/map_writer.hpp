#pragma once
#include <string>

#include "ringfilm/surface/topography/topography.hpp"

/// Height maps into the formats of instruments, with a text that states where they come from.
namespace ringfilm::instrument {

enum class MapFormat {
  kX3p,          ///< heights as 64-bit numbers
  kDigitalSurf,  ///< heights in steps of 1 pm
  kSimpleField,  ///< heights as 32-bit numbers
  kMatrix        ///< text, a row of the map a line
};

/// The format that belongs to the ending of a name: .x3p, .sur, .gsf, .csv. Throws InputError for any other.
MapFormat map_format_of(const std::string& path);

/// The map as the bytes of a file; the same map gives the same bytes. `read_surface_file` reads all of them without
/// options. Throws InputError where the map has no measured point or a height no place in the format.
/// @param title name of the map, up to 30 letters
/// @param maker what or who made it: the instrument in X3P, a comment in the other formats
std::string map_bytes(const surface::HeightMap& map, MapFormat format, const std::string& title,
                      const std::string& maker);

}  // namespace ringfilm::instrument
