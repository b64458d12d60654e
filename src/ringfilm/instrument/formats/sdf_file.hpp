#pragma once
#include <memory>
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"

/// Surface data files (.sdf, ISO 25178-71 and its forerunner of the BCR): a header, heights as text or binary, a
/// trailer.
namespace ringfilm::instrument {

/// Does the file start like an SDF, e.g. with "aISO-1.0" or "bBCR-1.0"?
bool is_sdf(const std::string& bytes);

/// Reads the header; lengths are in metres as the standard states. Missing points: BAD in a text file; in a binary one
/// NaN, the lowest number of a signed or floating type and the highest of an unsigned one of 16 or 32 bit. Throws
/// InputError.
/// @param file name for messages
InstrumentFile read_sdf(const std::string& file, std::shared_ptr<const std::string> bytes);

}  // namespace ringfilm::instrument
