#include "ringfilm/io/measurement/force_file.hpp"

#include <cmath>
#include <optional>

#include "ringfilm/io/table/csv_quantity.hpp"

namespace ringfilm::io {
namespace {

/// Shorter lines are cut off by the turn-around ends altogether.
constexpr std::size_t kMinLoop = 10;
constexpr std::size_t kMaxForceFaults = 10;

/// A line "# sample: NAME" before the header.
std::string sample_of(const CsvFile& csv) {
  const std::string word = "sample:";
  for (int i = 0; i + 1 < csv.header_line; ++i) {
    const std::string& line = csv.source.lines[i];
    const std::size_t start = line.find_first_not_of("# \t");
    if (start == std::string::npos || line.compare(start, word.size(), word) != 0) continue;
    const std::size_t first = line.find_first_not_of(" \t", start + word.size());
    const std::size_t last = line.find_last_not_of(" \t");
    return first == std::string::npos ? "" : line.substr(first, last - first + 1);
  }
  return "";
}

class ForceReader {
 public:
  ForceReader(const NamedFile& file, const Units& units) : csv_(read_csv(file)), units_(units) {}

  ForceFile read() {
    force_.sample = sample_of(csv_);
    force_.sha256 = csv_.source.sha256;
    force_.notes = csv_.notes;
    const bool of_loops = csv_.find("trace") || csv_.find("retrace"), summary = csv_.find("tmr").has_value();
    if (of_loops == summary) {
      throw InputError(
          {{csv_.source.mark(csv_.header_line, 1),
            of_loops ? "the file has friction loops and their summary in one table"
                     : "the file has neither friction loops nor their summary",
            "loops: load [nN],position [um],trace [mV],retrace [mV]; summary: load [nN],tmr [mV]; it has: " +
                csv_.names()}});
    }
    read_loads();
    if (of_loops) {
      read_loops();
    } else {
      read_summary();
    }
    if (!faults_.empty()) throw InputError(faults_);
    return std::move(force_);
  }

 private:
  std::vector<double> column(const std::string& name, const std::string& unit, const std::string& example) {
    return quantity_column(csv_, name, unit, example, units_, faults_);
  }

  /// A column that may be omitted.
  std::vector<double> optional_column(const std::string& name, const std::string& unit, const std::string& example) {
    return csv_.find(name) ? column(name, unit, example) : std::vector<double>{};
  }

  /// A column of whole numbers, which has no unit.
  std::vector<double> counts(const std::string& name) {
    const auto i = csv_.find(name);
    if (!i) return {};
    const CsvColumn& c = csv_.columns[*i];
    for (std::size_t row = 0; row < c.values.size() && faults_.size() < kMaxForceFaults; ++row) {
      if (c.values[row] == std::floor(c.values[row]) && c.values[row] >= 0 && c.values[row] <= 1e9) continue;
      faults_.push_back({csv_.cell_mark(row, *i), name + " is not a whole number from zero on", "for example 3"});
    }
    return c.values;
  }

  void read_loads() {
    const auto i = csv_.find("load");
    const bool volts = i && csv_.columns[*i].unit && units_.measures(*csv_.columns[*i].unit, "V");
    force_.load_unit = volts ? surface::LoadUnit::kVolt : surface::LoadUnit::kNewton;
    load_ = column("load", unit_of_load(), "load [nN]");
  }

  std::string unit_of_load() const { return force_.load_unit == surface::LoadUnit::kVolt ? "V" : "N"; }

  void read_loops() {
    const std::vector<double> position = column("position", "m", "position [um]");
    const std::vector<double> trace = column("trace", "V", "trace [mV]"),
                              retrace = column("retrace", "V", "retrace [mV]");
    const std::vector<double> number = counts("loop");
    if (!faults_.empty()) return;
    std::size_t first = 0;
    for (std::size_t i = 0; i < load_.size(); ++i) {
      if (i > 0 && begins(i, position, number)) {
        close_loop(first, i);
        first = i;
      }
      if (first == i) force_.loops.push_back({load_[i], {}, {}, {}});
      if (i > first && position[i] <= position[i - 1]) {
        add_fault(i, "position", "the position does not rise from the row before to this one of one loop",
                  "turn the retrace round, so that both ways have the same rising positions");
      }
      surface::FrictionLoop& loop = force_.loops.back();
      loop.position_m.push_back(position[i]);
      loop.trace_V.push_back(trace[i]);
      loop.retrace_V.push_back(retrace[i]);
    }
    close_loop(first, load_.size());
  }

  bool begins(std::size_t i, const std::vector<double>& position, const std::vector<double>& number) const {
    if (load_[i] != load_[i - 1]) return true;
    return number.empty() ? position[i] < position[i - 1] : number[i] != number[i - 1];
  }

  void close_loop(std::size_t first, std::size_t end) {
    if (end - first >= kMinLoop) return;
    add_fault(first, "load",
              "the friction loop that begins here has only " + std::to_string(end - first) + " positions",
              std::to_string(kMinLoop) + " or more are required, and the rows of one loop in one block");
  }

  void read_summary() {
    const std::vector<double> tmr = column("tmr", "V", "tmr [mV]");
    const std::vector<double> load_deviation = optional_column("load_deviation", unit_of_load(), "load_deviation [nN]");
    const std::vector<double> tmr_deviation = optional_column("tmr_deviation", "V", "tmr_deviation [mV]");
    const std::vector<double> loops = counts("loops");
    if (!faults_.empty()) return;
    for (std::size_t i = 0; i < load_.size(); ++i) {
      surface::LoadFriction f;
      f.load = load_[i];
      f.tmr_V = tmr[i];
      if (!load_deviation.empty()) f.load_deviation = load_deviation[i];
      if (!tmr_deviation.empty()) f.tmr_deviation_V = tmr_deviation[i];
      f.loops = loops.empty() ? 1 : static_cast<int>(loops[i]);
      if (f.load_deviation < 0)
        add_fault(i, "load_deviation", "a standard deviation is below zero", "0 takes it as exact");
      if (!tmr_deviation.empty() && f.tmr_deviation_V <= 0) {
        add_fault(i, "tmr_deviation", "the standard deviation of tmr is not above zero",
                  "leave the column out where it is not known");
      }
      force_.loads.push_back(f);
    }
  }

  void add_fault(std::size_t row, const std::string& column, const std::string& message, const std::string& remedy) {
    if (faults_.size() < kMaxForceFaults) faults_.push_back({csv_.cell_mark(row, *csv_.find(column)), message, remedy});
  }

  CsvFile csv_;
  const Units& units_;
  ForceFile force_;
  std::vector<double> load_;
  std::vector<Fault> faults_;
};

}  // namespace

ForceFile read_force(const NamedFile& file, const Units& units) { return ForceReader(file, units).read(); }

}  // namespace ringfilm::io
