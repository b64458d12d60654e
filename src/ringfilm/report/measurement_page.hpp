#pragma once
#include <string>

#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::report {

/// What instruments gave, as one self-contained web page: key values, height maps, curves, tables and the fragment for
/// a case. Maps are averaged over blocks and long curves thinned to their highs and lows, which their captions state.
/// Throws std::logic_error as io::check_measurement does.
std::string measurement_page(const io::Measurement& measurement, const io::Units& units,
                             const io::Provenance& provenance);

}  // namespace ringfilm::report
