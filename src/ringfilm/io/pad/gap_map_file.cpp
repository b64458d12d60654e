#include "ringfilm/io/pad/gap_map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/io/table/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

/// A column of the table as numbers, and where it is.
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
    check_first_line();
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (b[k] != b[k - k % n_]) {
        refuse(k, across_,
               fmt::format("{} changes after {} points, the first {} has {}", across_.name, k % n_, across_.name, n_));
      }
      if (a[k] != a[k % n_]) {
        refuse(k, along_,
               fmt::format("{0} = {1} is given here, where the first {2} has {0} = {3}", along_.name,
                           text_in(a[k], kMillimetre), across_.name, text_in(a[k % n_], kMillimetre)));
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
  /// The others are measured by the first line: what is wrong with that would be reported of them.
  void check_first_line() const {
    const std::vector<double>& a = along_.values;
    const std::vector<double>& b = across_.values;
    const std::size_t n = a.size();
    if (n_ < n && b[n_] == b[0] && a[n_] < a[n_ - 1] && a[n_] > a[0]) {
      refuse(n_, along_, fmt::format("{0} falls within the first {1}", along_.name, across_.name));
    }
    std::size_t falls = 1;
    while (falls < n && a[falls] < a[falls - 1] && b[falls] == b[0]) ++falls;
    if (falls > 1) {
      refuse(1, along_, fmt::format("{0} falls within the first {1}", along_.name, across_.name),
             along_.name + " must not fall from point to point: turn the lines round");
    }
    // A point that is missing in the first line is given in all others.
    std::size_t begin = n_, longest = 0, alike = 0, n_lines = 0;
    while (begin < n) {
      std::size_t end = begin + 1;
      while (end < n && b[end] == b[begin] && a[end] >= a[end - 1]) ++end;
      if (end - begin == n_ + 1) ++alike;
      longest = std::max(longest, end - begin);
      ++n_lines;
      begin = end;
    }
    if (n_lines == 0 || alike != n_lines || longest != n_ + 1) return;
    std::size_t k = 0;
    while (k < n_ && a[k] == a[n_ + k]) ++k;
    refuse(std::min(k, n_ - 1), along_,
           fmt::format("the first {} has no point at {} = {}, which all others have", across_.name, along_.name,
                       text_in(a[n_ + k], kMillimetre)));
  }

  [[noreturn]] void refuse(std::size_t row, const Column& column, const std::string& message,
                           const std::string& remedy) const {
    throw InputError(std::vector<Fault>{{csv_.cell_mark(row, column.index), message, remedy}});
  }

  [[noreturn]] void refuse(std::size_t row, const Column& column, const std::string& message) const {
    refuse(row, column, message,
           "a full rectangle is required: every x with every y, all x of one y and then of the next, each in the same "
           "order");
  }

  const CsvFile& csv_;
  const Column &along_, &across_;
  std::size_t n_ = 1;
};

void check_number(const std::string& name, std::size_t n, const SourceMark& mark, std::vector<Fault>& faults) {
  if (n <= kMaxGapPlaces) return;
  faults.push_back({mark, fmt::format("the map has {} places along {}", n, name),
                    fmt::format("at the most {} are read; thin it out", kMaxGapPlaces)});
}

}  // namespace

std::optional<WrongPlace> wrong_place(const std::vector<double>& places) {
  const std::size_t n = places.size();
  for (std::size_t i = 1; i < n; ++i) {
    if (places[i] < places[i - 1]) return WrongPlace{i, PlaceFault::kFalls};
    if (places[i] != places[i - 1]) continue;
    if (i >= 2 && places[i - 2] == places[i]) return WrongPlace{i, PlaceFault::kThreeTimes};
    if (i == 1 || i + 1 == n) return WrongPlace{i, PlaceFault::kStepAtEnd};
  }
  return std::nullopt;
}

void check_gap_column(const std::string& name, const std::vector<double>& places,
                      const std::function<SourceMark(std::size_t)>& mark_of, std::vector<Fault>& faults) {
  const auto wrong = wrong_place(places);
  if (!wrong) return;
  const SourceMark mark = mark_of(wrong->index);
  switch (wrong->fault) {
    case PlaceFault::kFalls:
      faults.push_back(
          {mark, name + " falls from the row before to this one", name + " must not fall from row to row"});
      return;
    case PlaceFault::kThreeTimes:
      faults.push_back({mark, fmt::format("this {} comes three times", name),
                        fmt::format("the same {} twice is a step; keep two of them", name)});
      return;
    case PlaceFault::kStepAtEnd:
      faults.push_back({mark, "a step at an end of the pad", "a step is required inside, with a gap on both sides"});
      return;
  }
}

std::optional<std::size_t> implausible_height(const std::vector<double>& heights) {
  const auto found =
      std::find_if(heights.begin(), heights.end(), [](double height) { return std::abs(height) > kMaxGap; });
  return found == heights.end() ? std::nullopt : std::optional<std::size_t>(found - heights.begin());
}

std::string implausible_height_text(double height) {
  return fmt::format("{:.6g} m is not the thickness of an oil film", height);
}

void check_height_column(const CsvFile& csv, const std::string& name, const std::vector<double>& heights,
                         std::vector<Fault>& faults) {
  if (const auto k = implausible_height(heights)) {
    faults.push_back(
        {csv.cell_mark(*k, *csv.find(name)), implausible_height_text(heights[*k]), kImplausibleHeightRemedy});
  }
}

GapMap gap_map_of(const CsvFile& csv, const Units& units) {
  std::vector<Fault> faults;
  const std::string word = !csv.find("h") && csv.find("height") ? "height" : "h";
  const Column x = column_of(csv, "x", "x [mm]", units, faults), y = column_of(csv, "y", "y [mm]", units, faults);
  const Column h = column_of(csv, word, word + " [um]", units, faults);
  check_height_column(csv, word, h.values, faults);
  if (!faults.empty()) throw InputError(faults);
  // Where y runs first, x stays.
  std::size_t turn = 1;
  while (turn + 1 < x.values.size() && x.values[turn] == x.values[0] && y.values[turn] == y.values[0]) ++turn;
  const bool y_runs_first = x.values[turn] == x.values[0];
  const Column &along = y_runs_first ? y : x, &across = y_runs_first ? x : y;
  Lines lines(csv, along, across);
  lines.check();
  const std::size_t n = lines.n_along(), m = lines.n_across();
  std::vector<double> first(along.values.begin(), along.values.begin() + static_cast<std::ptrdiff_t>(n)), second;
  for (std::size_t k = 0; k < m; ++k) second.push_back(across.values[k * n]);
  check_number(along.name, n, csv.source.mark(0), faults);
  check_number(across.name, m, csv.source.mark(0), faults);
  check_gap_column(
      along.name, first, [&](std::size_t i) { return csv.cell_mark(i, along.index); }, faults);
  check_gap_column(
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
