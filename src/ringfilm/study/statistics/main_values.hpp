#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

/// Which values of a cycle are reported of every study, and those of one base among all.
namespace ringfilm::study {

/// Names of cycle values, those that matter most first; the others are in the files of a study.
const std::vector<std::string>& main_values();

enum class Among {
  kAll,    ///< every point of a base
  kSample  ///< those from which means and quantiles may be taken
};

/// Values of the points of one base, in their order. @param all one value for each scenario of the plan. Throws
/// std::out_of_range if there are fewer.
std::vector<double> values_of_base(const Plan& plan, std::span<const double> all, std::size_t base, Among among);

/// Is the plan, or the part of it that statistics are taken from, a sample of the factors?
bool has_sample(const Plan& plan);

}  // namespace ringfilm::study
