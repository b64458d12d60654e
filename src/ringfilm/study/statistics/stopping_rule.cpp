#include "ringfilm/study/statistics/stopping_rule.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/study/statistics/statistics.hpp"
#include "ringfilm/study/statistics/values_of_base.hpp"

namespace ringfilm::study {

std::optional<std::uint64_t> next_look(const StoppingRule& until, std::uint64_t points) {
  if (points >= until.most) return std::nullopt;
  return points > until.most / 2 ? until.most : 2 * points;
}

bool is_look(const Study& study, std::uint64_t points) {
  std::optional<std::uint64_t> look = study.sampling.scenarios;
  while (look && *look < points) look = next_look(study.sampling.until.value(), *look);
  return look == points;
}

std::vector<IntervalWidth> interval_widths(const Plan& plan, const std::vector<double>& values) {
  const StoppingRule& until = plan.study().sampling.until.value();
  std::vector<IntervalWidth> all;
  for (std::size_t base = 0; base < plan.study().bases.size(); ++base) {
    const std::vector<double> sample = values_of_base(plan, values, base, Among::kSample);
    all.push_back({base, interval_width(sample, until.quantile)});
  }
  return all;
}

bool is_sure(const StoppingRule& until, const std::vector<IntervalWidth>& bases) {
  return std::all_of(bases.begin(), bases.end(),
                     [&](const IntervalWidth& one) { return one.width && *one.width <= until.width; });
}

Study with_points(Study study, std::uint64_t points) {
  study.sampling.scenarios = points;
  return study;
}

std::string statistic_words(const StoppingRule& until) {
  constexpr double kPercent = 100;
  if (!until.quantile) return "the mean of " + until.value;
  return "the " + number_text(kPercent * *until.quantile) + " % quantile of " + until.value;
}

}  // namespace ringfilm::study
