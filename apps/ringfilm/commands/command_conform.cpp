#include "commands/command_conform.hpp"

#include <iostream>

#include "ringfilm/instrument/documents/conformity.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::app {
namespace {

io::NamedRows rows_of(const io::Measurement& measurement, const std::string& table) {
  const io::NamedLists columns = lists_of(measurement, table);
  std::vector<std::vector<double>> rows(columns.front().second.size());
  for (const auto& [name, values] : columns) {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(values[i]);
  }
  return {{table, std::move(rows)}};
}

}  // namespace

void conform(const ConformCommand& command) {
  const auto claimed = claimed_outputs(command.outputs, {command.case_path});
  std::vector<io::DroppedKey> dropped;
  const cycle::Case input = io::read_closure_case(command.case_path, command.settings, io::Units(), dropped);
  if (!dropped.empty()) {
    std::cerr << "--set makes keys of the case unused, they are dropped: " << io::listed(dropped) << "\n";
  }
  const auto closure = std::get<cycle::StaticClosure>(run::run_case(input).result);
  const io::Measurement measurement = instrument::conformity_of_case(input, closure);
  if (command.outputs.csv) io::write_atomically(*command.outputs.csv, instrument::conformity_csv(closure));
  io::NamedRows rows = rows_of(measurement, instrument::kContactArcs);
  for (const char* table : {instrument::kPointForces, instrument::kPressureOrders}) {
    const io::NamedRows more = rows_of(measurement, table);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  deliver(measurement, command.outputs, numbers_of(measurement),
          {{instrument::kContactPoints, lists_of(measurement, instrument::kContactPoints).front().second}}, rows);
}

}  // namespace ringfilm::app
