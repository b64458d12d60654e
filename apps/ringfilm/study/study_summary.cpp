#include "study/study_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/report/payload/study_groups.hpp"
#include "ringfilm/study/sampling/morris.hpp"
#include "ringfilm/study/statistics/sobol_indices.hpp"
#include "ringfilm/study/statistics/statistics.hpp"
#include "ringfilm/study/statistics/values_of_base.hpp"
#include "ringfilm/study/statistics/weighted_mean.hpp"

namespace ringfilm::app {
namespace {

class Summary {
 public:
  explicit Summary(const io::StudyRows& rows) : rows_(rows), plan_(rows.plan) {}

  std::string text() {
    const study::Study& study = plan_.study();
    text_ = fmt::format("{}\n", study.title);
    for (const std::string& note : rows_.notes()) text_ += fmt::format("note: {}\n", note);
    for (std::size_t b = 0; b < study.bases.size(); ++b) {
      append_base(b);
      print_notes(b);
    }
    append_comparison();
    append_error();
    append_unsolved();
    return text_;
  }

 private:
  void append_base(std::size_t base) {
    const bool is_sample = study::has_sample(plan_);
    const study::Among among = is_sample ? study::Among::kSample : study::Among::kAll;
    text_ += fmt::format("\nbase {}, {} scenarios\n", plan_.study().bases[base].name, plan_.n_points(base));
    text_ += is_sample ? fmt::format("  {:<24}{:>16}{:>16}{:>16}{:>16}\n", "", "mean", "5 %", "50 %", "95 %")
                       : fmt::format("  {:<26}{:>12}  {:<{}}{:>12}  where\n", "", "lowest", "where", widest_name(base),
                                     "highest");
    const auto& quantities = plan_.values().quantities;
    const std::vector<std::string>& main = plan_.values().main;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      if (std::ranges::find(main, quantities[i].name) == main.end()) continue;
      const std::vector<double> all = rows_.values(i);
      if (is_sample) {
        append_quantiles(quantities[i], study::values_of_base(plan_, all, base, among));
      } else {
        append_extremes(quantities[i], all, base);
      }
      if (plan_.study().sampling.indices != study::Indices::kNone && quantities[i].name == main.front())
        indices_ = indices_text(study::values_of_base(plan_, all, base, study::Among::kAll), quantities[i].name, base);
      if (plan_.study().sampling.method == study::Method::kMorris && quantities[i].name == main.front())
        indices_ = screening_text(study::values_of_base(plan_, all, base, study::Among::kAll), quantities[i], base);
    }
    text_ += std::exchange(indices_, "");
    append_points(base);
  }

  /// A row for each operating point, and their weighted mean.
  void append_points(std::size_t base) {
    const std::vector<study::WeightedPoint>& points = plan_.study().sampling.points;
    if (points.empty()) return;
    text_ += fmt::format("  {:<24}{:>8}", "operating point", "weight");
    for (const std::string& name : plan_.values().main) text_ += fmt::format("{:>24}", name.substr(0, 23));
    text_ += "\n";
    for (std::size_t p = 0; p < points.size(); ++p) {
      text_ += fmt::format("  {:<24}{:>8.4g}", points[p].name, points[p].weight);
      append_main_values([&](const std::vector<double>& values) { return values[plan_.scenario(base, p)]; });
    }
    text_ += fmt::format("  {:<32}", "weighted mean");
    append_main_values([&](const std::vector<double>& values) {
      return study::weighted_mean(plan_, values, base).value_or(std::numeric_limits<double>::quiet_NaN());
    });
  }

  template <class Take>
  void append_main_values(const Take& take) {
    for (const std::string& name : plan_.values().main) {
      const std::size_t i = *plan_.values().index(name);
      text_ += fmt::format("{:>24}", shown(plan_.values().quantities[i], take(rows_.values(i))));
    }
    text_ += "\n";
  }

  /// What the results of the base note, each topic with the number of scenarios that carry it.
  void print_notes(std::size_t base) {
    const std::uint64_t n = plan_.n_points(base);
    bool is_first = true;
    for (const auto& notes : rows_.scenario_notes()) {
      const auto& [count, shown] = notes.bases[base];
      if (!shown) continue;
      if (std::exchange(is_first, false)) text_ += "  notes on the results, with the figures of one scenario\n";
      text_ += fmt::format("    {} of {}  {}: {} ({} scenario {})\n", count, n, notes.topic, shown->message,
                           shown->badness ? "worst:" : "first:", shown->scenario);
    }
  }

