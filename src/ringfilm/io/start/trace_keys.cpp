#include "ringfilm/io/start/trace_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/gas_plausibility.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/cycle/setup/trace_zero.hpp"
#include "ringfilm/io/data/trace_file.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

/// A fired or motored peak lies this far around firing TDC [degree].
constexpr double kEarliestPeak = -20, kLatestPeak = 60;
const std::string kFromFile = "from the file";

std::string names_of(const std::vector<TraceColumn>& columns) {
  std::string names;
  for (const TraceColumn& column : columns) names += (names.empty() ? "" : ", ") + quoted(column.name);
  return names;
}

/// Gathers what a trace shows and what it does not.
class TraceAnswers {
 public:
  TraceAnswers(TraceOutline seen, const cycle::Engine& engine, const TableReading& stated)
      : seen_(std::move(seen)), stated_(stated) {
    case_.engine = engine;
  }

  TraceKeys answers(const std::string& name) {
    state("gas.model", quoted("trace"), "the cylinder pressure of a file");
    state("gas.cylinder_pressure", quoted(name), "relative to the folder of this file");
    if (stated_.columns) state("gas.columns", quoted(*stated_.columns), "of the file, as stated");
    if (stated_.skip_lines) {
      state("gas.skip_lines", std::to_string(*stated_.skip_lines),
            "lines of the file in front of its table, as stated");
    }
    for (const std::string& note : seen_.notes) keys_.found.push_back(note);
    column("gas.pressure_column", "gas.pressure_unit", "pressure", kPressureUnits, seen_.pressure);
    if (seen_.is_degree_by_span) {
      state("gas.angle_unit", quoted("degree"), kFromFile + ": radians would span more than a cycle");
    } else {
      column("gas.angle_column", "gas.angle_unit", "crank angle", kAngleUnits, seen_.angle);
    }
    reference();
    const bool has_zero = zero();
    span();
    if (has_zero && seen_.is_in_pascal && models::covers_cycle(seen_.crank_angle_deg)) {
      indicated_pressure();
      pressures();
    }
    return std::move(keys_);
  }

 private:
  void state(const std::string& key, const std::string& value, const std::string& remark) {
    keys_.values.push_back({key, value, remark});
  }
  void ask(const std::string& key, const std::string& question) {
    keys_.values.push_back({key, "", question});
    keys_.missing.push_back(key + ": " + question);
  }

  void column(const std::string& column_key, const std::string& unit_key, const std::string& what,
              const std::string& unit_names, const std::vector<TraceColumn>& columns) {
    if (columns.size() > 1) {
      std::vector<std::string> names;
      for (const TraceColumn& one : columns) names.push_back(one.name);
      const std::string pattern = what == "pressure" ? pattern_of_cycles(names) : "";
      ask(column_key, "which column is the " + what + "? " + names_of(columns) +
                          (pattern.empty() ? "" : "; all, with one cycle each: " + quoted(pattern)));
      return;
    }
    if (columns.front().unit) {
      keys_.found.push_back(what + " in the column " + quoted(columns.front().name) + ", in " + *columns.front().unit);
    } else {
      ask(unit_key,
          "the header has no unit of the " + what + " " + quoted(columns.front().name) + ": " + unit_names + "?");
    }
  }

  void reference() {
    const auto& p = seen_.pressure_values;
    if (seen_.reference_of_unit) {
      const bool is_gauge = seen_.reference_of_unit == cycle::PressureReference::kGauge;
      state("gas.pressure_reference", quoted(is_gauge ? "gauge" : "absolute"), kFromFile);
      return;
    }
    const std::string question = "absolute or gauge?";
    if (p.empty()) return ask("gas.pressure_reference", question);
    const auto lowest = std::min_element(p.begin(), p.end());
    if (*lowest <= 0 && !seen_.has_lone_low_pressure()) {
      state("gas.pressure_reference", quoted("gauge"), kFromFile + ": the lowest pressure is not above zero");
    } else if (*lowest <= 0) {
      ask("gas.pressure_reference",
          fmt::format("{} One sample alone, at {:.6g} degree, is not above zero: if it is a fault of the measurement, "
                      "correct it in the file",
                      question, seen_.crank_angle_deg[static_cast<std::size_t>(lowest - p.begin())]));
    } else {
      ask("gas.pressure_reference",
          question + (seen_.is_in_pascal ? " The lowest pressure is " + text_in(*lowest, kBar, 4) : ""));
    }
  }

