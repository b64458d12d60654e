#pragma once
#include <string>

#include "ringfilm/instrument/grid/channel.hpp"

/// X3P (ISO 25178-72, formerly ISO 5436-2): a zip archive of main.xml, its check sum and the binary points.
namespace ringfilm::instrument {

/// Does the zip archive hold the main.xml of an X3P? Throws InputError for a damaged archive.
bool is_x3p(const std::string& path);

/// Reads main.xml, whose check sum must be right. Profiles, surfaces and lists of points on an even grid; heights of
/// all four types, as binary or within the XML; axes by step or by place; layers are channels. Missing points: NaN, an
/// empty datum, the mask of valid points. The check sums of the binary parts are verified with the values. Lengths are
/// in metres as the standard states. Throws InputError.
InstrumentFile read_x3p(const std::string& path);

}  // namespace ringfilm::instrument
