#pragma once
#include <memory>
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"

/// Files of Gwyddion (.gwy): objects within objects, each a list of named values.
namespace ringfilm::instrument {

/// Reads what the file holds: its images with title, units, size and mask (masked points are missing). Its curves and
/// volumes are passed over. Throws InputError for a damaged file or one without an image. @param file name for messages
InstrumentFile read_gwy(const std::string& file, std::shared_ptr<const std::string> bytes);

}  // namespace ringfilm::instrument