  /// @returns whether the file shows it
  bool zero() {
    const auto& p = seen_.pressure_values;
    if (p.empty()) {
      ask("gas.angle_zero", "firing-tdc or gas-exchange-tdc?");
      return false;
    }
    const double peak =
        seen_.crank_angle_deg[static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin())];
    constexpr double kCycle = 720, kHalf = 360;
    const auto follows = [peak](double tdc) {
      const double after = std::remainder(peak - tdc, kCycle);
      return after >= kEarliestPeak && after <= kLatestPeak;
    };
    const std::string place = fmt::format("the highest pressure is at {:.4g} degree", peak);
    const bool at_firing = follows(0);
    if (at_firing || follows(kHalf)) {
      case_.gas.angle_zero = at_firing ? cycle::AngleZero::kFiringTdc : cycle::AngleZero::kGasExchangeTdc;
      state("gas.angle_zero", quoted(at_firing ? "firing-tdc" : "gas-exchange-tdc"), kFromFile + ": " + place);
      return true;
    }
    ask("gas.angle_zero", "firing-tdc or gas-exchange-tdc? " + place + " of the file");
    return false;
  }

  /// Mean indicated pressure of the whole cycle: the work on the piston, whatever the zero of the pressures.
  void indicated_pressure() {
    std::vector<double> angles;
    for (const double angle : seen_.crank_angle_deg) angles.push_back(cycle::from_firing_deg(case_.gas, angle));
    keys_.found.push_back(
        "indicated mean effective pressure of the cycle " +
        text_in(cycle::indicated_mean_pressure(case_.engine, angles, seen_.pressure_values), kBar, 4) +
        " (IMEP, with the crank of this engine): compare it with the one stated for the trace");
  }

  /// Notes where no reference that the pressures can have makes them probable; those of the first one.
  void pressures() {
    using enum cycle::PressureReference;
    case_.gas.model = cycle::GasModel::kTrace;
    case_.gas.cylinder_pressure = cycle::SampledTrace{seen_.crank_angle_deg, seen_.pressure_values};
    const auto& p = seen_.pressure_values;
    std::vector<cycle::PressureReference> possible = {kAbsolute, kGauge};
    if (seen_.reference_of_unit) possible = {*seen_.reference_of_unit};
    if (!(*std::min_element(p.begin(), p.end()) > 0)) possible = {kGauge};
    std::vector<cycle::Note> noted;
    for (const cycle::PressureReference reference : possible) {
      case_.gas.pressure_reference = reference;
      std::vector<cycle::Note> notes;
      cycle::append_gas_notes(case_, cycle::cylinder_pressure(case_), notes);
      if (notes.empty()) return;
      if (noted.empty()) noted = std::move(notes);
    }
    for (cycle::Note& note : noted) keys_.notes.push_back(std::move(note.message));
  }

  void span() {
    const auto& angles = seen_.crank_angle_deg;
    if (angles.empty()) return;
    const auto& p = seen_.pressure_values;
    const std::string highest =
        seen_.is_in_pascal ? ", highest pressure " + text_in(*std::max_element(p.begin(), p.end()), kBar, 4) : "";
    keys_.found.push_back(fmt::format("{} samples from {:.6g} to {:.6g} degree{}", angles.size(), angles.front(),
                                      angles.back(), highest));
    if (models::covers_cycle(angles)) return;
    const std::string part = "the trace covers a part of the cycle" +
                             (models::covers_one_revolution(angles) ? std::string(", ") + models::kOneRevolution : "") +
                             "; ";
    ask("gas.intake_pressure", part + "what is the pressure during intake, absolute?");
    ask("gas.exhaust_pressure", part + "what is the pressure during exhaust, absolute?");
  }

  TraceOutline seen_;
  const TableReading& stated_;
  cycle::Case case_;  ///< case with engine and gas alone
  TraceKeys keys_;
};

std::string named_from(const std::string& case_folder, const std::string& path) {
  if (fs::path(path).is_absolute()) return path;
  std::error_code error;
  const fs::path relative = fs::relative(path, case_folder.empty() ? fs::path(".") : fs::path(case_folder), error);
  return error || relative.empty() ? fs::absolute(path).string() : relative.string();
}

/// The rules of a case on the span of its trace.
void check_span(const std::string& path, const std::vector<double>& crank_angle_deg) {
  cycle::Case c;
  c.gas.model = cycle::GasModel::kTrace;
  c.gas.cylinder_pressure_file = path;
  c.gas.cylinder_pressure = cycle::SampledTrace{crank_angle_deg, {}};
  std::vector<Fault> faults;
  for (const cycle::RuleBreach& breach : cycle::broken_rules(c)) {
    if (breach.key == "gas.cylinder_pressure") faults.push_back({{path, 0, 0, ""}, breach.message, breach.remedy});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

TraceKeys trace_keys(const std::string& path, const std::string& case_folder, const cycle::Engine& engine,
                     const Units& units, const TableReading& stated) {
  TraceOutline seen = trace_outline({path, path}, units, stated);
  check_span(path, seen.crank_angle_deg);
  return TraceAnswers(std::move(seen), engine, stated).answers(named_from(case_folder, path));
}

}  // namespace ringfilm::io
