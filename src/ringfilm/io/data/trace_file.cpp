#include "ringfilm/io/data/trace_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/io/data/trace_cycles.hpp"
#include "ringfilm/io/table/csv_quantity.hpp"
#include "ringfilm/io/table/text_cells.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::io {
namespace {

/// The last sample may be the first one cycle later; beyond these relative differences it is reported, or refused.
constexpr double kNotedMismatch = 1e-3, kMaxMismatch = 0.05;
/// The peak of any engine's trace lies between these; outside, the unit is wrong [Pa].
constexpr double kMinPeak = 5e4, kMaxPeak = 1e8;
/// Rows without a number are omitted up to this share, else they are faults; assumed.
constexpr double kMaxGapShare = 0.01;

bool sounds_like_angle(const std::string& written) {
  const std::string name = lower(written);
  return name == "phi" || name == "theta" || name.find("angle") != std::string::npos ||
         name.find("crank") != std::string::npos || name.find("cad") != std::string::npos ||
         name.find("degca") != std::string::npos || name == "ca" || name == "kw";
}

bool counts_cycles(const std::string& written) {
  const std::string name = lower(written);
  for (const char* word : {"cycle", "cycle number", "cycle_number", "cycle no", "cyc", "zyklus", "zyklusnummer"}) {
    if (name == word) return true;
  }
  return false;
}

/// Does a name match a pattern in which * stands for any text?
bool matches(std::string_view pattern, std::string_view name) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == name;
  const std::string_view behind = pattern.substr(star + 1);
  if (!name.starts_with(pattern.substr(0, star))) return false;
  for (std::size_t i = star; i <= name.size(); ++i) {
    if (matches(behind, name.substr(i))) return true;
  }
  return false;
}

bool sounds_like_pressure(const std::string& written) {
  const std::string name = lower(written);
  return name == "p" || name.rfind("p_", 0) == 0 || name.rfind("p ", 0) == 0 || name.rfind("pcyl", 0) == 0 ||
         name.find("press") != std::string::npos;
}

/// Without the digits at its end.
std::string_view without_number(std::string_view name) {
  while (!name.empty() && name.back() >= '0' && name.back() <= '9') name.remove_suffix(1);
  return name;
}

/// A unit of pressure that states what the pressure is counted from: "barg", "bar (g)", "bar abs".
struct ReferredUnit {
  std::string unit;
  cycle::PressureReference reference{};
};

std::optional<ReferredUnit> referred_unit(const std::string& text, const Units& units) {
  using enum cycle::PressureReference;
  static constexpr std::pair<const char*, cycle::PressureReference> kEnds[] = {
      {"gauge", kGauge}, {"absolute", kAbsolute}, {"rel", kGauge}, {"abs", kAbsolute}, {"g", kGauge}, {"a", kAbsolute}};
  if (units.measures(text, "Pa") && text != "bara" && text != "psia") return std::nullopt;
  std::string bare = lower(text);
  std::erase_if(bare, [](char c) { return c == '(' || c == ')' || c == ' ' || c == '_'; });
  for (const auto& [end, reference] : kEnds) {
    if (!bare.ends_with(end)) continue;
    const std::size_t length = bare.size() - std::string_view(end).size();
    if (text.size() < length || lower(text.substr(0, length)) != bare.substr(0, length)) return std::nullopt;
    std::string unit = text.substr(0, length);
    if (unit.empty() || !units.measures(unit, "Pa")) return std::nullopt;
    return ReferredUnit{std::move(unit), reference};
  }
  return std::nullopt;
}

/// One of the two columns that a trace needs.
struct Role {
  std::string words;  ///< "crank angle"
  std::string si_unit;
  std::string column_key, unit_key;  ///< "gas.angle_column", "gas.angle_unit"
  std::string header_example;
  std::string units;  ///< that are read, in words
  bool (*sounds_like)(const std::string&);
  std::optional<std::string> column, unit;
};

