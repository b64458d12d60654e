#pragma once
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"

namespace ringfilm::instrument {

/// Does a file begin as an SMD file: two lines, then one of the axis CX, before the first end of a section?
bool is_smd(const std::string& bytes);

/// Reads a profile of an SMD file, the surface material data of ISO 5436-2 in which softgauges are published and
/// programs of stylus instruments exchange profiles: sections that end with ETX, words that end with NUL. A header of
/// revision, feature (PRF) and the axes CX and CZ, each with its type, number of points, unit, scale, type of data and
/// increment; then keywords, the heights, one a line, and the sum of all bytes before it, modulo 65535. The x axis must
/// be incremental. Another sum is noted. Throws InputError with the line, the rule and the remedy.
InstrumentFile read_smd(const std::string& file, const std::string& bytes);

}  // namespace ringfilm::instrument
