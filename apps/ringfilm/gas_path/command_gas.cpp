#include <fmt/format.h>

#include <iostream>

#include "commands/commands.hpp"
#include "gas_path/gas_tables.hpp"
#include "gas_path/gas_variations.hpp"
#include "output_names.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/run.hpp"
#include "text/shared_options.hpp"
#include "text/summary.hpp"

namespace ringfilm::app {
namespace {

/// What `gas` was asked for.
struct GasOptions : CaseWithOutputs {
  std::vector<std::string> varied;  ///< as written: KEY=VALUE, VALUE, ...
};

std::vector<NamedOutput> outputs_of(const GasOptions& options) {
  return {{"--output", options.output, OutputKind::kNetcdf},
          {"--csv", options.csv, OutputKind::kCsv, io::Sink::kFileOrDevice}};
}

/// Claims the outputs. Throws InputError where one of them cannot be written.
std::vector<io::OutputClaim> claimed_outputs(const GasOptions& options, const cycle::Case& input) {
  Faults faults;
  check_names(outputs_of(options), faults);
  check_apart(outputs_of(options), input.files, "case", faults);
  faults.check();
  return claims(outputs_of(options));
}

std::string gas_summary(const io::GasPathDocument& document) {
  const gas_path::GasPathResult& result = document.result;
  std::string text =
      fmt::format("{}\ngas of the ring pack over one cycle, {} cycles integrated\n\n", document.title, result.cycles);
  text += "blow-by per cylinder: " + blow_by_text(document.gas.sums) + reverse_blow_by_text(document.gas.sums) + "\n";
  text += fmt::format("mass defect of the cycle: {:.1e}\n\n", result.mass_defect);
  for (const std::string& table :
       {regions_table(document.gas), paths_table(document.gas), composition_table(document.gas),
        ring_motion_table(document.gas), ring_events_table(document.gas)}) {
    if (!table.empty()) text += table + "\n";
  }
  text += default_input_lines(document.inputs);
  for (const std::string& note : document.input_notes) text += "note: " + note + "\n";
  for (const cycle::Note& note : document.notes) text += "note: " + note.message + "\n";
  return text;
}

/// Settings that the gas alone does not use, on standard error: they may be meant for another command.
void print_settings_without_effect(const std::vector<io::Override>& overrides) {
  std::string keys;
  for (const io::Override& one : overrides) {
    const bool is_title = one.key == "title";  // which is printed
    if (!one.value.empty() && !is_title && !acts_on_gas(one.key)) keys += (keys.empty() ? "" : ", ") + one.key;
  }
  if (!keys.empty()) std::cerr << "--set states keys that the gas alone does not use: " << keys << "\n";
}

/// The table of all combinations of varied values, on standard output or in a file.
void gas_of_variations(const GasOptions& options, const cycle::Case& input) {
  if (options.output || options.summary == SummaryForm::kJson) {
    throw InputError("--vary prints a table of all combinations, and --output or --json are of one",
                     "leave --vary out, or take the table as CSV with --csv X.csv");
  }
  const std::vector<io::OutputClaim> claimed = claimed_outputs(options, input);
  const std::string table =
      gas_variations_csv(options.case_path, options.overrides, variations(options.varied, vary_form()));
  if (!options.csv) {
    std::cout << table;
    return;
  }
  io::write_atomically(*options.csv, table);
  print_written(outputs_of(options));
}

/// Computes the gas of a ring pack over a cycle.
void gas(const GasOptions& options) {
  const cycle::Case input = case_with_settings(options.case_path, options.overrides, cycle::CasePurpose::kGasPath);
  print_settings_without_effect(options.overrides);
  if (!options.varied.empty()) return gas_of_variations(options, input);
  const std::vector<io::OutputClaim> claimed = claimed_outputs(options, input);
  const auto document = std::get<io::GasPathDocument>(run::run_case(input).result);
  if (options.output) io::write_gas_path(*options.output, document);
  if (options.csv) io::write_atomically(*options.csv, io::gas_path_csv(document));
  if (options.summary == SummaryForm::kJson) {
    std::cout << io::gas_path_json(document);
    return;
  }
  std::cout << gas_summary(document);
  print_written(outputs_of(options));
}

constexpr const char* kGasFooter = R"(Examples:
  ringfilm gas cases/ring-pack/two_rings.toml
  ringfilm gas cases/ring-pack/two_rings.toml --set gas_path.ring_motion=axial --json
  ringfilm gas case.toml --set operating.speed='4500 rpm' --csv gas.csv
  ringfilm gas case.toml --vary operating.speed='1000 rpm, 3000 rpm' --vary ring.1.end_gap='0.25 mm, 0.5 mm'

The gas alone is computed: keys of oil, contact and film may be missing.
)";

void declare_gas(CommandOptions& add, GasOptions& options) {
  add_case(add, options);
  add.text("-o,--output", options.output, "X.nc", "write values and curves of the gas as NetCDF-4");
  add.texts("--vary", options.varied, "KEY=VALUE,VALUE,...",
            "compute all combinations of the values of one or more keys (repeat it) and print blow-by and peak "
            "pressures of each as CSV");
  add_csv(add, options, "write pressures, flows and ring positions over crank angle as CSV, SI units");
  add.json(options.summary, "print the values as JSON instead of the table");
}

}  // namespace

void add_gas_command(Program& program) {
  program.add("gas", "Compute the gas between the rings of a pack: pressures, blow-by, ring motion", kGasFooter,
              declare_gas, gas);
}

}  // namespace ringfilm::app
