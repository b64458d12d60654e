#pragma once
#include <string>
#include <vector>

#include "command_options.hpp"
#include "measurement_outputs.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/surface/topography/preparation.hpp"

namespace ringfilm::app {

/// The case and --set of the commands that compute one.
void add_case(CommandOptions& add, CaseOptions& options);

/// --csv with or without a name. @param what it does, for the help
void add_csv(CommandOptions& add, CaseWithOutputs& options, const std::string& what);

/// --set of the commands that take a case as one of their inputs.
CLI::Option* add_settings(CommandOptions& add, std::vector<io::Override>& settings);

/// --output, --html, --json and, where there is something for a case, --fragment.
void add_outputs(CommandOptions& add, MeasurementOutputs& outputs, bool with_fragment);

/// --channel and --unit of every command that reads files of instruments.
/// --columns and --skip-lines: how a text file is read.
void add_table(CommandOptions& add, io::TableReading& table);
void add_channel_and_unit(CommandOptions& add, instrument::SurfaceOptions& reading);

/// Options of every command that reads height maps: what the file does not state, form and filters.
/// @param usual_form as the help shows it
/// @returns the option of the form
CLI::Option* add_map_options(CommandOptions& add, instrument::SurfaceOptions& reading,
                             surface::Preparation& preparation, const std::string& usual_form);

/// --jobs of ledger and error estimate.
void add_jobs(CommandOptions& add, int& threads);

/// --threads.
CLI::Option* add_threads(CommandOptions& add, int& threads);

}  // namespace ringfilm::app
