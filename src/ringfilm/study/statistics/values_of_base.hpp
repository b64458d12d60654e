#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

/// The values of one base among those of all.
namespace ringfilm::study {

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
