#pragma once
#include <memory>
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"
#include "ringfilm/surface/topography/topography.hpp"

/// Gwyddion Simple Field (.gsf): lines of text, zeros up to a multiple of four bytes, heights as 32-bit floats.
namespace ringfilm::instrument {

/// Reads the header. A size that the file omits is not taken as 1 m but left open. NaN is a missing point. Throws
/// InputError. @param file name for messages
InstrumentFile read_simple_field(const std::string& file, std::shared_ptr<const std::string> bytes);

/// The map as the bytes of a .gsf file, in metres. Equal maps give equal bytes.
std::string simple_field_bytes(const surface::HeightMap& map, const std::string& title);

}  // namespace ringfilm::instrument
