#pragma once
#include <cstdint>
#include <string>
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

/// In the order in which the plan comes to them; of a sample its points alone. Where nothing but numbers varies in few
/// scenarios that are not a sample, each of these is a group. Empty where there is nothing to compare, or more than a
/// picture holds.
std::vector<ComparisonGroup> comparison_groups(const study::Plan& plan, const io::Units& units);

}  // namespace ringfilm::report
