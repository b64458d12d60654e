#pragma once
#include <string>

#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// Writes the document as NetCDF-4 in SI: values as scalars, each curve and table over a dimension of its own, maps
/// over (y, x) with coordinates [m]. Aside first, flushed, then renamed. Same document, same bytes. Throws OutputError,
/// and std::logic_error as check_measurement does.
void write_measurement(const std::string& path, const Measurement& measurement, const Provenance& provenance);

}  // namespace ringfilm::io
