#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/study/study_curves.hpp"
#include "ringfilm/report/payload/even_pick.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/payload_study.hpp"
#include "ringfilm/report/payload/study_groups.hpp"
#include "ringfilm/study/sampling/morris.hpp"
#include "ringfilm/study/statistics/histogram.hpp"
#include "ringfilm/study/statistics/one_at_a_time.hpp"
#include "ringfilm/study/statistics/sobol_indices.hpp"
#include "ringfilm/study/statistics/statistics.hpp"
#include "ringfilm/study/statistics/values_of_base.hpp"
#include "ringfilm/study/statistics/weighted_mean.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kValueDigits = 6;
/// Numbers of factors that are held in memory at once, 8 MB.
constexpr std::uint64_t kMaxVariedNumbers = std::uint64_t{1} << 20;
/// Shares of the quantiles in the curves of convergence: 5 %, 50 %, 95 %.
const std::vector<double> kConvergingShares = {0.05, 0.5, 0.95};

ordered_json number(double value) { return rounded(value, kValueDigits); }
ordered_json number(const std::optional<double>& value) { return value ? number(*value) : ordered_json(nullptr); }

/// [value, low end, high end] of an interval.
ordered_json with_ends(double value, const std::optional<double>& low, const std::optional<double>& high) {
  return {number(value), number(low), number(high)};
}

ordered_json mean_object(const study::Mean& mean) {
  const double half = study::mean_half_width(mean.count) * mean.standard_error;
  return with_ends(mean.value, mean.value - half, mean.value + half);
}

ordered_json statistics_object(const std::vector<double>& values, const std::vector<double>& sorted, bool is_sample) {
  if (sorted.empty()) return nullptr;
  ordered_json object = {{"n", sorted.size()},
                         {"omitted", values.size() - sorted.size()},
                         {"lowest", number(sorted.front())},
                         {"highest", number(sorted.back())}};
  if (!is_sample) {
    object["median"] = number(study::quantile_of(sorted, 0.5).value);
    return object;
  }
  const auto mean = study::mean_of(values);
  object["mean"] = mean ? mean_object(*mean) : ordered_json(nullptr);
  object["deviation"] = mean ? number(mean->deviation) : ordered_json(nullptr);
  ordered_json quantiles = ordered_json::array();
  for (const double share : io::band_shares()) {
    const study::Quantile q = study::quantile_of(sorted, share);
    quantiles.push_back(with_ends(q.value, q.low, q.high));
  }
  object["quantiles"] = std::move(quantiles);
  return object;
}

/// Adds the weighted mean over operating points; nothing for any other sampling.
void add_weighted_mean(const study::Plan& plan, const std::vector<double>& all, std::size_t base,
                       ordered_json& statistics) {
  if (plan.study().sampling.method == study::Method::kOperatingPoints)
    statistics["weighted_mean"] = number(study::weighted_mean(plan, all, base));
}

/// Everything about the main values that is drawn.
class MainValues {
 public:
  MainValues(const io::StudyRows& rows, const io::Units& units, ordered_json& payload)
      : plan_(rows.plan), units_(units), payload_(payload), groups_(comparison_groups(rows.plan, units)) {
    for (const char* part :
         {"histograms", "indices", "sensitivities", "convergence", "effects", "comparison", "extremes", "point_values"})
      payload_[part] = ordered_json::object();
    ordered_json names = ordered_json::array();
    for (const ComparisonGroup& group : groups_) names.push_back({{"name", group.name}, {"base", group.base}});
    payload_["comparison_groups"] = std::move(names);
    if (has_sensitivities()) pick_for_sensitivities();
  }

