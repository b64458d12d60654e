#include <CLI/CLI.hpp>

#include "text/command_arguments.hpp"

namespace ringfilm::app {

void OutputArguments::add_to(CLI::App& command, bool with_fragment) {
  command.add_option("-o,--output", outputs.netcdf, "write everything as NetCDF-4")->type_name("X.nc");
  command.add_option("--html", outputs.page, "write everything as one self-contained web page")->type_name("X.html");
  if (with_fragment) {
    command
        .add_option("--fragment", outputs.fragment,
                    "write what a case needs; a case reads it with include = [\"X.toml\"]")
        ->type_name("X.toml");
  }
  command.add_flag("--json", json, "print JSON, SI units, instead of the table");
}

MeasurementOutputs OutputArguments::selected() const {
  MeasurementOutputs requested = outputs;
  requested.summary = json ? SummaryForm::kJson : SummaryForm::kTable;
  return requested;
}

}  // namespace ringfilm::app