class TraceReader {
 public:
  TraceReader(const NamedFile& file, const TraceColumns& stated, const Units& units)
      : csv_(read_csv(file, Gaps::kListed, stated.table)),
        place_(stated.place),
        choice_(stated.cycle),
        units_(units),
        angle_{"crank angle", "degree",          "gas.angle_column",  "gas.angle_unit", "crank_angle [degree]",
               kAngleUnits,   sounds_like_angle, stated.angle_column, stated.angle_unit},
        pressure_{"pressure",
                  "Pa",
                  "gas.pressure_column",
                  "gas.pressure_unit",
                  "cylinder_pressure [Pa]",
                  kPressureUnits,
                  sounds_like_pressure,
                  stated.pressure_column,
                  stated.pressure_unit} {
    csv_.read_units_in_names([this](const std::string& text) {
      return units_.measures(text, "degree") || units_.measures(text, "Pa") || referred_unit(text, units_) ||
             is_any_unit(text);
    });
  }

  TraceOutline outline() {
    const std::vector<std::size_t> angles = candidates(angle_), pressures = candidates(pressure_);
    if (angles.empty()) refuse_all_columns(angle_);
    if (pressures.empty()) refuse_all_columns(pressure_);
    if (!faults_.empty()) throw InputError(faults_);
    TraceOutline seen;
    for (const std::size_t i : angles) seen.angle.push_back({csv_.columns[i].name, csv_.columns[i].unit});
    for (const std::size_t i : pressures) seen.pressure.push_back({csv_.columns[i].name, csv_.columns[i].unit});
    if (angles.size() == 1) outline_samples(angles.front(), pressures, seen);
    if (!faults_.empty()) throw InputError(faults_);
    seen.notes = csv_.notes;
    seen.notes.insert(seen.notes.end(), notes_.begin(), notes_.end());
    return seen;
  }

  TraceFile read(cycle::PressureReference reference) {
    reference_ = reference;
    const std::vector<std::size_t> angle_columns = columns_for(angle_), pressure_columns = columns_for(pressure_);
    if (angle_columns.empty() || pressure_columns.empty()) throw TraceKeyError(faults_);
    if (!choice_.is_valid()) {
      faults_.push_back({csv_.source.mark(0), "gas.cycle chooses one of several cycles",
                         "\"mean\", \"median\" or the number of a cycle, from \"1\""});
    }
    const std::size_t i_angle = angle_columns.front(), i_pressure = pressure_columns.front();
    TraceRows rows;
    rows.crank_angle_deg = values(i_angle, angle_);
    for (const std::size_t i : pressure_columns) rows.pressure.push_back(values(i, pressure_));
    if (!faults_.empty()) throw TraceKeyError(faults_);
    make_one_cycle(rows, i_angle, pressure_columns, 1.0);
    TraceFile trace;
    if (faults_.empty()) {
      trace.samples = {std::move(rows.crank_angle_deg), std::move(rows.pressure.front())};
      check_angles(trace.samples.crank_angle_deg, i_angle);
    }
    if (faults_.empty()) {
      check_pressures(trace.samples.value, i_pressure);
      if (!faults_.empty()) throw TraceKeyError(faults_);
      check_repetition(trace.samples.crank_angle_deg, trace.samples.value, i_pressure);
    }
    if (!faults_.empty()) throw InputError(faults_);
    trace.sha256 = csv_.source.sha256;
    trace.notes = csv_.notes;
    trace.notes.insert(trace.notes.end(), notes_.begin(), notes_.end());
    return trace;
  }

 private:
  /// Looks at the samples as far as their units are known.
  void outline_samples(std::size_t i_angle, const std::vector<std::size_t>& pressures, TraceOutline& seen) {
    const CsvColumn& angle = csv_.columns[i_angle];
    const auto [low, high] = std::minmax_element(angle.values.begin(), angle.values.end(), NanIsLess());
    seen.is_degree_by_span = !angle.unit && *high - *low > models::kMaxSpanInRadians;
    const bool is_one = pressures.size() == 1;
    const CsvColumn& pressure = csv_.columns[pressures.front()];
    const auto referred = is_one && pressure.unit ? referred_unit(*pressure.unit, units_) : std::nullopt;
    if (referred) seen.reference_of_unit = referred->reference;
    TraceRows rows;
    if (angle.unit) {
      rows.crank_angle_deg = in_si(angle, units_.scale(*angle.unit, angle_.si_unit));
    } else if (seen.is_degree_by_span) {
      rows.crank_angle_deg = angle.values;
    } else {
      return;
    }
    const bool is_in_pascal = is_one && pressure.unit.has_value();
    if (is_in_pascal) {
      const std::string unit = referred ? referred->unit : *pressure.unit;
      rows.pressure.push_back(in_si(pressure, units_.scale(unit, pressure_.si_unit)));
    } else {
      rows.pressure.push_back(pressure.values);
    }
    make_one_cycle(rows, i_angle, {pressures.front()}, is_in_pascal ? std::optional(1.0) : std::nullopt);
    if (!faults_.empty()) return;
    seen.crank_angle_deg = rows.crank_angle_deg;
    check_angles(seen.crank_angle_deg, i_angle);
    if (!is_one || !faults_.empty()) return;
    seen.is_in_pascal = is_in_pascal;
    seen.pressure_values = rows.pressure.front();
    if (!seen.is_in_pascal) return;
    reference_ = seen.reference_of_unit;
    check_pressures(seen.pressure_values, pressures.front());
    if (faults_.empty()) check_repetition(seen.crank_angle_deg, seen.pressure_values, pressures.front());
  }

