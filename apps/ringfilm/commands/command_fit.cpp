#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "inverse/inverse_files.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/io/inverse/case_elsewhere.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/inverse/run_inverse.hpp"
#include "stop_request.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kFittedCase = "fitted.toml";

std::string shown(const io::Units& units, double value, const study::Variable& variable) {
  return units.shown(value, variable.unit, variable.display_unit, 5);
}

std::string fit_summary(const io::FitDocument& document) {
  const io::Units units;
  const study::FitResult& result = document.result;
  std::string text = fmt::format("{}\n", document.file.problem.title);
  std::vector<std::vector<std::string>> rows = {{"parameter", "value", "95 % interval", "", "identified"}};
  for (std::size_t j = 0; j < result.parameters.size(); ++j) {
    const study::FitParameter& parameter = document.file.problem.parameters[j];
    const study::FittedParameter& fitted = result.parameters[j];
    rows.push_back(
        {parameter.name(), shown(units, fitted.value, parameter), shown(units, fitted.low, parameter),
         "to " + shown(units, fitted.high, parameter) + (fitted.at_lower || fitted.at_upper ? " (bound)" : ""),
         fitted.identified ? "yes" : "NO"});
  }
  text += aligned_table(rows);
  text += fmt::format("residuals: {} times the stated deviations, root mean square of {} values\n",
                      number_text(result.residual_rms, 3), result.n_values);
  for (std::size_t i = 0; i < result.series.size(); ++i) {
    const cycle::Quantity& quantity = document.file.problem.measured[i].quantity;
    const auto in_units = [&](double x) { return units.shown(x, quantity.unit, quantity.display_unit, 3); };
    text += fmt::format("  {}: residual {}", quantity.name, in_units(result.series[i].residual_rms));
    if (result.series[i].discrepancy > 0) {
      text += fmt::format(", discrepancy of the model {}", in_units(result.series[i].discrepancy));
    }
    text += "\n";
  }
  for (const study::FittedNuisance& nuisance : result.nuisances) {
    const cycle::Quantity& quantity = document.file.problem.measured[nuisance.measured].quantity;
    const auto in_units = [&](double x) {
      if (nuisance.name == "scale") return number_text(x, 3);
      if (nuisance.name == "angle_shift") return number_text(x, 3) + " degree";
      return units.shown(x, quantity.unit, quantity.display_unit, 3);
    };
    text += fmt::format("  {} of {}: {} with a deviation of {}\n", nuisance.name, quantity.name,
                        in_units(nuisance.value), in_units(nuisance.deviation));
  }
  for (const std::string& words : result.not_identified) text += fmt::format("not identified: {}\n", words);
  for (const std::string& note : result.notes) text += fmt::format("note: {}\n", note);
  return text + fmt::format("{} cases were computed, {} of {} starts ended at this fit\n", document.n_computed,
                            result.n_starts_agreed, document.file.problem.starts);
}

void write_fit(const InverseRequest& request, const io::FitDocument& document) {
  const std::string json = io::fit_json(document);
  const auto path = [&](const std::string& name) { return in_folder(request.output, name); };
  const std::vector<std::pair<std::string, std::string>> files = {
      {"fit.json", json},
      {"residuals.csv", io::fit_csv(document)},
      {kFittedCase, io::resolved_case_in(request.output, document.fitted, {"The case with the fitted values."})},
      {"fitted_study.toml", io::fit_study(document, kFittedCase)}};
  for (const auto& [name, content] : files) io::write_atomically(path(name), content);
  if (request.json) {
    std::cout << json;
    return;
  }
  std::cout << fit_summary(document);
  for (const auto& [name, content] : files) std::cout << "wrote " << path(name) << "\n";
}

void fit_case(const InverseRequest& request) {
  io::FitFile file = run::read_fit(request.path);
  io::PointStore store(prepared_store(request));
  const StopRequest stop;
  write_fit(request, run::run_fit(std::move(file), store, inverse_options(request, stop)));
}

constexpr const char* kFitFooter = R"(Examples:
  ringfilm fit fit.toml
  ringfilm fit fit.toml -o results --json

The folder of the output has every case that was computed (points.jsonl): after a kill the same command continues with
them. docs/manual/fit.md describes the file.
)";

void declare_fit(CommandOptions& add, InverseRequest& request) {
  declare_inverse(add, request,
                  {"FIT.toml", "file of the fit", "folder for results (default ./<fit>)",
                   "print the fit as JSON, SI units, instead of the table"});
}

}  // namespace

void add_fit_command(Program& program) {
  program.add("fit", "Fit numbers of a case to measurements, with their uncertainty", kFitFooter, declare_fit,
              fit_case);
}

}  // namespace ringfilm::app
