#include "ringfilm/io/data/trace_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/io/text/csv_quantity.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::io {
namespace {

/// The last sample may be the first one cycle later; beyond these relative differences it is reported, or refused.
constexpr double kNotedMismatch = 1e-3, kMaxMismatch = 0.05;
/// The peak of any engine's trace lies between these; outside, the unit is wrong [Pa].
constexpr double kMinPeak = 5e4, kMaxPeak = 1e8;

std::string in_small_letters(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name;
}

bool sounds_like_angle(const std::string& written) {
  const std::string name = in_small_letters(written);
  return name == "phi" || name == "theta" || name.find("angle") != std::string::npos ||
         name.find("crank") != std::string::npos || name.find("cad") != std::string::npos ||
         name.find("degca") != std::string::npos;
}

bool sounds_like_pressure(const std::string& written) {
  const std::string name = in_small_letters(written);
  return name == "p" || name.rfind("p_", 0) == 0 || name.rfind("p ", 0) == 0 || name.rfind("pcyl", 0) == 0 ||
         name.find("press") != std::string::npos;
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
      : csv_(read_csv(file)),
        place_(stated.place),
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
    csv_.read_units_in_parentheses([this](const std::string& text) {
      return units_.measures(text, "degree") || units_.measures(text, "Pa") || is_gauge(text);
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
    if (angles.size() == 1) outline_angles(angles.front(), seen);
    if (pressures.size() == 1) outline_pressures(pressures.front(), seen);
    if (!faults_.empty()) throw InputError(faults_);
    return seen;
  }

  TraceFile read(cycle::PressureReference reference) {
    reference_ = reference;
    const auto i_angle = column_for(angle_);
    const auto i_pressure = column_for(pressure_);
    TraceFile trace;
    if (i_angle && i_pressure) {
      trace.samples = {values(*i_angle, angle_), values(*i_pressure, pressure_)};
      if (!faults_.empty()) throw TraceKeyError(faults_);
      check_angles(trace.samples.crank_angle_deg, *i_angle);
      if (faults_.empty()) {
        check_pressures(trace.samples.value, *i_pressure);
        if (!faults_.empty()) throw TraceKeyError(faults_);
      }
      if (faults_.empty()) check_repetition(trace.samples.crank_angle_deg, trace.samples.value, *i_pressure);
    }
    if (!i_angle || !i_pressure) throw TraceKeyError(faults_);
    if (!faults_.empty()) throw InputError(faults_);
    trace.sha256 = csv_.source.sha256;
    trace.notes = csv_.notes;
    trace.notes.insert(trace.notes.end(), notes_.begin(), notes_.end());
    return trace;
  }

 private:
  void outline_angles(std::size_t i_column, TraceOutline& seen) {
    const CsvColumn& column = csv_.columns[i_column];
    const auto [low, high] = std::minmax_element(column.values.begin(), column.values.end());
    seen.is_degree_by_span = !column.unit && *high - *low > models::kMaxSpanInRadians;
    if (column.unit) {
      seen.crank_angle_deg = in_si(column, units_.scale(*column.unit, angle_.si_unit));
    } else if (seen.is_degree_by_span) {
      seen.crank_angle_deg = column.values;
    }
    if (!seen.crank_angle_deg.empty()) check_angles(seen.crank_angle_deg, i_column);
  }

  void outline_pressures(std::size_t i_column, TraceOutline& seen) {
    const CsvColumn& column = csv_.columns[i_column];
    if (column.unit && is_gauge(*column.unit)) seen.reference_of_unit = cycle::PressureReference::kGauge;
    if (column.unit && is_absolute(*column.unit)) seen.reference_of_unit = cycle::PressureReference::kAbsolute;
    if (seen.crank_angle_deg.empty() || !faults_.empty()) return;
    seen.is_in_pascal = column.unit.has_value();
    seen.pressure_values = column.values;
    if (!seen.is_in_pascal) return;
    const std::string unit = is_gauge(*column.unit) ? without_gauge(*column.unit) : *column.unit;
    seen.pressure_values = in_si(column, units_.scale(unit, pressure_.si_unit));
    reference_ = seen.reference_of_unit;
    check_pressures(seen.pressure_values, i_column);
    if (faults_.empty()) check_repetition(seen.crank_angle_deg, seen.pressure_values, i_column);
  }

  bool may_be(const CsvColumn& column, const Role& role) const {
    if (!column.unit) return sounds_like_angle(column.name) == (&role == &angle_);
    return units_.measures(*column.unit, role.si_unit) || (&role == &pressure_ && is_gauge(*column.unit));
  }

  std::vector<std::size_t> candidates(const Role& role) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < csv_.columns.size(); ++i) {
      if (may_be(csv_.columns[i], role)) found.push_back(i);
    }
    return found;
  }

