#include "ringfilm/io/pad/pad_file.hpp"

#include <utility>

#include "ringfilm/io/pad/gap_map_file.hpp"
#include "ringfilm/io/table/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

/// The column `h`, or the one that spells the word out.
std::vector<double> thickness_column(const CsvFile& csv, const std::string& word, const Units& units,
                                     std::vector<Fault>& faults) {
  const std::string name = !csv.find("h") && csv.find(word) ? word : "h";
  std::vector<double> values = quantity_column(csv, name, "m", name + " [um]", units, faults);
  check_height_column(csv, name, values, faults);
  return values;
}

}  // namespace

GapFile read_gap(const NamedFile& file, const Units& units) {
  if (is_netcdf(file.path)) {
    GapMapFile read = read_gap_netcdf(file, units);
    return {std::move(read.map.x), std::move(read.map.y), std::move(read.map.height), std::move(read.sha256), {}};
  }
  const CsvFile csv = read_csv(file);
  if (csv.find("y")) {
    GapMap map = gap_map_of(csv, units);
    return {std::move(map.x), std::move(map.y), std::move(map.height), csv.source.sha256, csv.notes};
  }
  std::vector<Fault> faults;
  GapFile gap;
  gap.x = quantity_column(csv, "x", "m", "x [mm]", units, faults);
  gap.height = thickness_column(csv, "height", units, faults);
  std::vector<Fault> of_places;
  check_gap_column(
      "x", gap.x, [&](std::size_t i) { return csv.cell_mark(i, *csv.find("x")); }, of_places);
  constexpr std::size_t kAlongX = 2;  // columns
  if (!of_places.empty() && faults.empty() && csv.columns.size() > kAlongX) {
    faults.push_back({csv.source.mark(csv.header_line, 1), "x runs to and fro as in a map, and there is no column y",
                      "a map has the columns x, y and h; this file has: " + csv.names()});
  } else {
    faults.insert(faults.end(), of_places.begin(), of_places.end());
  }
  if (!faults.empty()) throw InputError(faults);
  gap.sha256 = csv.source.sha256;
  gap.notes = csv.notes;
  return gap;
}

SeparationHistory read_separation_history(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  SeparationHistory history;
  history.time = quantity_column(csv, "time", "s", "time [s]", units, faults);
  history.separation = thickness_column(csv, "separation", units, faults);
  for (std::size_t i = 1; i < history.time.size(); ++i) {
    if (history.time[i] > history.time[i - 1]) continue;
    faults.push_back({csv.cell_mark(i, *csv.find("time")),
                      history.time[i] == history.time[i - 1] ? "this time comes twice"
                                                             : "time falls from the row before to this one",
                      "time must increase from row to row"});
    break;
  }
  if (!faults.empty()) throw InputError(faults);
  history.sha256 = csv.source.sha256;
  history.notes = csv.notes;
  return history;
}

}  // namespace ringfilm::io
