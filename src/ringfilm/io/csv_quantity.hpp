#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/csv_file.hpp"
#include "ringfilm/io/units.hpp"

namespace ringfilm::io {

/// The values of the column `name` in `si_unit`; empty, with a fault told, if the column or its unit is missing or
/// wrong.
/// @param example a header that would do, e.g. "height [um]"
std::vector<double> quantity_column(const CsvFile& csv, const std::string& name, const std::string& si_unit,
                                    const std::string& example, const Units& units, std::vector<Fault>& faults);

}  // namespace ringfilm::io
