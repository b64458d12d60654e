#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

/// Studies that continue until an interval is narrow enough; docs/theory/study.md.
namespace ringfilm::study {

/// The numbers of points at which such a study looks whether it may stop: plan.scenarios, twice, four times as many and
/// so on, at last `most`. So Sobol points stay even, and the end depends on the study alone.
/// @returns how many points come after `points`; nothing after the last
std::optional<std::uint64_t> next_look(const StoppingRule& until, std::uint64_t points);

/// Is this one of them, counted from the study's plan.scenarios on?
bool is_look(const Study& study, std::uint64_t points);

/// Width of the confidence interval of a statistic for one base.
struct IntervalWidth {
  std::size_t base = 0;
  /// Width of the confidence interval [unit of the value]; nothing while there are too few.
  std::optional<double> width;
};

/// @param value of a scenario by its number; NaN where it was not solved
std::vector<IntervalWidth> interval_widths(const Plan& plan, const std::vector<double>& values);

/// Is the interval narrow enough for every base?
bool is_sure(const StoppingRule& until, const std::vector<IntervalWidth>& bases);

/// Study with another number of points.
Study with_points(Study study, std::uint64_t points);

/// "the mean of fmep", "the 95 % quantile of fmep"
std::string statistic_words(const StoppingRule& until);

}  // namespace ringfilm::study