  struct NanIsLess {
    bool operator()(double a, double b) const { return std::isnan(a) ? !std::isnan(b) : a < b; }
  };

  /// Omits the rows without a number, turns those whose angle falls, and takes one of several cycles.
  void make_one_cycle(TraceRows& rows, std::size_t i_angle, const std::vector<std::size_t>& pressures,
                      std::optional<double> pressure_scale) {
    rows.row.resize(csv_.row_lines.size());
    for (std::size_t i = 0; i < rows.row.size(); ++i) rows.row[i] = i;
    omit_gaps(rows, i_angle, pressures);
    if (!faults_.empty()) return;
    turn_falling(rows);
    const std::size_t n_cycles = join_cycles(rows, choice_, csv_.source.path, pressure_scale);
    if (choice_.number() && *choice_.number() > n_cycles) {
      faults_.push_back({csv_.source.mark(0),
                         fmt::format("gas.cycle is {}, and the file has {} cycle{}", *choice_.number(), n_cycles,
                                     n_cycles == 1 ? "" : "s"),
                         "choose one of them, \"mean\" or \"median\""});
    }
    for (const std::string& note : rows.notes) {
      notes_.push_back(note.starts_with(csv_.source.path) ? note : csv_.source.path + ": " + note);
    }
    rows_ = rows.row;
  }

  void omit_gaps(TraceRows& rows, std::size_t i_angle, const std::vector<std::size_t>& pressures) {
    std::vector<const Gap*> gaps;
    for (const Gap& gap : csv_.gaps) {
      if (gap.column == i_angle || std::find(pressures.begin(), pressures.end(), gap.column) != pressures.end()) {
        if (gaps.empty() || gaps.back()->row != gap.row) gaps.push_back(&gap);
      }
    }
    if (gaps.empty()) return;
    const auto n_rows = static_cast<double>(rows.row.size());
    if (csv_.n_gaps > csv_.gaps.size() || static_cast<double>(gaps.size()) > kMaxGapShare * n_rows) {
      constexpr std::size_t kMaxReported = 10;
      for (std::size_t k = 0; k < std::min(gaps.size(), kMaxReported); ++k) faults_.push_back(gaps[k]->fault);
      return;
    }
    notes_.push_back(fmt::format("{}: {} row{} without a number omitted, the first in line {}", csv_.source.path,
                                 gaps.size(), gaps.size() == 1 ? "" : "s", csv_.row_lines[gaps.front()->row]));
    for (auto gap = gaps.rbegin(); gap != gaps.rend(); ++gap) {
      const auto place = static_cast<std::ptrdiff_t>((*gap)->row);
      rows.crank_angle_deg.erase(rows.crank_angle_deg.begin() + place);
      for (std::vector<double>& column : rows.pressure) column.erase(column.begin() + place);
      rows.row.erase(rows.row.begin() + place);
    }
  }

  SourceMark sample_mark(std::size_t sample, std::size_t i_column) const {
    return csv_.cell_mark(rows_[sample], i_column);
  }

  bool may_be(const CsvColumn& column, const Role& role) const {
    if (!column.unit) return sounds_like_angle(column.name) == (&role == &angle_);
    return units_.measures(*column.unit, role.si_unit) || (&role == &pressure_ && referred_unit(*column.unit, units_));
  }

