#include "gas_path/command_gas.hpp"

#include <fmt/format.h>

#include <iostream>

#include "gas_path/gas_tables.hpp"
#include "gas_path/gas_variations.hpp"
#include "output_names.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/run.hpp"
#include "text/summary.hpp"

namespace ringfilm::app {
namespace {

void check_output(const std::optional<std::string>& output, const char* option, OutputKind kind,
                  const cycle::Case& input) {
  if (!output) return;
  check_suffix(option, *output, kind);
  io::check_can_write(*output, kind == OutputKind::kCsv ? io::Sink::kFileOrDevice : io::Sink::kFile);
  for (const cycle::InputFile& file : input.files) {
    if (!is_same_file(*output, file.path)) continue;
    throw InputError(*output + ": the output is a file that the case is read from", "name another file");
  }
}

std::string gas_summary(const io::GasPathDocument& document) {
  const gas_path::GasPathResult& result = document.result;
  std::string text =
      fmt::format("{}\ngas of the ring pack over one cycle, {} cycles integrated\n\n", document.title, result.cycles);
  text += "blow-by per cylinder: " + blow_by_text(document.gas.sums) + "\n";
  text += fmt::format("mass defect of the cycle: {:.1e}\n\n", result.mass_defect);
  for (const std::string& table : {regions_table(document.gas), paths_table(document.gas),
                                   ring_motion_table(document.gas), ring_events_table(document.gas)}) {
    if (!table.empty()) text += table + "\n";
  }
  text += default_input_lines(document.inputs);
  for (const std::string& note : document.input_notes) text += "note: " + note + "\n";
  for (const cycle::Note& note : document.notes) text += "note: " + note.message + "\n";
  return text;
}

}  // namespace

namespace {

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
  check_output(options.csv, "--csv", OutputKind::kCsv, input);
  const std::vector<io::OutputClaim> claimed = claims({options.csv});
  const std::string table = gas_variations_csv(options.case_path, options.overrides, variations(options.varied));
  if (!options.csv) {
    std::cout << table;
    return;
  }
  io::write_atomically(*options.csv, table);
  std::cout << "wrote " << *options.csv << "\n";
}

}  // namespace

void gas(const GasOptions& options) {
  const cycle::Case input = case_with_settings(options.case_path, options.overrides, cycle::CasePurpose::kGasPath);
  print_settings_without_effect(options.overrides);
  if (!options.varied.empty()) return gas_of_variations(options, input);
  check_output(options.csv, "--csv", OutputKind::kCsv, input);
  check_output(options.output, "--output", OutputKind::kNetcdf, input);
  if (options.output && options.csv && is_same_file(*options.output, *options.csv)) {
    throw InputError(*options.csv + ": --output and --csv name the same file", "name two files");
  }
  const std::vector<io::OutputClaim> claimed = claims({options.csv, options.output});
  const auto document = std::get<io::GasPathDocument>(run::run_case(input).result);
  if (options.output) io::write_gas_path(*options.output, document);
  if (options.csv) io::write_atomically(*options.csv, io::gas_path_csv(document));
  if (options.summary == SummaryForm::kJson) {
    std::cout << io::gas_path_json(document);
    return;
  }
  std::cout << gas_summary(document);
  if (options.output) std::cout << "wrote " << *options.output << "\n";
  if (options.csv) std::cout << "wrote " << *options.csv << "\n";
}

}  // namespace ringfilm::app
