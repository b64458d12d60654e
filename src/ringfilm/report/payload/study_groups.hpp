#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/design/plan.hpp"

namespace ringfilm::report {

/// Scenarios that are compared with others: those of one base with one choice of each factor that is a
/// choice.
struct ComparisonGroup {
  std::string name;
  std::size_t base = 0;
  std::vector<std::uint64_t> scenarios;
  /// Do its scenarios have, one by one, the same numbers of all other factors as those of the first group?
  bool pairs_with_first = false;
};

/// What a scenario is within its base: the name of its operating point, or its factors with their numbers; of one at a
/// time the factor that moves; its number where these are too many to read.
std::string scenario_name(const study::Plan& plan, std::uint64_t scenario, const io::Units& units);

/// Scenarios of a base with the lowest and the highest of these values; nothing where none was solved.
/// @param all a value of each scenario, NaN where it was not solved
std::optional<std::pair<std::uint64_t, std::uint64_t>> extreme_scenarios(const study::Plan& plan,
                                                                         const std::vector<double>& all,
                                                                         std::size_t base);

/// In the order in which the plan comes to them; of a sample its points alone. Where nothing but numbers varies in few
/// scenarios that are not a sample, each of these is a group. Empty where there is nothing to compare, or more than a
/// picture holds.
std::vector<ComparisonGroup> comparison_groups(const study::Plan& plan, const io::Units& units);

}  // namespace ringfilm::report
