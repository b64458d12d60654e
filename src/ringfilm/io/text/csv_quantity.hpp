#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/text/csv_file.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// The values of the column `name` in `si_unit`; empty, with a fault reported, if the column or its unit is missing or
/// wrong.
/// @param example a header that would do, e.g. "height [um]"
std::vector<double> quantity_column(const CsvFile& csv, const std::string& name, const std::string& si_unit,
                                    const std::string& example, const Units& units, std::vector<Fault>& faults);

/// What is wrong with the crank angles of a column: they do not rise from row to row, or span more than a cycle.
std::optional<Fault> crank_angle_fault(const CsvFile& csv, std::size_t i_column,
                                       const std::vector<double>& crank_angle_deg);

}  // namespace ringfilm::io