  void add(const std::string& name, const std::vector<double>& all) {
    const bool is_sample = study::has_sample(plan_);
    if (is_sample) payload_["histograms"][name] = histogram_object(all);
    for (std::size_t b = 0; b < plan_.study().bases.size(); ++b) {
      if (settles()) payload_["convergence"][name].push_back(convergence_object(of_base(all, b)));
      if (plan_.study().sampling.indices != study::Indices::kNone)
        payload_["indices"][name].push_back(
            indices_object(study::values_of_base(plan_, all, b, study::Among::kAll), b));
      if (has_sensitivities()) payload_["sensitivities"][name].push_back(sensitivities_object(all, b));
      if (plan_.study().sampling.method == study::Method::kMorris)
        payload_["effects"][name].push_back(
            effects_object(study::values_of_base(plan_, all, b, study::Among::kAll), b));
      if (!is_sample) payload_["extremes"][name].push_back(extremes_object(all, b));
      if (plan_.study().sampling.method == study::Method::kOperatingPoints)
        payload_["point_values"][name].push_back(
            rounded_list(study::values_of_base(plan_, all, b, study::Among::kAll), kValueDigits));
    }
    if (!groups_.empty()) payload_["comparison"][name] = comparison_object(all);
  }

 private:
  /// The first points of a list are not a sample of the others: its order is as it was written.
  bool settles() const { return study::has_sample(plan_) && !study::is_listed(plan_.study().sampling.method); }

  bool has_sensitivities() const {
    return study::has_sample(plan_) || plan_.study().sampling.method == study::Method::kOneAtATime;
  }

  std::vector<double> of_base(const std::vector<double>& all, std::size_t base) const {
    return study::values_of_base(plan_, all, base, study::Among::kSample);
  }

  ordered_json histogram_object(const std::vector<double>& all) const {
    std::vector<std::vector<double>> sorted;
    for (std::size_t b = 0; b < plan_.study().bases.size(); ++b)
      sorted.push_back(study::sorted_values(of_base(all, b)));
    const study::Histogram found = study::histogram(sorted);
    return {{"edges", rounded_list(found.edges, kValueDigits)},
            {"counts", found.counts},
            {"below", found.below},
            {"above", found.above}};
  }

  ordered_json convergence_object(const std::vector<double>& values) const {
    ordered_json n = ordered_json::array(), mean = ordered_json::array();
    std::vector<ordered_json> quantiles(kConvergingShares.size(), ordered_json::array());
    if (values.empty()) return nullptr;
    for (const study::Stage& stage : study::convergence(values, kConvergingShares)) {
      n.push_back(stage.n);
      mean.push_back(stage.mean ? mean_object(*stage.mean) : ordered_json(nullptr));
      for (std::size_t q = 0; q < quantiles.size(); ++q) {
        quantiles[q].push_back(q < stage.quantiles.size() ? with_ends(stage.quantiles[q].value, stage.quantiles[q].low,
                                                                      stage.quantiles[q].high)
                                                          : ordered_json(nullptr));
      }
    }
    return {{"n", std::move(n)}, {"mean", std::move(mean)}, {"quantiles", quantiles}};
  }

  /// Null for a group that moves nothing in that base.
  ordered_json indices_object(const std::vector<double>& values, std::size_t base) const {
    const auto found = study::sobol_indices(values, plan_.groups().size());
    if (!found) return nullptr;
    ordered_json first = ordered_json::array(), total = ordered_json::array();
    for (std::size_t g = 0; g < plan_.groups().size(); ++g) {
      const bool moves = study::applies(plan_.groups()[g], plan_.study(), base);
      const auto reported = [moves](const study::Interval& one) {
        return moves ? with_ends(one.value, one.low, one.high) : ordered_json(nullptr);
      };
      first.push_back(reported(found->first[g]));
      total.push_back(reported(found->total[g]));
    }
    return {{"rows", found->rows}, {"omitted", found->omitted}, {"first", first}, {"total", total}};
  }

