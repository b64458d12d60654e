#pragma once
#include <cstddef>
#include <memory>
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"
#include "ringfilm/surface/topography/topography.hpp"

/// Surfaces and profiles of Digital Surf (.sur, .pro): a header of 512 bytes, a comment, heights as whole numbers.
namespace ringfilm::instrument {

/// Reads the header. Heights of 16 and 32 bit, both byte orders, as they are or packed (DSCOMPRESSED); one surface or
/// profile, or the first layer of a surface with further ones. Points that were not measured are those two below the
/// smallest height, where the header states that there are any. Throws InputError, also for files of other kinds.
/// @param file name for messages
InstrumentFile read_digital_surf(const std::string& file, std::shared_ptr<const std::string> bytes);

/// The map as the bytes of a .sur file: 32-bit heights in steps of `resolution_m`, lengths in um. Equal maps give
/// equal bytes. Throws InputError if a height does not fit 32 bit.
/// @param comment the description that the file contains; cut at 2000 bytes
std::string digital_surf_bytes(const surface::HeightMap& map, double resolution_m, const std::string& name,
                               const std::string& comment = "");

}  // namespace ringfilm::instrument
