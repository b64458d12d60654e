#include "ringfilm/run/trends.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/start/start_case.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/run/run.hpp"

namespace ringfilm::run {
namespace {

namespace fs = std::filesystem;
using study::CrankWindow;
using study::Trend;
using study::TrendLevel;
using study::TrendProbe;
using study::WindowValue;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Start cases as files, in a folder that is gone at the end of the scope.
class StartCaseFiles {
 public:
  StartCaseFiles() = default;
  StartCaseFiles(const StartCaseFiles&) = delete;
  StartCaseFiles& operator=(const StartCaseFiles&) = delete;
  ~StartCaseFiles() {
    std::error_code error;
    if (!folder_.empty()) fs::remove_all(folder_, error);
  }

  /// The file of the start case of an engine.
  std::string path(const std::string& engine) {
    if (folder_.empty()) {
      std::error_code error;
      std::string name = (fs::temp_directory_path(error) / "ringfilm-trends-XXXXXX").string();
      if (error || ::mkdtemp(name.data()) == nullptr) {
        throw InputError(name + ": no scratch folder can be made there", "set TMPDIR");
      }
      folder_ = name;
    }
    const fs::path file = folder_ / (engine + ".toml");
    if (!fs::exists(file)) io::write_atomically(file.string(), io::start_case({.engine = engine}).text);
    return file.string();
  }

 private:
  fs::path folder_;
};

/// The faces of one ring, or of the only one. Throws InputError for a ring that the case does not have.
std::vector<const io::ResultDocument*> faces_of(const io::ResultDocument& document, const TrendProbe& probe) {
  if (document.is_pack() && !probe.ring) {
    throw InputError(probe.quantity + " has no value for all rings of a pack", "state the ring");
  }
  std::vector<const io::ResultDocument*> faces;
  if (!document.is_pack()) {
    faces.push_back(&document);
    return faces;
  }
  const std::vector<std::size_t> numbers = io::ring_numbers(document);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] == *probe.ring) faces.push_back(&document.rings[i]);
  }
  if (faces.empty()) throw InputError("the pack has no ring " + std::to_string(*probe.ring), "");
  return faces;
}

double window_value(const std::vector<cycle::Sample>& samples, double cycle::Sample::*member,
                    const CrankWindow& window) {
  std::vector<double> inside;
  for (const cycle::Sample& sample : samples) {
    if (sample.crank_angle_deg < window.from_deg || sample.crank_angle_deg > window.to_deg) continue;
    inside.push_back(sample.*member);
  }
  if (inside.empty()) return kNothing;
  if (window.value == WindowValue::kMax) return *std::max_element(inside.begin(), inside.end());
  if (window.value == WindowValue::kMin) return *std::min_element(inside.begin(), inside.end());
  return std::accumulate(inside.begin(), inside.end(), 0.0) / static_cast<double>(inside.size());
}

/// A value of the rings; of an oil ring that of its first rail, or the sum where rails add up.
double ring_value(const io::ResultDocument& document, const TrendProbe& probe, const std::string& name) {
  if (probe.window) {
    const auto& quantity = *find_by_name(cycle::curve_quantities(), name);
    return window_value(faces_of(document, probe).front()->result.samples, quantity.value, *probe.window);
  }
  const auto& quantity = *find_by_name(cycle::cycle_quantities(), name);
  if (document.is_pack() && !probe.ring && quantity.adds_over_rings) return document.result.values.*quantity.value;
  const std::vector<const io::ResultDocument*> faces = faces_of(document, probe);
  double sum = 0;
  for (const io::ResultDocument* face : faces) {
    sum += face->result.values.*quantity.value;
    if (!quantity.adds_over_rings) break;
  }
  return sum;
}

double value(const Result& result, const TrendProbe& probe, const std::string& name) {
  if (const auto* gas = std::get_if<io::GasPathDocument>(&result)) {
    return cycle::number_of(cycle::gas_sum_quantity(name.c_str()), gas->gas.sums).value_or(kNothing);
  }
  const auto* rings = std::get_if<io::ResultDocument>(&result);
  if (rings == nullptr) throw InputError("the case is not one of rings in an engine cycle", "name another base");
  return ring_value(*rings, probe, name);
}