  std::vector<std::size_t> candidates(const Role& role) const {
    std::vector<std::size_t> found, with_unit;
    for (std::size_t i = 0; i < csv_.columns.size(); ++i) {
      const CsvColumn& column = csv_.columns[i];
      if (counts_cycles(column.name) || !may_be(column, role)) continue;
      if (column.unit || role.sounds_like(column.name)) with_unit.push_back(i);
      found.push_back(i);
    }
    // Columns of other quantities without a unit are not candidates beside one that has its unit.
    const bool has_unit = std::any_of(with_unit.begin(), with_unit.end(),
                                      [this](std::size_t i) { return csv_.columns[i].unit.has_value(); });
    return has_unit ? with_unit : found;
  }

  static std::vector<double> in_si(const CsvColumn& column, const Scale& scale) {
    std::vector<double> si(column.values.size());
    std::transform(column.values.begin(), column.values.end(), si.begin(), [&](double v) { return scale.to_si(v); });
    return si;
  }

  /// What is wrong with the unit of a column that has one.
  UnitError unit_error(const CsvColumn& column, const Role& role) const {
    try {
      units_.scale(*column.unit, role.si_unit);
    } catch (const UnitError& problem) {
      return problem;
    }
    throw std::logic_error("the unit " + *column.unit + " is right");
  }

  /// No column may be the one of this role: those that are named like it have a wrong unit, or all are listed.
  void refuse_all_columns(const Role& role) {
    const std::size_t n_faults = faults_.size();
    for (std::size_t i = 0; i < csv_.columns.size(); ++i) {
      const CsvColumn& column = csv_.columns[i];
      if (!column.unit || !role.sounds_like(column.name)) continue;
      const UnitError problem = unit_error(column, role);
      faults_.push_back({csv_.unit_mark(i), "the column " + column.name + " " + problem.what(),
                         (problem.remedy.empty() ? "" : problem.remedy + "; ") + "a " + role.words + " is in " +
                             role.units + ", for example " + role.header_example + "; or name another column with " +
                             role.column_key});
    }
    if (faults_.size() > n_faults) return;
    const bool has_time =
        &role == &angle_ && std::any_of(csv_.columns.begin(), csv_.columns.end(),
                                        [this](const auto& c) { return c.unit && units_.measures(*c.unit, "s"); });
    faults_.push_back(
        {csv_.source.mark(csv_.header_line, 1), "no column of the file is a " + role.words + ": " + why_none_is(role),
         has_time ? "a crank angle is required: at n rpm it grows by 6 n degree per second, from the angle of "
                    "the first sample on, which the file does not state; write it as " +
                        role.header_example
                  : "a header such as " + role.header_example + " is required, or " + role.column_key});
  }

  std::string why_none_is(const Role& role) const {
    std::string reasons;
    for (const CsvColumn& column : csv_.columns) {
      std::string reason = "has no unit";
      try {
        if (column.unit) units_.scale(*column.unit, role.si_unit);
      } catch (const UnitError& problem) {
        reason = problem.what();
      }
      reasons += (reasons.empty() ? "" : ", ") + column.name + " " + reason;
    }
    return reasons;
  }

  /// One column, or several pressures where the case names them by a pattern; empty, with a fault, where it is unclear.
  std::vector<std::size_t> columns_for(const Role& role) {
    const SourceMark header = csv_.source.mark(csv_.header_line, 1);
    if (role.column && &role == &pressure_ && role.column->find('*') != std::string::npos) {
      std::vector<std::size_t> found;
      for (std::size_t i = 0; i < csv_.columns.size(); ++i) {
        if (matches(*role.column, csv_.columns[i].name)) found.push_back(i);
      }
      if (!found.empty()) return found;
    }
    if (role.column) {
      const auto found = csv_.find(*role.column);
      if (!found) {
        faults_.push_back({header, "the file has no column " + *role.column + " (" + role.column_key + ")",
                           "it has: " + csv_.names()});
      }
      return found ? std::vector{*found} : std::vector<std::size_t>();
    }
    std::vector<std::size_t> found = candidates(role);
    if (found.size() == 1) return found;
    if (found.empty()) {
      refuse_all_columns(role);
    } else {
      faults_.push_back(
          {header, fmt::format("{} columns of the file may be the {}", found.size(), role.words),
           "name one of them with " + role.column_key + cycles_in(found, role) + "; the file has: " + csv_.names()});
    }
    return {};
  }

