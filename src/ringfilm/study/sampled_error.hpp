#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/ensemble/batch.hpp"

/// The numerical error of the values of a study, estimated on a sample of its scenarios (docs/theory/error-estimate.md,
/// "sample of a study").
namespace ringfilm::study {

/// Share of the sampled scenarios whose relative error a quantile is not exceeded by [-].
inline constexpr double kErrorShare = 0.95;

struct SampledError {
  std::vector<std::uint64_t> scenarios;  ///< scenarios that were compared, in the order of the plan
  std::uint64_t n_unsolved = 0;  ///< scenarios of the sample that were not solved themselves or on the finer grid
  /// 95 % quantile over the sample of the relative error of each value of the plan, eq-sampled-error [-]; nothing of
  /// crank angles and of values that the finer grid does not change in any scenario, such as inputs.
  std::vector<std::optional<double>> quantiles;
  std::vector<double> asked;   ///< solver.accuracy of the scenarios that were compared, each once, increasing [%]
  std::uint64_t n_values = 0;  ///< values with an error in the scenarios for which an accuracy is asked
  std::uint64_t n_within = 0;  ///< those of them within it

  /// Share of the values within the accuracy asked for [-]; nothing where none is.
  std::optional<double> coverage() const;
};

/// How many scenarios of the plan are integrated again.
std::uint64_t sample_size(const Plan& plan);

/// Which: one of each of as many equal parts of the plan, drawn with its seed; increasing.
std::vector<std::uint64_t> sampled_scenarios(const Plan& plan);

/// Integrates the sampled scenarios again on finer_grid. The number of threads changes no bit of it.
/// @param own values of a scenario of the plan as they were computed, in the order of Plan::values()
/// @returns nothing where the sample is empty
std::optional<SampledError> sampled_error(const Plan& plan,
                                          const std::function<std::vector<double>(std::uint64_t scenario)>& own,
                                          const Progress& progress = {}, const BatchOptions& options = {});

/// Error of the sample from the values on both grids. @param own, finer values of `scenarios`, NaN where not solved
/// @param asked accuracy of each scenario [%]
SampledError compared(const StudyValues& values, const std::vector<std::uint64_t>& scenarios,
                      const std::vector<std::vector<double>>& own, const std::vector<std::vector<double>>& finer,
                      const std::vector<std::optional<double>>& asked);

}  // namespace ringfilm::study
