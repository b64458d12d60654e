#include "ringfilm/study/sampled_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/ensemble/error_estimate.hpp"
#include "ringfilm/study/sampling/hash.hpp"
#include "ringfilm/study/statistics/statistics.hpp"
#include "ringfilm/study/study_run.hpp"

namespace ringfilm::study {
namespace {

using Rows = std::vector<std::vector<double>>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// 2^p / (2^p - 1) of the lowest order of the schemes, p = 1; eq-sampled-error.
constexpr double kBeyondFiner = 2;
/// Share of the largest value of a sample below which a value counts as zero, as boundary friction in full films.
constexpr double kNegligible = 1e-6;
/// Keeps the draw apart from those of the plan, which have the same seed.
constexpr std::uint64_t kStream = 0x5a;

bool is_solved(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Nothing, too, of a scenario that is refused: a row without values.
std::optional<double> accuracy_asked(const Plan& plan, std::uint64_t scenario) {
  try {
    return scenario_case(plan.study(), plan.point(scenario)).solver.accuracy;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Factors may choose an accuracy, or cells, steps and supplies with which none is asked for.
bool asks_for_accuracy(const Plan& plan) {
  for (std::size_t base = 0; base < plan.study().bases.size(); ++base) {
    const std::vector<std::uint64_t> some = spread_scenarios(plan, base);
    if (std::any_of(some.begin(), some.end(), [&](std::uint64_t i) { return accuracy_asked(plan, i).has_value(); })) {
      return true;
    }
  }
  return false;
}

/// To what the error of a value is relative. The net flow may vanish although both flows are there.
double scale_of(const StudyValues& values, std::size_t i, const std::vector<double>& finer) {
  if (cycle::is_regime_share(values.quantities[i])) return 1;
  const auto both_flows = values.index("mean_absolute_oil_flow");
  return std::abs(values.quantities[i].name == "net_oil_flow" && both_flows ? finer[*both_flows] : finer[i]);
}

/// Nothing (NaN) of a value that is absent, or so small that it is nothing next to those of other scenarios.
double relative_error(double own, double finer, double scale, double nothing) {
  if (std::isnan(own) || std::isnan(finer) || std::max(std::abs(own), std::abs(finer)) <= nothing) return kNone;
  if (scale == 0) return kNone;
  return kBeyondFiner * std::abs(own - finer) / scale;
}

}  // namespace

std::optional<double> SampledError::coverage() const {
  if (n_values == 0) return std::nullopt;
  return static_cast<double>(n_within) / static_cast<double>(n_values);
}

std::uint64_t sample_size(const Plan& plan) {
  const Study& study = plan.study();
  if (study.compute == Compute::kGas) return 0;
  const std::uint64_t usual = asks_for_accuracy(plan) ? Accuracy::kUsualSample : 0;
  return std::min(study.accuracy.sample.value_or(usual), plan.size());
}

std::vector<std::uint64_t> sampled_scenarios(const Plan& plan) {
  const std::uint64_t n = sample_size(plan);
  std::vector<std::uint64_t> scenarios;
  for (std::uint64_t k = 0; k < n; ++k) {
    // Drawn, so that no factor of a grid is met at one of its levels alone.
    const ScenarioRange part = shard_range(plan.size(), k + 1, n);
    scenarios.push_back(part.first + hash(plan.study().seed, kStream, k) % part.size());
  }
  return scenarios;
}

SampledError compared(const StudyValues& values, const std::vector<std::uint64_t>& scenarios, const Rows& own,
                      const Rows& finer, const std::vector<std::optional<double>>& asked) {
  SampledError error;
  std::vector<std::size_t> used;  // places in the sample
  std::set<double> all_asked;
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    if (!is_solved(own[k]) || !is_solved(finer[k])) continue;
    used.push_back(k);
    error.scenarios.push_back(scenarios[k]);
    if (asked[k]) all_asked.insert(*asked[k]);
  }
  error.n_unsolved = scenarios.size() - used.size();
  error.asked.assign(all_asked.begin(), all_asked.end());
  error.quantiles.resize(values.quantities.size());
  for (std::size_t i = 0; i < values.quantities.size(); ++i) {
    if (values.quantities[i].unit == "degree") continue;
    const bool is_moved = std::any_of(used.begin(), used.end(), [&](std::size_t k) {
      return std::isfinite(own[k][i]) && std::isfinite(finer[k][i]) && own[k][i] != finer[k][i];
    });
    if (!is_moved) continue;
    double largest = 0;
    for (const std::size_t k : used) largest = std::max(largest, std::isnan(finer[k][i]) ? 0 : std::abs(finer[k][i]));
    std::vector<double> errors;
    for (const std::size_t k : used) {
      const double one = relative_error(own[k][i], finer[k][i], scale_of(values, i, finer[k]), kNegligible * largest);
      if (std::isnan(one)) continue;
      errors.push_back(one);
      if (!asked[k]) continue;
      constexpr double kPercent = 100;
      ++error.n_values;
      error.n_within += kPercent * one <= *asked[k] ? 1 : 0;
    }
    std::sort(errors.begin(), errors.end());
    if (!errors.empty()) error.quantiles[i] = quantile_of(errors, kErrorShare).value;
  }
  return error;
}

std::optional<SampledError> sampled_error(const Plan& plan,
                                          const std::function<std::vector<double>(std::uint64_t)>& own,
                                          const Progress& progress, const BatchOptions& options) {
  const std::vector<std::uint64_t> scenarios = sampled_scenarios(plan);
  if (scenarios.empty()) return std::nullopt;
  std::vector<std::optional<double>> asked;
  Rows own_values;
  for (const std::uint64_t i : scenarios) {
    own_values.push_back(own(i));
    asked.push_back(accuracy_asked(plan, i));
  }
  return compared(plan.values(), scenarios, own_values,
                  values_of_changed(plan, scenarios, finer_grid, progress, options), asked);
}

}  // namespace ringfilm::study
