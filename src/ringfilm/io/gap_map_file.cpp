#include "ringfilm/io/gap_map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ringfilm/io/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

/// A column of the table as numbers, and where it stands.
struct Column {
  std::string name;
  std::size_t index = 0;
  std::vector<double> values;  ///< [m]
};

Column column_of(const CsvFile& csv, const std::string& name, const std::string& example, const Units& units,
                 std::vector<Fault>& faults) {
  Column column{name, 0, quantity_column(csv, name, "m", example, units, faults)};
  if (const auto found = csv.find(name)) column.index = *found;
  return column;
}

/// Puts points into lines: along a line the first coordinate runs, from line to line the second.
class Lines {
 public:
  Lines(const CsvFile& csv, const Column& along, const Column& across) : csv_(csv), along_(along), across_(across) {}

  /// Index of the first point of each line; throws where they are not alike.
  void check() {
    const std::vector<double>& a = along_.values;
    const std::vector<double>& b = across_.values;
    n_ = 1;
    while (n_ < a.size() && a[n_] >= a[n_ - 1] && b[n_] == b[0]) ++n_;
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (b[k] != b[k - k % n_]) {
        refuse(k, across_,
               fmt::format("{} changes after {} points, the first {} has {}", across_.name, k % n_, across_.name, n_));
      }
      if (a[k] != a[k % n_]) {
        refuse(k, along_,
               fmt::format("{0} = {1:.6g} mm stands here, where the first {2} has {0} = {3:.6g} mm", along_.name,
                           1e3 * a[k], across_.name, 1e3 * a[k % n_]));
      }
    }
    if (const std::size_t left = a.size() % n_; left != 0) {
      refuse(a.size() - 1, across_, fmt::format("the last {0} has {1} points, the first {2}", across_.name, left, n_));
    }
    if (n_ < 2 || a.size() / n_ < 2) {
      refuse(0, n_ < 2 ? along_ : across_, fmt::format("the map has only one {}", n_ < 2 ? along_.name : across_.name));
    }
  }

  std::size_t n_along() const { return n_; }
  std::size_t n_across() const { return along_.values.size() / n_; }

 private:
  [[noreturn]] void refuse(std::size_t row, const Column& column, const std::string& message) const {
    throw InputError(std::vector<Fault>{{csv_.cell_mark(row, column.index), message,
                                         "a full rectangle is wanted: every x with every y, all x of one y and then of "
                                         "the next, each in the same order"}});
  }

  const CsvFile& csv_;
  const Column &along_, &across_;
  std::size_t n_ = 1;
};

void check_number(const std::string& name, std::size_t n, const SourceMark& mark, std::vector<Fault>& faults) {
  if (n <= kMostGapPlaces) return;
  faults.push_back({mark, fmt::format("the map has {} places along {}", n, name),
                    fmt::format("at the most {} are read; thin it out", kMostGapPlaces)});
}

}  // namespace

void check_gap_places(const std::string& name, const std::vector<double>& places,
                      const std::function<SourceMark(std::size_t)>& mark_of, std::vector<Fault>& faults) {
  const std::size_t n = places.size();
  for (std::size_t i = 1; i < n; ++i) {
    if (places[i] < places[i - 1]) {
      faults.push_back(
          {mark_of(i), name + " falls from the row before to this one", name + " must not fall from row to row"});
      return;
    }
    if (places[i] != places[i - 1]) continue;
    if (i >= 2 && places[i - 2] == places[i]) {
      faults.push_back({mark_of(i), "this " + name + " comes three times",
                        "the same " + name + " twice is a step; keep two of them"});
      return;
    }
    if (i == 1 || i + 1 == n) {
      faults.push_back(
          {mark_of(i), "a step at an end of the pad", "a step is wanted inside, with a gap on both sides"});
      return;
    }
  }
}

GapMap gap_map_of(const CsvFile& csv, const Units& units) {
  std::vector<Fault> faults;
  const std::string word = !csv.find("h") && csv.find("height") ? "height" : "h";
  const Column x = column_of(csv, "x", "x [mm]", units, faults), y = column_of(csv, "y", "y [mm]", units, faults);
  const Column h = column_of(csv, word, word + " [um]", units, faults);
  if (!faults.empty()) throw InputError(faults);
  // Where y runs first, x stays.
  const bool y_runs_first = x.values[0] == x.values[1];
  const Column &along = y_runs_first ? y : x, &across = y_runs_first ? x : y;
  Lines lines(csv, along, across);
  lines.check();
  const std::size_t n = lines.n_along(), m = lines.n_across();
  std::vector<double> first(along.values.begin(), along.values.begin() + static_cast<std::ptrdiff_t>(n)), second;
  for (std::size_t k = 0; k < m; ++k) second.push_back(across.values[k * n]);
  check_number(along.name, n, csv.source.mark(0), faults);
  check_number(across.name, m, csv.source.mark(0), faults);
  check_gap_places(
      along.name, first, [&](std::size_t i) { return csv.cell_mark(i, along.index); }, faults);
  check_gap_places(
      across.name, second, [&](std::size_t i) { return csv.cell_mark(i * n, across.index); }, faults);
  if (!faults.empty()) throw InputError(faults);
  if (!y_runs_first) return {first, second, h.values};
  GapMap map{second, first, std::vector<double>(h.values.size())};
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) map.height[j * m + i] = h.values[i * n + j];
  }
  return map;
}

}  // namespace ringfilm::io
