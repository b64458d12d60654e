#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/table/csv_file.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// The values of the column `name` in `si_unit`; empty, with a fault reported, if the column or its unit is missing or
/// wrong.
/// @param example a header that would do, e.g. "height [um]"
std::vector<double> quantity_column(const CsvFile& csv, const std::string& name, const std::string& si_unit,
                                    const std::string& example, const Units& units, std::vector<Fault>& faults);

/// What is wrong with crank angles: they do not rise from row to row, or span more than a cycle.
/// @param place of a sample in the file
std::optional<Fault> crank_angle_fault(const std::vector<double>& crank_angle_deg,
                                       const std::function<SourceMark(std::size_t)>& place);

}  // namespace ringfilm::io