  static std::vector<double> in_si(const CsvColumn& column, const Scale& scale) {
    std::vector<double> si(column.values.size());
    std::transform(column.values.begin(), column.values.end(), si.begin(), [&](double v) { return scale.to_si(v); });
    return si;
  }

  static std::string without_gauge(const std::string& unit) { return unit.substr(0, unit.find_first_of("g (")); }

  bool is_gauge(const std::string& unit) const {
    return unit.size() > 1 && !units_.measures(unit, "Pa") && (unit.back() == 'g' || unit.back() == ')') &&
           units_.measures(without_gauge(unit), "Pa");
  }

  static bool is_absolute(const std::string& unit) { return unit == "bara" || unit == "psia"; }

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
    faults_.push_back({csv_.source.mark(csv_.header_line, 1),
                       "no column of the file is a " + role.words + ": " + why_none_is(role),
                       "a header such as " + role.header_example + " is required, or " + role.column_key});
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

  std::optional<std::size_t> column_for(const Role& role) {
    const SourceMark header = csv_.source.mark(csv_.header_line, 1);
    if (role.column) {
      const auto found = csv_.find(*role.column);
      if (!found) {
        faults_.push_back({header, "the file has no column " + *role.column + " (" + role.column_key + ")",
                           "it has: " + csv_.names()});
      }
      return found;
    }
    const std::vector<std::size_t> found = candidates(role);
    if (found.size() == 1) return found.front();
    if (found.empty()) {
      refuse_all_columns(role);
    } else {
      faults_.push_back({header, fmt::format("{} columns of the file may be the {}", found.size(), role.words),
                         "name one of them with " + role.column_key + "; the file has: " + csv_.names()});
    }
    return std::nullopt;
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
    const std::string unit = column.unit ? *column.unit : *role.unit;
    if (reference_ == cycle::PressureReference::kGauge && is_absolute(unit)) {
      return refuse("the unit " + unit + " is absolute, but gas.pressure_reference = \"gauge\"",
                    "one of them is wrong");
    }
    try {
      const Scale scale = units_.scale(unit, role.si_unit);
      if (column.unit && role.unit) {
        const Scale other = units_.scale(*role.unit, role.si_unit);
        if (other.factor != scale.factor || other.divisor != scale.divisor) {
          return refuse("the file states " + unit + ", " + role.unit_key + " states " + *role.unit,
                        "one of them is wrong");
        }
      }
      return in_si(column, scale);
    } catch (const UnitError& problem) {
      const bool gauge = role.si_unit == "Pa" && is_gauge(unit);
      return refuse("the column " + column.name + " " + problem.what(),
                    gauge ? "write the unit without the g, and state gas.pressure_reference = \"gauge\""
                          : dimension_words(role.si_unit) + " is required here, for example " + role.header_example);
    }
  }

  void check_angles(const std::vector<double>& angle, std::size_t i_column) {
    if (const auto fault = crank_angle_fault(csv_, i_column, angle)) {
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
        {csv_.cell_mark(first, i_column),
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
      faults_.push_back({csv_.cell_mark(angle.size() - 1, i_column), message,
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
      faults_.push_back({csv_.cell_mark(static_cast<std::size_t>(first - p.begin()), i_column),
                         fmt::format("the pressure is {:.6g} Pa; {}", *first, rule_of_reference()),
                         remedy_of_low(*first, is_alone)});
      return;
    }
    if (place_ == TracePlace::kCrankcase) return;
    const auto peak = std::max_element(p.begin(), p.end());
    if (*peak < kMinPeak || *peak > kMaxPeak) {
      faults_.push_back({csv_.cell_mark(static_cast<std::size_t>(peak - p.begin()), i_column),
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
    return remedy.empty() ? "is the unit of the trace right?" : remedy;
  }

  CsvFile csv_;
  TracePlace place_;
  const Units& units_;
  Role angle_, pressure_;
  std::optional<cycle::PressureReference> reference_;  ///< nothing where it is not known
  std::vector<Fault> faults_;
  std::vector<std::string> notes_;
};

}  // namespace

bool TraceOutline::has_lone_low_pressure() const {
  return std::count_if(pressure_values.begin(), pressure_values.end(), [](double p) { return p <= 0; }) == 1;
}

TraceOutline trace_outline(const NamedFile& file, const Units& units) {
  const TraceColumns nothing_stated;
  return TraceReader(file, nothing_stated, units).outline();
}

TraceFile read_trace(const NamedFile& file, const TraceColumns& stated, const Units& units) {
  return TraceReader(file, stated, units).read(stated.reference);
}

}  // namespace ringfilm::io
