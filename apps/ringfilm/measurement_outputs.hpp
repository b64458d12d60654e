#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "output_names.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/measurement/measurement_json.hpp"

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
/// @param further outputs of one command alone
[[nodiscard]] std::vector<io::OutputClaim> claimed_outputs(const MeasurementOutputs& outputs,
                                                           const std::vector<std::string>& inputs,
                                                           const std::vector<NamedOutput>& further = {});

/// The columns of a table by their names, for the top of the JSON.
io::NamedLists lists_of(const io::Measurement& measurement, const std::string& table);

/// What the JSON has at its top beside the values of all groups.
struct JsonTop {
  io::NamedNumbers numbers;  ///< before those values
  io::NamedLists lists;
  io::NamedRows rows;
  io::NamedObjects objects = {};
};

/// Writes what was asked for and prints the document. Throws OutputError.
void deliver(const io::Measurement& measurement, const MeasurementOutputs& outputs, const JsonTop& top = {});

}  // namespace ringfilm::app
