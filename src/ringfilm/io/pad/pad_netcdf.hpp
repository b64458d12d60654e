#pragma once
#include <string>

#include "ringfilm/io/pad/pad_output.hpp"

namespace ringfilm::io {

/// Writes NetCDF-4: film_thickness, pressure and film content over (time, y, x), of an infinitely wide pad over (time,
/// x), a step of the gap with its place twice; every number of pad::reported_quantities() over time; the case as it was
/// used and the notes as text. Written aside first, then renamed. Same document, same bytes. Throws OutputError.
void write_pad(const std::string& path, const PadDocument& document);

}  // namespace ringfilm::io
