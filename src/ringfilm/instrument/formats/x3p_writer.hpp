#pragma once
#include <string>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::instrument {

/// The type of the heights in a written file.
enum class X3pHeights { kInt16, kDouble };

/// The description that a written file contains.
struct X3pOrigin {
  std::string date = "1970-01-01T00:00:00";  ///< as XML writes it
  std::string manufacturer;
  std::string model;
  std::string comment;
};

/// The map as the bytes of an X3P file. With kInt16 the heights are rounded to 1/65000 of their range. Equal maps
/// give equal bytes. Throws InputError if no point is measured.
std::string x3p_bytes(const surface::HeightMap& map, X3pHeights heights, const X3pOrigin& origin);

}  // namespace ringfilm::instrument