  /// The factors' numbers of all scenarios may not fit into memory: of a large sample an even part of each base.
  void pick_for_sensitivities() {
    const study::Study& study = plan_.study();
    const std::uint64_t most = kMaxVariedNumbers / std::max<std::size_t>(study.factors.size() * study.bases.size(), 1);
    varied_.resize(study.bases.size());
    for (std::size_t b = 0; b < study.bases.size(); ++b) {
      std::uint64_t n = 0;
      for (std::uint64_t p = 0; p < plan_.n_points(b); ++p) n += is_varied(p) ? 1 : 0;
      const std::vector<std::uint64_t> picked = evenly_picked(n, study::has_sample(plan_) ? most : n);
      varied_[b].factors.resize(study.factors.size());
      std::uint64_t place = 0;
      auto next = picked.begin();
      for (std::uint64_t p = 0; p < plan_.n_points(b) && next != picked.end(); ++p) {
        if (!is_varied(p) || place++ != *next) continue;
        ++next;
        varied_[b].scenarios.push_back(plan_.scenario(b, p));
        const study::Point point = plan_.point(varied_[b].scenarios.back());
        for (std::size_t j = 0; j < study.factors.size(); ++j)
          varied_[b].factors[j].push_back(point.values[j].value_or(std::nan("")));
      }
    }
  }

  bool is_varied(std::uint64_t p) const { return !study::has_sample(plan_) || plan_.is_sample(p); }

  /// For each factor the value where it is low and where it is high; null where that is unknown.
  ordered_json sensitivities_object(const std::vector<double>& all, std::size_t base) const {
    const VariedFactors& varied = varied_[base];
    std::vector<double> values;
    for (const std::uint64_t i : varied.scenarios) values.push_back(all[i]);
    ordered_json sensitivities = ordered_json::array();
    for (std::size_t j = 0; j < varied.factors.size(); ++j) {
      const auto sensitivity =
          study::has_sample(plan_)
              ? study::one_at_a_time_sensitivity(varied.factors[j], values,
                                                 study::sensitivity_ends(plan_.study().factors[j].variation))
              : sensitivity_alone(values, varied.factors[j]);
      sensitivities.push_back(sensitivity ? ordered_json{number(sensitivity->low), number(sensitivity->high)}
                                          : ordered_json(nullptr));
    }
    const auto sorted = study::sorted_values(of_base(all, base));
    const double own = all[plan_.scenario(base, 0)];
    const double middle =
        study::has_sample(plan_) ? (sorted.empty() ? std::nan("") : study::quantile_of(sorted, 0.5).value) : own;
    return {{"middle", number(middle)}, {"factors", std::move(sensitivities)}};
  }

  /// One at a time: the points that move this factor, at its lowest and its highest value.
  static std::optional<study::OneAtATimeSensitivity> sensitivity_alone(const std::vector<double>& values,
                                                                       const std::vector<double>& factor) {
    std::optional<std::size_t> low, high;
    for (std::size_t p = 1; p < factor.size(); ++p) {
      // A factor that another point moves has its value of point 0.
      if (!std::isfinite(factor[p]) || factor[p] == factor.front()) continue;
      if (!low || factor[p] < factor[*low]) low = p;
      if (!high || factor[p] > factor[*high]) high = p;
    }
    if (!low || !std::isfinite(values[*low]) || !std::isfinite(values[*high])) return std::nullopt;
    return study::OneAtATimeSensitivity{values[*low], values[*high]};
  }

  /// Null for a factor that moves nothing in that base, and where too few scenarios were solved.
  ordered_json effects_object(const std::vector<double>& values, std::size_t base) const {
    ordered_json effects = ordered_json::array();
    const auto found = study::morris_effects(plan_.trajectories(), values);
    for (std::size_t j = 0; j < found.size(); ++j) {
      const auto& effect = found[j];
      if (!effect || !study::applies(plan_.study().factors[j], base)) {
        effects.push_back(nullptr);
        continue;
      }
      effects.push_back({{"mean", number(effect->mean)},
                         {"mean_absolute", number(effect->mean_absolute)},
                         {"half_width", number(study::mean_half_width(effect->count) * effect->mean_absolute_error)},
                         {"deviation", number(effect->deviation)},
                         {"count", effect->count},
                         {"omitted", effect->omitted}});
    }
    return effects;
  }

