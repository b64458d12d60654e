#include "measurement_outputs.hpp"

#include <iostream>
#include <optional>
#include <utility>

#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/measurement/measurement_netcdf.hpp"
#include "ringfilm/io/measurement/measurement_text.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/report/measurement_page.hpp"

namespace ringfilm::app {

std::vector<io::OutputClaim> claimed_outputs(const MeasurementOutputs& outputs,
                                             const std::vector<std::string>& inputs) {
  std::vector<std::pair<std::string, std::string>> named;
  const auto add = [&](const char* option, const std::optional<std::string>& path, io::Sink sink,
                       const std::optional<OutputKind>& kind) {
    if (!path) return;
    io::check_can_write(*path, sink);
    for (const std::string& input : inputs) {
      if (is_same_file(input, *path)) {
        throw InputError(std::string(option) + " " + *path + " would replace what is read", "name another file");
      }
    }
    for (const auto& [other, other_path] : named) {
      if (is_same_file(other_path, *path)) {
        throw InputError(std::string(option) + " and " + other + " name the same file " + *path, "name two files");
      }
    }
    if (kind) check_suffix(option, *path, *kind);
    named.emplace_back(option, *path);
  };
  add("--output", outputs.netcdf, io::Sink::kFile, OutputKind::kNetcdf);
  add("--html", outputs.page, io::Sink::kFileOrDevice, OutputKind::kPage);
  add("--fragment", outputs.fragment, io::Sink::kFileOrDevice, OutputKind::kToml);
  add("--csv", outputs.csv, io::Sink::kFileOrDevice, OutputKind::kCsv);
  add("--heights", outputs.heights, io::Sink::kFile, std::nullopt);
  return claims({outputs.netcdf, outputs.page, outputs.fragment, outputs.csv, outputs.heights});
}

io::NamedNumbers numbers_of(const io::Measurement& measurement) {
  io::NamedNumbers numbers;
  for (const io::MeasuredGroup& group : measurement.groups) {
    for (const io::MeasuredValue& value : group.values) numbers.emplace_back(value.name, value.value);
  }
  return numbers;
}

io::NamedLists lists_of(const io::Measurement& measurement, const std::string& table) {
  io::NamedLists lists;
  for (const io::MeasuredTable& one : measurement.tables) {
    if (one.name != table) continue;
    for (std::size_t k = 0; k < one.columns.size(); ++k) lists.emplace_back(one.columns[k].name, one.values[k]);
  }
  return lists;
}

void deliver(const io::Measurement& measurement, const MeasurementOutputs& outputs, const io::NamedNumbers& numbers,
             const io::NamedLists& lists, const io::NamedRows& rows) {
  const io::Units units;
  const io::Provenance provenance = io::this_program();
  std::string text;
  if (outputs.summary == SummaryForm::kJson) text = io::measurement_json(measurement, numbers, provenance, lists, rows);
  if (outputs.summary == SummaryForm::kTable) text = io::measurement_text(measurement, units);
  if (outputs.netcdf) io::write_measurement(*outputs.netcdf, measurement, provenance);
  if (outputs.page) {
    io::write_atomically(*outputs.page, ringfilm::report::measurement_page(measurement, units, provenance));
  }
  if (outputs.fragment) io::write_atomically(*outputs.fragment, measurement.fragment);
  std::cout << text;
  if (outputs.summary != SummaryForm::kTable) return;
  for (const auto& path : {outputs.netcdf, outputs.page, outputs.fragment, outputs.csv, outputs.heights}) {
    if (path) std::cout << "wrote " << *path << "\n";
  }
}

}  // namespace ringfilm::app
