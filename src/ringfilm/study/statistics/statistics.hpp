#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Statistics of a value over the scenarios of a sample. A value that is not finite belongs to a scenario that was not
/// solved; it is omitted and counted. Confidence intervals presume scenarios that are independent of each other.
/// Sobol points and Latin hypercubes are spread more evenly, and intervals are then wider than they need be.
namespace ringfilm::study {

inline constexpr double kConfidence = 0.95;  ///< confidence level of all intervals, where nothing else is asked for [-]

struct Mean {
  double value = 0;
  double standard_error = 0;  ///< standard error of the mean; eq-standard-error
  double deviation = 0;       ///< standard deviation of the values, n - 1 below
  std::uint64_t count = 0, omitted = 0;
};

/// Mean of the finite ones among the values, nothing if there are fewer than two.
std::optional<Mean> mean_of(std::span<const double> values);

/// Half the width of the mean's interval over its standard error: the quantile of Student's distribution.
/// @param count at least 2
double mean_half_width(std::uint64_t count, double confidence = kConfidence);

struct Quantile {
  double value = 0;  ///< median-unbiased whatever the distribution @cite hyndman1996, definition 8; eq-sample-quantile
  /// Two of the values themselves, between which the quantile lies with the confidence asked for or more
  /// @cite david2003; absent where there are too few values for an interval; eq-quantile-interval.
  std::optional<double> low, high;
};

/// Values in order, those that are not finite omitted.
std::vector<double> sorted_values(std::span<const double> values);

/// Quantile of values in order. Throws std::invalid_argument without values or for a share outside (0, 1).
/// @param share probability that the quantile is not exceeded [-]
Quantile quantile_of(std::span<const double> sorted, double share, double confidence = kConfidence);

/// Place of a quantile among n values in order, from 0 to n - 1, between two of them as a rule; eq-sample-quantile.
double quantile_place(std::size_t n, double share);

/// Places among n values in order, from 0, that enclose a quantile; nothing where there is no such place.
struct Places {
  std::optional<std::size_t> low, high;
};
Places quantile_places(std::size_t n, double share, double confidence = kConfidence);

/// Width of the confidence interval of the mean, or of a quantile where its share is given; what a study with an
/// `until` watches. Nothing while there are too few values for both ends.
std::optional<double> interval_width(std::span<const double> values, std::optional<double> quantile_share,
                                     double confidence = kConfidence);

/// Mean of the differences of a second sample to a first of the same points, relative to the mean of the first
/// [-]; eq-paired-difference. Points without a value in one of them are omitted. What both have in common cancels, so
/// that the interval is narrower than those of the two means. Nothing if there are fewer than two pairs or the first
/// mean is 0. @returns standard_error and deviation relative, too
std::optional<Mean> relative_difference(std::span<const double> first, std::span<const double> second);

/// Statistics of the first n values of a sample.
struct Stage {
  std::uint64_t n = 0;
  std::optional<Mean> mean;
  std::vector<Quantile> quantiles;  ///< quantiles of the shares asked for; empty without a value
};

/// How the statistics converge: after 16, 32, 64, ... values and after all of them.
std::vector<Stage> convergence(std::span<const double> values, const std::vector<double>& shares,
                               double confidence = kConfidence);

}  // namespace ringfilm::study