  void append_quantiles(const cycle::Quantity& quantity, const std::vector<double>& values) {
    const std::vector<double> sorted = study::sorted_values(values);
    if (sorted.empty()) return;
    const auto padded = [&](double x) { return fmt::format("{:>16}", shown(quantity, x)); };
    text_ += fmt::format("  {:<24}", quantity.name);
    const auto mean = study::mean_of(values);
    text_ += mean ? padded(mean->value) : fmt::format("{:>16}", "");
    for (const double share : {0.05, 0.5, 0.95}) text_ += padded(study::quantile_of(sorted, share).value);
    text_ += "\n";
  }

  /// Letters of the longest name of the first scenarios of a base.
  std::size_t widest_name(std::size_t base) const {
    constexpr std::uint64_t kSeen = 200;
    std::size_t most = 0;
    for (std::uint64_t p = 0; p < std::min(plan_.n_points(base), kSeen); ++p) {
      most = std::max(most, report::scenario_name(plan_, plan_.scenario(base, p), units_).size());
    }
    return most;
  }

  /// Where on a grid, a list or among operating points a value is lowest and highest: a median of them means nothing.
  void append_extremes(const cycle::Quantity& quantity, const std::vector<double>& all, std::size_t base) {
    const auto extremes = report::extreme_scenarios(plan_, all, base);
    if (!extremes) return;
    const auto& [lowest, highest] = *extremes;
    text_ += fmt::format("  {:<26}{:>12}  {:<{}}{:>12}  {}\n", quantity.name, shown(quantity, all[lowest]),
                         report::scenario_name(plan_, lowest, units_), widest_name(base), shown(quantity, all[highest]),
                         report::scenario_name(plan_, highest, units_));
  }

  /// Which choice or base is best, point by point against the first one.
  void append_comparison() {
    const std::vector<report::ComparisonGroup> groups = report::comparison_groups(plan_, units_);
    const bool are_pairs = groups.size() > 1 && std::all_of(groups.begin() + 1, groups.end(), [&](const auto& group) {
                             return group.pairs_with_first && group.scenarios.size() > 1;
                           });
    const bool has_weights = plan_.study().sampling.method == study::Method::kOperatingPoints;  // their mean is above
    if (!are_pairs || has_weights) return;
    const std::string& main = plan_.values().main.front();
    for (const std::string& name : {main, std::string("min_film_thickness")}) {
      const auto index = plan_.values().index(name);
      if (!index) continue;
      const std::vector<double> all = rows_.values(*index);
      text_ += fmt::format("\n{} against \"{}\", at the same values of all other factors\n", name, groups.front().name);
      for (auto group = groups.begin() + 1; group != groups.end(); ++group) append_pairs(groups.front(), *group, all);
    }
  }

  void append_sampled_pairs(const report::ComparisonGroup& first, const report::ComparisonGroup& other,
                            const std::vector<double>& all) {
    const auto picked = [&](const report::ComparisonGroup& group) {
      std::vector<double> values;
      for (const std::uint64_t i : group.scenarios) values.push_back(all[i]);
      return values;
    };
    const auto difference = study::relative_difference(picked(first), picked(other));
    if (!difference) return;
    const double half = study::mean_half_width(difference->count) * difference->standard_error;
    text_ += fmt::format("  {:<32} {:+.1f} % in the mean ({:+.1f} to {:+.1f} %, 95 % interval)\n", other.name,
                         100 * difference->value, 100 * (difference->value - half), 100 * (difference->value + half));
  }

  void append_pairs(const report::ComparisonGroup& first, const report::ComparisonGroup& other,
                    const std::vector<double>& all) {
    if (study::has_sample(plan_)) return append_sampled_pairs(first, other, all);
    double sum = 0, least = std::numeric_limits<double>::infinity(), most = -least;
    int n = 0, lower = 0;
    for (std::size_t k = 0; k < std::min(first.scenarios.size(), other.scenarios.size()); ++k) {
      const double change = all[other.scenarios[k]] / all[first.scenarios[k]] - 1;
      if (!std::isfinite(change)) continue;
      sum += change;
      least = std::min(least, change);
      most = std::max(most, change);
      lower += change < 0 ? 1 : 0;
      ++n;
    }
    if (n == 0) return;
    text_ += fmt::format("  {:<32} {:+.1f} % in the mean ({:+.1f} to {:+.1f} %), lower in {} of {}\n", other.name,
                         100 * sum / n, 100 * least, 100 * most, lower, n);
  }

  std::string indices_text(const std::vector<double>& values, const std::string& of, std::size_t base) const {
    const auto found = study::sobol_indices(values, plan_.groups().size());
    if (!found) return "";
    std::string text = fmt::format("  share in the variance of {}, with 95 % intervals\n", of);
    for (std::size_t g = 0; g < plan_.groups().size(); ++g) {
      if (!study::applies(plan_.groups()[g], plan_.study(), base)) continue;
      const auto& [first, total] = std::pair{found->first[g], found->total[g]};
      text +=
          fmt::format("    {:<36} alone {:5.2f} ({:.2f} to {:.2f})   with interactions {:5.2f} ({:.2f} to {:.2f})\n",
                      plan_.groups()[g].name, first.value, first.low, first.high, total.value, total.low, total.high);
    }
    return text;
  }