  /// How columns with one cycle each are named, where their names begin alike.
  std::string cycles_in(const std::vector<std::size_t>& columns, const Role& role) const {
    std::vector<std::string> names;
    for (const std::size_t i : columns) names.push_back(csv_.columns[i].name);
    const std::string pattern = &role == &pressure_ ? pattern_of_cycles(names) : "";
    return pattern.empty() ? "" : ", or all, with one cycle each, with \"" + pattern + "\"";
  }

  std::vector<double> values(std::size_t i_column, const Role& role) {
    const CsvColumn& column = csv_.columns[i_column];
    const auto refuse = [&](const std::string& message, const std::string& remedy) {
      faults_.push_back({csv_.unit_mark(i_column), message, remedy});
      return std::vector<double>();
    };
    if (!column.unit && !role.unit) {
      return refuse("the column " + column.name + " has no unit",
                    "write it as " + role.header_example + ", or state " + role.unit_key);
    }
    const std::string written = column.unit ? *column.unit : *role.unit;
    const auto referred = role.si_unit == "Pa" ? referred_unit(written, units_) : std::nullopt;
    if (referred && reference_ && referred->reference != *reference_) {
      const bool is_gauge = referred->reference == cycle::PressureReference::kGauge;
      return refuse("the unit " + written + " is " + (is_gauge ? "gauge" : "absolute") +
                        ", but gas.pressure_reference = " + (is_gauge ? "\"absolute\"" : "\"gauge\""),
                    "one of them is wrong");
    }
    const std::string unit = referred ? referred->unit : written;
    try {
      const Scale scale = units_.scale(unit, role.si_unit);
      if (column.unit && role.unit) {
        const auto other_referred = role.si_unit == "Pa" ? referred_unit(*role.unit, units_) : std::nullopt;
        const Scale other = units_.scale(other_referred ? other_referred->unit : *role.unit, role.si_unit);
        const bool differs = referred && other_referred && referred->reference != other_referred->reference;
        if (other.factor != scale.factor || other.divisor != scale.divisor || differs) {
          return refuse("the file states " + written + ", " + role.unit_key + " states " + *role.unit,
                        "one of them is wrong");
        }
      }
      return in_si(column, scale);
    } catch (const UnitError& problem) {
      return refuse("the column " + column.name + " " + problem.what(),
                    dimension_words(role.si_unit) + " is required here, for example " + role.header_example);
    }
  }

  void check_angles(const std::vector<double>& angle, std::size_t i_column) {
    const auto place = [&](std::size_t sample) { return sample_mark(sample, i_column); };
    if (const auto fault = crank_angle_fault(angle, place)) {
      faults_.push_back(*fault);
    } else {
      check_holes(angle, i_column);
    }
  }

  void check_holes(const std::vector<double>& angle, std::size_t i_column) {
    std::size_t n_holes = 0, first = 0;
    for (std::size_t k = 1; k < angle.size(); ++k) {
      if (angle[k] - angle[k - 1] <= models::kMaxSampleDistanceDeg * (1 + 1e-9)) continue;
      if (n_holes++ == 0) first = k;
    }
    if (n_holes == 0) return;
    const std::string others =
        n_holes == 1 ? ""
                     : fmt::format(", nor in {} more steps over {} degree", n_holes - 1, models::kMaxSampleDistanceDeg);
    faults_.push_back(
        {sample_mark(first, i_column),
         fmt::format("no samples between {:.8g} and {:.8g} degree{}", angle[first - 1], angle[first], others),
         fmt::format(
             "samples may be {} degree apart at the most, since the pressure between them is interpolated; give "
             "more of them",
             models::kMaxSampleDistanceDeg)});
  }

  /// What is to be added to the pressures at the most, so that they are absolute.
  double atmosphere() const { return reference_ == cycle::PressureReference::kAbsolute ? 0 : base::kAtmosphere; }

