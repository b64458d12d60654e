#include "gas_path/command_gas.hpp"

#include <fmt/format.h>

#include <iostream>
#include <numbers>

#include "gas_path/gas_variations.hpp"
#include "output_names.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "text/summary.hpp"

namespace ringfilm::app {
namespace {

constexpr double kPerBar = 1e-5;

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

std::string twist_cell(const gas_path::RingMotionValues& ring) {
  if (!ring.largest_static_twist) return "";
  const double twist = *ring.largest_static_twist * 180 / std::numbers::pi;
  if (twist == 0) return "       none";
  return fmt::format("{:>11.2g} degree at {:.0f}", twist, ring.largest_static_twist_angle_deg);
}

std::string seating_table(const gas_path::GasPathResult& result) {
  std::string text = "\nring   least force on the lower flank   unseated   largest static twist\n";
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    const gas_path::RingMotionValues& ring = result.motion[i];
    if (!ring.has_groove) continue;
    text += fmt::format("{:>4}{:>12.4g} N at{:>6.0f} degree{:>11.1f} %{}\n", i + 1, ring.least_seating_force,
                        ring.least_seating_force_angle_deg, 100 * ring.unseated_share, twist_cell(ring));
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
  text += regions_table(result) + seating_table(result) + events_table(result) + "\n" +
          default_input_lines(document.inputs);
  for (const std::string& note : document.input_notes) text += "note: " + note + "\n";
  for (const cycle::Note& note : document.notes) text += "note: " + note.message + "\n";
  return text;
}

}  // namespace

namespace {

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
  if (input.problem == cycle::Problem::kPad) {
    throw InputError(options.case_path + ": a pad has no ring pack", "name a case with [engine], [gas] and [[ring]]");
  }
  if (!options.varied.empty()) return gas_of_variations(options, input);
  check_output(options.csv, "--csv", OutputKind::kCsv, input);
  check_output(options.output, "--output", OutputKind::kNetcdf, input);
  const std::vector<io::OutputClaim> claimed = claims({options.csv, options.output});
  const io::GasPathDocument document = io::gas_path_document(input);
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
