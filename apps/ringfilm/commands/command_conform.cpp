#include "commands/commands.hpp"
#include "measurement_outputs.hpp"
#include "ringfilm/instrument/documents/conformity.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/measurement/section_numbers.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/run.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

/// What `conform` was asked for.
struct ConformCommand {
  std::string case_path;
  std::vector<io::Override> settings;  ///< overrides of keys of the case
  MeasurementOutputs outputs;
};

io::NamedRows::value_type rows_of(const io::Measurement& measurement, const std::string& table) {
  const io::NamedLists columns = lists_of(measurement, table);
  std::vector<std::vector<double>> rows(columns.front().second.size());
  for (const auto& [name, values] : columns) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(values[i]);
  }
  return {table, std::move(rows)};
}

/// The section of the ring, where the case states it.
io::NamedObjects section_of(const cycle::StaticClosure& closure) {
  if (!closure.section) return {};
  io::NamedLists members;
  for (io::SectionNumbers& one : io::section_numbers(*closure.section)) {
    members.emplace_back(std::move(one.name), std::move(one.value));
  }
  return {{"section", std::move(members)}};
}

/// Computes the static closure of the ring of a case in its bore, and writes what was asked for.
void conform(const ConformCommand& command) {
  const auto claimed = claimed_outputs(command.outputs, {command.case_path});
  std::vector<io::DroppedKey> dropped;
  const cycle::Case input = io::read_closure_case(command.case_path, command.settings, io::Units(), dropped);
  print_dropped(dropped);
  const auto closure = std::get<cycle::StaticClosure>(run::run_case(input).result);
  const io::Measurement measurement = instrument::conformity_of_case(input, closure);
  if (command.outputs.csv) io::write_atomically(*command.outputs.csv, instrument::conformity_csv(closure));
  deliver(measurement, command.outputs,
          {{},
           {{instrument::kContactPoints, lists_of(measurement, instrument::kContactPoints).front().second}},
           {rows_of(measurement, instrument::kContactArcs), rows_of(measurement, instrument::kPointForces),
            rows_of(measurement, instrument::kPressureOrders)},
           section_of(closure)});
}

constexpr const char* kConformFooter = R"(Examples:
  ringfilm conform cases/distorted-bore/followed.toml
  ringfilm conform case.toml --set ring.gap_position='45 degree' --json
  ringfilm conform case.toml --set conform.gas_pressure='3 bar' --csv around.csv --html conform.html

The case needs engine.bore, [ring] with face_width, radial_thickness and tension, and [liner] with its distortion;
keys of film and cycle may be stated or missing. Angles count from the middle of the gap.
)";

void declare_conform(CommandOptions& add, ConformCommand& command) {
  add.text("CASE.toml", command.case_path, "", "the case file")->required();
  add_settings(add, command.settings);
  add.text("--csv", command.outputs.csv, "X.csv", "write a row a degree: bore, clearance, forces, moment, SI units");
  add_outputs(add, command.outputs, false);
}

}  // namespace

void add_conform_command(Program& program) {
  program.add("conform",
              "Static closure of a ring in its bore: clearance, open area, contact arcs and force of the wall",
              kConformFooter, declare_conform, conform);
}

}  // namespace ringfilm::app
