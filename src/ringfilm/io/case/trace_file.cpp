#include "ringfilm/io/case/trace_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/cycle/integration/kinematics.hpp"
#include "ringfilm/io/text/csv_quantity.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::io {
namespace {

/// The last sample may be the first one cycle later; beyond these relative differences it is reported, or refused.
constexpr double kNotedMismatch = 1e-3, kLargestMismatch = 0.05;
/// The peak of any engine's trace lies between these; outside, the unit is wrong [Pa].
constexpr double kLeastPeak = 5e4, kHighestPeak = 1e8;

bool sounds_like_angle(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name == "phi" || name == "theta" || name.find("angle") != std::string::npos ||
         name.find("crank") != std::string::npos || name.find("cad") != std::string::npos ||
         name.find("degca") != std::string::npos;
}

/// One of the two columns that a trace needs.
struct Role {
  std::string words;  ///< "crank angle"
  std::string si_unit;
  std::string column_key, unit_key;  ///< "gas.angle_column", "gas.angle_unit"
  std::string header_example;
  std::optional<std::string> column, unit;
};

class TraceReader {
 public:
  TraceReader(const NamedFile& file, const TraceColumns& stated, const Units& units)
      : csv_(read_csv(file)), stated_(stated), units_(units) {}

  TraceOutline outline() const {
    TraceOutline seen;
    const CsvColumn *angle = nullptr, *pressure = nullptr;
    for (const CsvColumn& column : csv_.columns) {
      const bool is_angle = may_be(column, kAngle);
      if (!is_angle && !may_be(column, kPressure)) continue;
      (is_angle ? seen.angle : seen.pressure).push_back({column.name, column.unit});
      (is_angle ? angle : pressure) = &column;
    }
    if (seen.pressure.size() == 1 && pressure->unit) seen.has_gauge_unit = is_gauge(*pressure->unit);
    const bool is_clear = seen.angle.size() == 1 && seen.pressure.size() == 1 && angle->unit && pressure->unit;
    if (!is_clear || seen.has_gauge_unit) return seen;
    seen.samples = {in_si(*angle, "degree"), in_si(*pressure, "Pa")};
    return seen;
  }

  TraceFile read() {
    const Role angle{
        "crank angle",        "degree",          "gas.angle_column", "gas.angle_unit", "crank_angle [degree]",
        stated_.angle_column, stated_.angle_unit};
    const Role pressure{"pressure",
                        "Pa",
                        "gas.pressure_column",
                        "gas.pressure_unit",
                        "cylinder_pressure [Pa]",
                        stated_.pressure_column,
                        stated_.pressure_unit};
    const auto i_angle = column_for(angle);
    const auto i_pressure = column_for(pressure);
    TraceFile trace;
    if (i_angle && i_pressure) {
      trace.samples = {values(*i_angle, angle), values(*i_pressure, pressure)};
      if (!faults_.empty()) throw TraceKeyError(faults_);
      check_angles(trace.samples.crank_angle_deg, *i_angle);
      if (faults_.empty()) {
        check_pressures(trace.samples.value, *i_pressure);
        if (!faults_.empty()) throw TraceKeyError(faults_);
      }
      if (faults_.empty()) check_repetition(trace.samples, *i_pressure);
    }
    if (!i_angle || !i_pressure) throw TraceKeyError(faults_);
    if (!faults_.empty()) throw InputError(faults_);
    trace.sha256 = csv_.source.sha256;
    trace.notes = csv_.notes;
    trace.notes.insert(trace.notes.end(), notes_.begin(), notes_.end());
    return trace;
  }

 private:
  static constexpr const char *kAngle = "degree", *kPressure = "Pa";

  bool may_be(const CsvColumn& column, const std::string& si_unit) const {
    if (column.unit) return units_.measures(*column.unit, si_unit) || (si_unit == kPressure && is_gauge(*column.unit));
    return sounds_like_angle(column.name) == (si_unit == kAngle);
  }

  std::vector<double> in_si(const CsvColumn& column, const std::string& si_unit) const {
    const Scale scale = units_.scale(*column.unit, si_unit);
    std::vector<double> si(column.values.size());
    std::transform(column.values.begin(), column.values.end(), si.begin(), [&](double v) { return scale.to_si(v); });
    return si;
  }