  std::string shown(const cycle::Quantity& quantity, double value) const {
    constexpr int kDigits = 4;  // values are computed to some 0.5 %
    return units_.shown(value, quantity.unit, quantity.display_unit, kDigits);
  }

  /// Factors by the size of their elementary effects, strongest first.
  std::string screening_text(const std::vector<double>& values, const cycle::Quantity& of, std::size_t base) const {
    const auto effects = study::morris_effects(plan_.trajectories(), values);
    const auto moves = [&](std::size_t j) { return study::applies(plan_.study().factors[j], base); };
    std::vector<std::size_t> order;
    for (std::size_t j = 0; j < effects.size(); ++j) {
      if (effects[j] && moves(j)) order.push_back(j);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return effects[a]->mean_absolute > effects[b]->mean_absolute;
    });
    std::string text = fmt::format(
        "  elementary effects on {} over the whole range of each factor (Morris), with 95 % intervals\n", of.name);
    for (const std::size_t j : order) {
      text += fmt::format("    {:<36} mu* {:>14} +- {:>14}   sigma {:>14}\n", plan_.study().factors[j].name,
                          shown(of, effects[j]->mean_absolute),
                          shown(of, study::mean_half_width(effects[j]->count) * effects[j]->mean_absolute_error),
                          shown(of, effects[j]->deviation));
    }
    for (std::size_t j = 0; j < effects.size(); ++j) {
      if (!effects[j] && moves(j))
        text += fmt::format("    {:<36} no effect known: too few solved\n", plan_.study().factors[j].name);
    }
    return text;
  }

  /// How accurate the values are, as far as it was estimated.
  static std::string percent(double share) {
    constexpr double kWhole = 0.1;          // from there on without digits behind the point
    if (share > 1) return "more than 100";  // such a value is not determined, however much more it is
    return share < kWhole ? fmt::format("{:.2g}", 100 * share) : fmt::format("{:.0f}", 100 * share);
  }

  void append_error() {
    if (!rows_.error) return;
    const study::SampledError& error = *rows_.error;
    const std::uint64_t n = error.scenarios.size() + error.n_unsolved;
    text_ +=
        fmt::format("\naccuracy, estimated by integrating {} of {} scenarios again on a finer grid{}\n", n,
                    plan_.size(), error.n_unsolved > 0 ? fmt::format(", {} of them not solved", error.n_unsolved) : "");
    if (const auto coverage = error.coverage()) {
      text_ += fmt::format("  {:.1f} % of their {} values are within the {:.3g} % asked for\n", 100 * *coverage,
                           error.n_values, fmt::join(error.asked, " or "));
    } else {
      text_ += "  no accuracy was asked for (solver.accuracy), so that there is no coverage\n";
    }
    if (error.scenarios.empty()) return;
    text_ += "  relative error, 95 % quantile:";
    const auto& quantities = plan_.values().quantities;
    std::optional<std::size_t> worst;
    const char* between = " ";
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      if (!error.quantiles[i]) continue;
      if (!worst || *error.quantiles[i] > *error.quantiles[*worst]) worst = i;
      if (std::ranges::find(plan_.values().main, quantities[i].name) == plan_.values().main.end()) continue;
      text_ += fmt::format("{}{} {} %", std::exchange(between, ", "), quantities[i].name, percent(*error.quantiles[i]));
    }
    if (worst) {
      text_ += fmt::format("; the largest {} {} %", quantities[*worst].name, percent(*error.quantiles[*worst]));
    }
    text_ += "\n";
  }

  void append_unsolved() {
    const std::uint64_t n_unsolved = rows_.n_unsolved();
    if (n_unsolved == 0) return;
    text_ += fmt::format("\n{} of {} scenarios were not solved; the first:\n", n_unsolved, plan_.size());
    constexpr std::uint64_t kReported = 3, kBlock = 4096;  // a block at a time: there may be a million
    std::uint64_t n_listed = 0;
    for (std::uint64_t first = 0; first < plan_.size() && n_listed < std::min(n_unsolved, kReported); first += kBlock) {
      for (const auto& one : rows_.unsolved({first, std::min(first + kBlock, plan_.size())})) {
        if (n_listed++ < kReported) text_ += fmt::format("  scenario {}: {}\n", one.scenario, one.reason);
      }
    }
  }

  const io::StudyRows& rows_;
  const study::Plan& plan_;
  io::Units units_;
  std::string text_, indices_;
};

}  // namespace

std::string study_summary(const io::StudyRows& rows) { return Summary(rows).text(); }

}  // namespace ringfilm::app
