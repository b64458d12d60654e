#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/measurement/measurement_json.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::app {

/// Where the document of a measuring command goes.
struct MeasurementOutputs {
  std::optional<std::string> netcdf;    ///< --output
  std::optional<std::string> page;      ///< --html
  std::optional<std::string> fragment;  ///< --fragment: TOML for a case
  std::optional<std::string> csv;       ///< --csv: of a static closure, which its command writes
  std::optional<std::string> heights;   ///< --heights: of a surface, which its command writes
  SummaryForm summary = SummaryForm::kTable;
};

/// Claims them, to be held until all are written: can all be written, are they different files, none of them among
/// `inputs`, and none being written by another run? Throws InputError; to be asked before anything is computed.
[[nodiscard]] std::vector<io::OutputClaim> claimed_outputs(const MeasurementOutputs& outputs,
                                                           const std::vector<std::string>& inputs);

/// The values of all groups by their names, for the top of the JSON.
io::NamedNumbers numbers_of(const io::Measurement& measurement);

/// The columns of a table by their names, for the top of the JSON.
io::NamedLists lists_of(const io::Measurement& measurement, const std::string& table);

/// Writes what was asked for and prints the document. Throws OutputError.
/// @param numbers that are at the top of the JSON @param lists likewise @param rows likewise
void deliver(const io::Measurement& measurement, const MeasurementOutputs& outputs, const io::NamedNumbers& numbers,
             const io::NamedLists& lists = {}, const io::NamedRows& rows = {});

}  // namespace ringfilm::app