  bool is_gauge(const std::string& unit) const {
    return unit.size() > 1 && !units_.measures(unit, "Pa") && (unit.back() == 'g' || unit.back() == ')') &&
           units_.measures(unit.substr(0, unit.find_first_of("g (")), "Pa");
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
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < csv_.columns.size(); ++i) {
      if (may_be(csv_.columns[i], role.si_unit)) candidates.push_back(i);
    }
    if (candidates.size() == 1) return candidates.front();
    if (candidates.empty()) {
      faults_.push_back({header, "no column of the file is a " + role.words + ": " + why_none_is(role),
                         "a header such as " + role.header_example + " is required, or " + role.column_key});
    } else {
      faults_.push_back({header, fmt::format("{} columns of the file may be the {}", candidates.size(), role.words),
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
    const bool stated_gauge = stated_.reference == cycle::PressureReference::kGauge;
    if (stated_gauge && (unit == "bara" || unit == "psia")) {
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
      std::vector<double> si(column.values.size());
      std::transform(column.values.begin(), column.values.end(), si.begin(), [&](double v) { return scale.to_si(v); });
      return si;
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
      if (angle[k] - angle[k - 1] <= models::kLargestSampleDistanceDeg * (1 + 1e-9)) continue;
      if (n_holes++ == 0) first = k;
    }
    if (n_holes == 0) return;
    const std::string others = n_holes == 1 ? ""
                                            : fmt::format(", nor in {} more steps over {} degree", n_holes - 1,
                                                          models::kLargestSampleDistanceDeg);
    faults_.push_back(
        {csv_.cell_mark(first, i_column),
         fmt::format("no samples between {:.8g} and {:.8g} degree{}", angle[first - 1], angle[first], others),
         fmt::format(
             "samples may be {} degree apart at the most, since the pressure between them is interpolated; give "
             "more of them",
             models::kLargestSampleDistanceDeg)});
  }

  double atmosphere() const { return stated_.reference == cycle::PressureReference::kGauge ? base::kAtmosphere : 0; }

  void check_repetition(const cycle::SampledTrace& samples, std::size_t i_column) {
    const auto& angle = samples.crank_angle_deg;
    if (angle.back() - angle.front() < cycle::kCycleDeg * (1 - 1e-9)) return;
    const double first = samples.value.front() + atmosphere(), last = samples.value.back() + atmosphere();
    const double mismatch = std::abs(last - first) / std::max(first, last);
    if (mismatch <= kNotedMismatch) return;
    const std::string message =
        fmt::format("the pressure is {:.6g} bar at {:.8g} degree and {:.6g} bar one cycle later, at {:.8g} degree",
                    samples.value.front() / 1e5, angle.front(), samples.value.back() / 1e5, angle.back());
    if (mismatch > kLargestMismatch) {
      faults_.push_back({csv_.cell_mark(angle.size() - 1, i_column), message,
                         "a cycle repeats itself; take the last sample out, or average the cycles"});
    } else {
      notes_.push_back(csv_.source.path + ": " + message);
    }
  }

  void check_pressures(const std::vector<double>& p, std::size_t i_column) {
    const bool gauge = stated_.reference == cycle::PressureReference::kGauge;
    for (std::size_t k = 0; k < p.size(); ++k) {
      if (p[k] + atmosphere() > 0) continue;
      const std::string rule = gauge ? "a gauge pressure is above -1.01325 bar" : "an absolute pressure is above 0";
      faults_.push_back({csv_.cell_mark(k, i_column), fmt::format("the pressure is {:.6g} Pa; {}", p[k], rule),
                         gauge ? "" : "is the trace a gauge pressure? Then gas.pressure_reference = \"gauge\""});
      return;
    }
    if (stated_.place == TracePlace::kCrankcase) return;
    const auto peak = std::max_element(p.begin(), p.end());
    if (*peak < kLeastPeak || *peak > kHighestPeak) {
      faults_.push_back({csv_.cell_mark(static_cast<std::size_t>(peak - p.begin()), i_column),
                         fmt::format("the highest pressure of the trace is {:.6g} bar", *peak / 1e5),
                         "is its unit right?"});
    }
  }

  CsvFile csv_;
  const TraceColumns& stated_;
  const Units& units_;
  std::vector<Fault> faults_;
  std::vector<std::string> notes_;
};

}  // namespace

TraceOutline trace_outline(const NamedFile& file, const Units& units) {
  const TraceColumns nothing_stated;
  return TraceReader(file, nothing_stated, units).outline();
}

TraceFile read_trace(const NamedFile& file, const TraceColumns& stated, const Units& units) {
  return TraceReader(file, stated, units).read();
}

}  // namespace ringfilm::io