class TrendRunner {
 public:
  explicit TrendRunner(const study::TrendList& list) : list_(list) {}

  study::TrendOutcome outcome(const Trend& trend) {
    study::TrendOutcome outcome{trend, study::probed_quantity(trend.probe), {}, 0, {}, {}};
    outcome.values = values(trend, outcome.stops);
    outcome.change = study::relative_change(outcome.values);
    double change_of_other = 0;
    if (trend.expectation == study::TrendExpectation::kLargerChangeThan) {
      const auto other = std::ranges::find(list_.trends, trend.than, &Trend::id);
      change_of_other = study::relative_change(values(*other, outcome.stops));
    }
    outcome.found = study::agreement(trend, outcome.values, change_of_other);
    return outcome;
  }

 private:
  /// The number of each level; NaN where a run stopped, which `stops` receives.
  std::vector<double> values(const Trend& trend, std::vector<std::string>& stops) {
    std::vector<double> all;
    for (const TrendLevel& level : trend.levels) {
      try {
        all.push_back(value(trend, level));
      } catch (const ConvergenceError& stopped) {
        stops.push_back(level.name + ": " + stopped.what());
        all.push_back(kNothing);
      } catch (const InputError& error) {
        std::vector<Fault> faults = error.faults();
        for (Fault& fault : faults) fault.message = "trend " + trend.id + ", " + level.name + ": " + fault.message;
        throw InputError(std::move(faults));
      }
    }
    return all;
  }

  double value(const Trend& trend, const TrendLevel& level) {
    const Outcome& run = computed(trend, level);
    if (run.stopped) throw ConvergenceError(*run.stopped);
    const TrendProbe& probe = trend.probe;
    const double number = run::value(run.result, probe, probe.quantity);
    return probe.share_of ? number / run::value(run.result, probe, *probe.share_of) : number;
  }

  const Outcome& computed(const Trend& trend, const TrendLevel& level) {
    const auto purpose = study::is_of_gas(trend.probe) ? cycle::CasePurpose::kGasPath : cycle::CasePurpose::kFilm;
    std::vector<std::string> settings = trend.settings;
    settings.insert(settings.end(), level.settings.begin(), level.settings.end());
    const std::string key =
        trend.base + (purpose == cycle::CasePurpose::kGasPath ? "\ngas\n" : "\nfilm\n") + joined(settings, "\n");
    const auto found = runs_.find(key);
    if (found != runs_.end()) return found->second;
    std::vector<io::Override> overrides;
    for (const std::string& setting : settings) {
      const std::size_t equal_sign = setting.find('=');
      overrides.push_back({setting.substr(0, equal_sign), setting.substr(equal_sign + 1)});
    }
    std::vector<io::DroppedKey> dropped;
    const cycle::Case c = io::read_case_dropping(path(trend.base), overrides, units_, dropped, purpose);
    Options options;
    options.describe = false;
    return runs_.emplace(key, run_case(c, options)).first->second;
  }

  std::string path(const std::string& base) {
    const auto found = std::ranges::find(list_.bases, base, &study::TrendBase::name);
    return found->start_engine.empty() ? found->path : start_cases_.path(found->start_engine);
  }

  const study::TrendList& list_;
  io::Units units_;
  StartCaseFiles start_cases_;
  std::map<std::string, Outcome> runs_;
};

}  // namespace

std::vector<study::TrendOutcome> run_trends(const study::TrendList& list,
                                            const std::function<bool(const std::string& id)>& is_selected,
                                            const std::function<void(const study::TrendOutcome&)>& done) {
  TrendRunner runner(list);
  std::vector<study::TrendOutcome> outcomes;
  for (const Trend& trend : list.trends) {
    if (!is_selected(trend.id)) continue;
    outcomes.push_back(runner.outcome(trend));
    if (done) done(outcomes.back());
  }
  return outcomes;
}

}  // namespace ringfilm::run