  void check_repetition(const std::vector<double>& angle, const std::vector<double>& p, std::size_t i_column) {
    if (angle.back() - angle.front() < cycle::kCycleDeg * (1 - 1e-9)) return;
    const double first = p.front() + atmosphere(), last = p.back() + atmosphere();
    const double mismatch = std::abs(last - first) / std::max(first, last);
    if (mismatch <= kNotedMismatch) return;
    const std::string message =
        fmt::format("the pressure is {} at {:.8g} degree and {} one cycle later, at {:.8g} degree",
                    text_in(p.front(), kBar), angle.front(), text_in(p.back(), kBar), angle.back());
    if (mismatch > kMaxMismatch) {
      faults_.push_back({sample_mark(angle.size() - 1, i_column), message,
                         "a cycle repeats itself; take the last sample out, or average the cycles"});
    } else {
      notes_.push_back(csv_.source.path + ": " + message);
    }
  }

  void check_pressures(const std::vector<double>& p, std::size_t i_column) {
    const auto is_impossible = [this](double one) { return !(one + atmosphere() > 0); };
    const auto first = std::find_if(p.begin(), p.end(), is_impossible);
    if (first != p.end()) {
      const bool is_alone = std::count_if(p.begin(), p.end(), is_impossible) == 1;
      faults_.push_back({sample_mark(static_cast<std::size_t>(first - p.begin()), i_column),
                         fmt::format("the pressure is {:.6g} Pa; {}", *first, rule_of_reference()),
                         remedy_of_low(*first, is_alone)});
      return;
    }
    if (place_ == TracePlace::kCrankcase) return;
    const auto peak = std::max_element(p.begin(), p.end());
    if (*peak < kMinPeak || *peak > kMaxPeak) {
      faults_.push_back({sample_mark(static_cast<std::size_t>(peak - p.begin()), i_column),
                         "the highest pressure of the trace is " + text_in(*peak, kBar),
                         fmt::format("is its unit right? That of engines is between {:.6g} and {}",
                                     number_in(kMinPeak, kBar), text_in(kMaxPeak, kBar))});
    }
  }

  std::string rule_of_reference() const {
    const std::string absolute = "an absolute pressure is above 0", gauge = "a gauge pressure is above -1.01325 bar";
    if (!reference_) return absolute + ", " + gauge;
    return reference_ == cycle::PressureReference::kGauge ? gauge : absolute;
  }

  std::string remedy_of_low(double pressure, bool is_alone) const {
    std::string remedy =
        is_alone ? "one sample alone: if it is a fault of the measurement, correct it or take it out" : "";
    if (pressure + base::kAtmosphere > 0) {
      remedy += (remedy.empty() ? "" : "; ") +
                std::string("is the trace a gauge pressure? Then gas.pressure_reference = \"gauge\"");
    }
    return remedy.empty()
               ? "is the unit of the trace right? If the number marks a missing sample, write nan in its place"
               : remedy;
  }

  CsvFile csv_;
  TracePlace place_;
  CycleChoice choice_;
  const Units& units_;
  Role angle_, pressure_;
  std::optional<cycle::PressureReference> reference_;  ///< nothing where it is not known
  std::vector<Fault> faults_;
  std::vector<std::string> notes_;
  std::vector<std::size_t> rows_;  ///< row in the file of each sample
};

}  // namespace

std::string pattern_of_cycles(const std::vector<std::string>& names) {
  const std::string begin(names.empty() ? "" : without_number(names.front()));
  if (begin.empty() || names.front().size() == begin.size()) return "";
  const std::optional<double> first = number_of(std::string_view(names.front()).substr(begin.size()), false);
  if (!first) return "";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (without_number(names[i]) != begin) return "";
    if (number_of(std::string_view(names[i]).substr(begin.size()), false) != *first + static_cast<double>(i)) return "";
  }
  return begin + "*";
}

bool TraceOutline::has_lone_low_pressure() const {
  return std::count_if(pressure_values.begin(), pressure_values.end(), [](double p) { return p <= 0; }) == 1;
}

TraceOutline trace_outline(const NamedFile& file, const Units& units, const TableReading& stated) {
  TraceColumns nothing_stated;
  nothing_stated.table = stated;
  return TraceReader(file, nothing_stated, units).outline();
}

TraceFile read_trace(const NamedFile& file, const TraceColumns& stated, const Units& units) {
  return TraceReader(file, stated, units).read(stated.reference);
}

}  // namespace ringfilm::io