  ordered_json comparison_object(const std::vector<double>& all) const {
    ordered_json list = ordered_json::array();
    const auto picked = [&](const ComparisonGroup& group) {
      std::vector<double> values;
      for (const std::uint64_t i : group.scenarios) values.push_back(all[i]);
      return values;
    };
    const std::vector<double> first = picked(groups_.front());
    for (const ComparisonGroup& group : groups_) {
      const std::vector<double> values = picked(group);
      ordered_json object = statistics_object(values, study::sorted_values(values), study::has_sample(plan_));
      if (!object.is_null() && group.scenarios.size() == plan_.n_points(group.base))
        add_weighted_mean(plan_, all, group.base, object);
      // Both groups have the same points: their differences are more certain than their levels.
      if (!object.is_null() && study::has_sample(plan_) && group.pairs_with_first && &group != &groups_.front()) {
        const auto difference = study::relative_difference(first, values);
        if (difference) object["difference"] = mean_object(*difference);
      }
      list.push_back(std::move(object));
    }
    return list;
  }

  /// Where a value is lowest and highest in a base; null where no scenario was solved.
  ordered_json extremes_object(const std::vector<double>& all, std::size_t base) const {
    const auto extremes = extreme_scenarios(plan_, all, base);
    if (!extremes) return nullptr;
    return {{"lowest", scenario_name(plan_, extremes->first, units_)},
            {"highest", scenario_name(plan_, extremes->second, units_)}};
  }

  const study::Plan& plan_;
  const io::Units& units_;
  ordered_json& payload_;
  std::vector<ComparisonGroup> groups_;

  /// Scenarios of a base from which sensitivities are reported, with the numbers of their factors.
  struct VariedFactors {
    std::vector<std::uint64_t> scenarios;
    std::vector<std::vector<double>> factors;
  };
  std::vector<VariedFactors> varied_;
};

/// Operating points with their shares in the weights; empty for other plans.
ordered_json points_array(const study::Plan& plan) {
  const std::vector<study::WeightedPoint>& points = plan.study().sampling.points;
  double largest = 0, sum = 0;  // relative to the largest: the sum of huge weights is not finite
  for (const study::WeightedPoint& point : points) largest = std::max(largest, point.weight);
  for (const study::WeightedPoint& point : points) sum += point.weight / largest;
  ordered_json list = ordered_json::array();
  for (const study::WeightedPoint& point : points)
    list.push_back({{"name", point.name}, {"share", number(point.weight / largest / sum)}});
  return list;
}

}  // namespace

void add_study_values(const io::StudyRows& rows, const io::Units& units, ordered_json& payload) {
  const bool is_sample = study::has_sample(rows.plan);
  const study::Among among = is_sample ? study::Among::kSample : study::Among::kAll;
  const auto& names = rows.plan.values().main;
  MainValues main(rows, units, payload);
  ordered_json statistics = ordered_json::object();
  const auto& quantities = rows.plan.values().quantities;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const std::vector<double> all = rows.values(i);
    ordered_json of_bases = ordered_json::array();
    for (std::size_t b = 0; b < rows.plan.study().bases.size(); ++b) {
      const std::vector<double> values = study::values_of_base(rows.plan, all, b, among);
      of_bases.push_back(statistics_object(values, study::sorted_values(values), is_sample));
      if (!of_bases.back().is_null()) add_weighted_mean(rows.plan, all, b, of_bases.back());
    }
    statistics[quantities[i].name] = std::move(of_bases);
    if (std::find(names.begin(), names.end(), quantities[i].name) != names.end()) main.add(quantities[i].name, all);
  }
  payload["points"] = points_array(rows.plan);
  payload["shares"] = io::band_shares();
  payload["converging_shares"] = kConvergingShares;
  payload["statistics"] = std::move(statistics);
}

}  // namespace ringfilm::report
