#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ringfilm::study {

/// An estimate with its confidence interval.
struct Interval {
  double value = 0, low = 0, high = 0;
};

/// Which part of the variance of a value comes from which group of factors @cite sobol2001.
struct SobolIndices {
  std::vector<Interval> first;  ///< by the group alone [-]; eq-first-index
  std::vector<Interval> total;  ///< by it and all its interactions [-]; eq-total-index
  double mean = 0, variance = 0;
  std::uint64_t rows = 0, omitted = 0;  ///< complete rows, and those with a value that is not finite
};

struct IndexOptions {
  double confidence = 0.95;        ///< confidence level of the intervals [-]
  std::uint64_t resamples = 1000;  ///< number of resamples of the bootstrap
  std::uint64_t seed = 1;          ///< seed of the bootstrap
};

/// First index by the estimator of @cite saltelli2010 on centred values, total index by that of @cite jansen1999, with
/// percentile intervals of a bootstrap over the rows @cite archer1997; eq-first-estimator, eq-total-estimator,
/// eq-bootstrap. Rows of many are put together to 4096 first, which the bootstrap does not feel.
/// @param values of a plan with indices in the order of its points: row by row, of each f(A), f(B) and, for each group,
/// f(A with that group from B). A last row that is not complete is not used
/// @returns nothing if there are fewer than 8 rows or the value does not vary
std::optional<SobolIndices> sobol_indices(std::span<const double> values, std::size_t n_groups,
                                          const IndexOptions& options = {});

}  // namespace ringfilm::study
