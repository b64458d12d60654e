#include "gas_path/command_gas.hpp"

#include <fmt/format.h>

#include <iostream>

#include "output_names.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "text/summary.hpp"

namespace ringfilm::app {
namespace {

constexpr double kPerBar = 1e-5;

void check_csv(const GasOptions& options, const cycle::Case& input) {
  if (!options.csv) return;
  check_suffix("--csv", *options.csv, OutputKind::kCsv);
  io::check_can_write(*options.csv, io::Sink::kFileOrDevice);
  for (const cycle::InputFile& file : input.files) {
    if (!is_same_file(*options.csv, file.path)) continue;
    throw InputError(*options.csv + ": the output is a file that the case is read from", "name another file");
  }
}

std::string regions_table(const gas_path::GasPathResult& result) {
  std::string text = fmt::format("{:<14}{:>16}{:>16}{:>16}\n", "region", "peak", "at", "mean");
  for (const gas_path::RegionValues& region : result.regions) {
    text += fmt::format("{:<14}{:>12.4g} bar{:>9.1f} degree{:>12.4g} bar\n", region.name,
                        region.peak_pressure * kPerBar, region.peak_pressure_angle_deg, region.mean_pressure * kPerBar);
  }
  return text;
}

std::string events_table(const gas_path::GasPathResult& result) {
  if (result.events.empty()) return "";
  std::string text = "\nring   crank angle   event\n";
  for (const gas_path::RingEvent& event : result.events) {
    text += fmt::format("{:>4}{:>7.2f} degree   {}\n", event.ring, event.crank_angle_deg, event_name(event.event));
  }
  return text;
}

std::string gas_summary(const io::GasPathDocument& document) {
  const gas_path::GasPathResult& result = document.result;
  std::string text =
      fmt::format("{}\ngas of the ring pack over one cycle, {} cycles integrated\n\n", document.title, result.cycles);
  text += fmt::format("{:>14.4g} mg      blow-by per cycle\n", result.blow_by * 1e6);
  text += fmt::format("{:>14.4g} l/min   blow-by at 1.01325 bar and 25 degC\n", document.blow_by_flow * 6e4);
  text += fmt::format("{:>14.1e}         mass defect of the cycle\n\n", result.mass_defect);
  text += regions_table(result) + events_table(result) + "\n" + default_input_lines(document.inputs);
  for (const std::string& note : document.input_notes) text += "note: " + note + "\n";
  for (const cycle::Note& note : document.notes) text += "note: " + note.message + "\n";
  return text;
}

}  // namespace

void gas(const GasOptions& options) {
  const cycle::Case input = case_with_settings(options.case_path, options.overrides, cycle::CasePurpose::kGasPath);
  if (input.problem == cycle::Problem::kPad) {
    throw InputError(options.case_path + ": a pad has no ring pack", "name a case with [engine], [gas] and [[ring]]");
  }
  check_csv(options, input);
  const io::GasPathDocument document = io::gas_path_document(input);
  if (options.csv) io::write_atomically(*options.csv, io::gas_path_csv(document));
  if (options.summary == SummaryForm::kJson) {
    std::cout << io::gas_path_json(document);
    return;
  }
  std::cout << gas_summary(document);
  if (options.csv) std::cout << "wrote " << *options.csv << "\n";
}

}  // namespace ringfilm::app
