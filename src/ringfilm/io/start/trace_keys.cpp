#include "ringfilm/io/start/trace_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/case/trace_file.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/models/gas/gas.hpp"

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
  explicit TraceAnswers(TraceOutline seen) : seen_(std::move(seen)) {}

  TraceKeys answers(const std::string& name) {
    state("gas.model", quoted("trace"), "the cylinder pressure of a file");
    state("gas.cylinder_pressure", quoted(name), "relative to the folder of this file");
    column("gas.pressure_column", "gas.pressure_unit", "pressure", "bar, Pa, kPa or MPa", seen_.pressure);
    column("gas.angle_column", "gas.angle_unit", "crank angle", "degree or rad", seen_.angle);
    reference();
    zero();
    span();
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
      ask(column_key, "which column is the " + what + "? " + names_of(columns));
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
    const auto& p = seen_.samples.value;
    if (seen_.has_gauge_unit) {
      state("gas.pressure_reference", quoted("gauge"), kFromFile);
      keys_.missing.push_back("the unit " + *seen_.pressure.front().unit +
                              " in the header of the trace: write it without the g");
    } else if (!p.empty() && *std::min_element(p.begin(), p.end()) <= 0) {
      state("gas.pressure_reference", quoted("gauge"), kFromFile + ": the lowest pressure is not above zero");
    } else {
      ask("gas.pressure_reference",
          "absolute or gauge?" + (p.empty() ? ""
                                            : fmt::format(" The lowest pressure is {:.4g} bar",
                                                          *std::min_element(p.begin(), p.end()) / 1e5)));
    }
  }

  void zero() {
    const auto& p = seen_.samples.value;
    if (p.empty()) return ask("gas.angle_zero", "firing-tdc or gas-exchange-tdc?");
    const double peak =
        seen_.samples.crank_angle_deg[static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin())];
    constexpr double kCycle = 720, kHalf = 360;
    const auto follows = [peak](double tdc) {
      const double after = std::remainder(peak - tdc, kCycle);
      return after >= kEarliestPeak && after <= kLatestPeak;
    };
    const std::string place = fmt::format("the highest pressure is at {:.4g} degree", peak);
    if (follows(0)) return state("gas.angle_zero", quoted("firing-tdc"), kFromFile + ": " + place);
    if (follows(kHalf)) return state("gas.angle_zero", quoted("gas-exchange-tdc"), kFromFile + ": " + place);
    ask("gas.angle_zero", "firing-tdc or gas-exchange-tdc? " + place + " of the file");
  }

  void span() {
    const auto& angles = seen_.samples.crank_angle_deg;
    if (angles.empty()) return;
    const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
    const auto& p = seen_.samples.value;
    keys_.found.push_back(fmt::format("{} samples from {:.6g} to {:.6g} degree, highest pressure {:.4g} bar",
                                      angles.size(), *low, *high, *std::max_element(p.begin(), p.end()) / 1e5));
    if (models::covers_cycle(angles)) return;
    const std::string part = "the trace covers a part of the cycle; ";
    ask("gas.intake_pressure", part + "what is the pressure during intake, absolute?");
    ask("gas.exhaust_pressure", part + "what is the pressure during exhaust, absolute?");
  }

  TraceOutline seen_;
  TraceKeys keys_;
};

std::string named_from(const std::string& case_folder, const std::string& path) {
  if (fs::path(path).is_absolute()) return path;
  std::error_code error;
  const fs::path relative = fs::relative(path, case_folder.empty() ? fs::path(".") : fs::path(case_folder), error);
  return error || relative.empty() ? fs::absolute(path).string() : relative.string();
}

}  // namespace

TraceKeys trace_keys(const std::string& path, const std::string& case_folder, const Units& units) {
  TraceOutline seen = trace_outline({path, path}, units);
  if (seen.angle.empty() || seen.pressure.empty()) {
    throw InputError(std::vector<Fault>{
        {{path, 0, 0, ""},
         std::string("no column of the file is a ") + (seen.angle.empty() ? "crank angle" : "pressure"),
         "a header such as crank_angle [degree],cylinder_pressure [bar] is required"}});
  }
  return TraceAnswers(std::move(seen)).answers(named_from(case_folder, path));
}

}  // namespace ringfilm::io
