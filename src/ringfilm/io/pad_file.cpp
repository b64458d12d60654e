#include "ringfilm/io/pad_file.hpp"

#include "ringfilm/io/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

/// The column `h`, or the one that spells the word out.
std::vector<double> thickness_column(const CsvFile& csv, const std::string& word, const Units& units,
                                     std::vector<Fault>& faults) {
  const std::string name = !csv.find("h") && csv.find(word) ? word : "h";
  return quantity_column(csv, name, "m", name + " [um]", units, faults);
}

/// Steps are allowed: an x twice, but not three times, nor at an end, where no film lies beyond.
void check_places(const CsvFile& csv, const std::vector<double>& x, std::vector<Fault>& faults) {
  const std::size_t n = x.size();
  for (std::size_t i = 1; i < n; ++i) {
    const SourceMark mark = csv.cell_mark(i, *csv.find("x"));
    if (x[i] < x[i - 1]) {
      faults.push_back({mark, "x falls from the row before to this one", "x must not fall from row to row"});
      return;
    }
    if (x[i] != x[i - 1]) continue;
    if (i >= 2 && x[i - 2] == x[i]) {
      faults.push_back({mark, "this x comes three times", "the same x twice is a step; keep two of them"});
      return;
    }
    if (i == 1 || i + 1 == n) {
      faults.push_back({mark, "a step at an end of the pad", "a step is wanted inside, with a gap on both sides"});
      return;
    }
  }
}

}  // namespace

GapFile read_gap(const NamedFile& file, const Units& units) {
  const CsvFile csv = read_csv(file);
  std::vector<Fault> faults;
  GapFile gap;
  gap.x = quantity_column(csv, "x", "m", "x [mm]", units, faults);
  gap.height = thickness_column(csv, "height", units, faults);
  check_places(csv, gap.x, faults);
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
