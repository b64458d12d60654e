#include "measurement_outputs.hpp"

#include <iostream>
#include <optional>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/measurement/measurement_netcdf.hpp"
#include "ringfilm/io/measurement/measurement_text.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/report/measurement_page.hpp"

namespace ringfilm::app {
namespace {

std::vector<NamedOutput> named_outputs(const MeasurementOutputs& outputs) {
  using io::Sink;
  return {{"--output", outputs.netcdf, OutputKind::kNetcdf},
          {"--html", outputs.page, OutputKind::kPage, Sink::kFileOrDevice},
          {"--fragment", outputs.fragment, OutputKind::kToml, Sink::kFileOrDevice},
          {"--csv", outputs.csv, OutputKind::kCsv, Sink::kFileOrDevice},
          {"--heights", outputs.heights, std::nullopt}};
}

}  // namespace

std::vector<io::OutputClaim> claimed_outputs(const MeasurementOutputs& outputs, const std::vector<std::string>& inputs,
                                             const std::vector<NamedOutput>& further) {
  std::vector<NamedOutput> all = named_outputs(outputs);
  all.insert(all.end(), further.begin(), further.end());
  for (auto one = all.begin(); one != all.end(); ++one) {
    if (!one->path) continue;
    io::check_can_write(*one->path, one->sink);
    for (const std::string& input : inputs) {
      if (!is_same_file(input, *one->path)) continue;
      throw InputError(one->option + " " + *one->path + " would replace what is read", "name another file");
    }
    for (auto other = all.begin(); other != one; ++other) {
      if (!other->path || !is_same_file(*other->path, *one->path)) continue;
      throw InputError(one->option + " and " + other->option + " name the same file " + *one->path, "name two files");
    }
    if (one->kind) check_suffix(one->option, *one->path, *one->kind);
  }
  return claims(all);
}

io::NamedLists lists_of(const io::Measurement& measurement, const std::string& table) {
  io::NamedLists lists;
  for (const io::MeasuredTable& one : measurement.tables) {
    if (one.name != table) continue;
    for (std::size_t k = 0; k < one.columns.size(); ++k) lists.emplace_back(one.columns[k].name, one.values[k]);
  }
  return lists;
}

void deliver(const io::Measurement& measurement, const MeasurementOutputs& outputs, const JsonTop& top) {
  const io::Units units;
  const io::Provenance provenance = io::this_program();
  std::string text;
  if (outputs.summary == SummaryForm::kJson) {
    io::NamedNumbers numbers = top.numbers;
    for (const io::MeasuredGroup& group : measurement.groups) {
      for (const io::MeasuredValue& value : group.values) numbers.emplace_back(value.name, value.value);
    }
    text = io::measurement_json(measurement, numbers, provenance, top.lists, top.rows, top.objects);
  }
  if (outputs.summary == SummaryForm::kTable) text = io::measurement_text(measurement, units);
  if (outputs.netcdf) io::write_measurement(*outputs.netcdf, measurement, provenance);
  if (outputs.page) {
    io::write_atomically(*outputs.page, ringfilm::report::measurement_page(measurement, units, provenance));
  }
  if (outputs.fragment) io::write_atomically(*outputs.fragment, measurement.fragment);
  std::cout << text;
  if (outputs.summary == SummaryForm::kTable) print_written(named_outputs(outputs));
}

}  // namespace ringfilm::app
