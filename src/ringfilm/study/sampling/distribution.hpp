#pragma once
#include <optional>
#include <string>
#include <vector>

/// Distributions of one uncertain number, in SI; docs/theory/study.md.
namespace ringfilm::study {

enum class Shape { kNormal, kLognormal, kUniform, kTriangular };

/// How likely each value of a number is. Only the members of its shape count; `unit` is the unit of the number.
/// Made by `normal`, `lognormal`, ... below, or member by member.
struct Distribution {
  Shape shape = Shape::kNormal;
  double mean = 0;           ///< mean of a normal distribution [unit]
  double deviation = 0;      ///< standard deviation of a normal distribution [unit]
  double median = 0;         ///< median of a lognormal distribution, above 0 [unit]
  double log_deviation = 0;  ///< standard deviation of its natural logarithm [-]
  double lower = 0;          ///< lower end of a uniform or triangular distribution [unit]
  double mode = 0;           ///< mode of a triangular distribution, within lower to upper [unit]
  double upper = 0;          ///< upper end of a uniform or triangular distribution [unit]
  /// Where the distribution is cut off: what is outside never happens, what is inside keeps its proportions;
  /// eq-truncated.
  std::optional<double> lowest, highest;  ///< [unit]
};

Distribution normal(double mean, double deviation);
Distribution lognormal(double median, double log_deviation);
/// The lognormal that has this mean and standard deviation; eq-lognormal-moments. @param mean above 0
Distribution lognormal_of_moments(double mean, double deviation);
Distribution uniform(double lower, double upper);
Distribution triangular(double lower, double mode, double upper);

/// What is wrong with a distribution: a predicate such as "has the standard deviation -1", and what to do.
struct Complaint {
  std::string predicate, remedy;
};

/// Empty if the distribution can be drawn from: finite numbers, a positive deviation, bounds in order, and at least one
/// part in 10^9 of it left by the truncation.
std::vector<Complaint> complaints(const Distribution& d);

// All below presume that there are no complaints.

/// The value that is not exceeded with the probability `share`, which lies in (0, 1); rises with it. eq-quantile
double quantile(const Distribution& d, double share);
/// Probability per unit at x [1/unit]; 0 outside the support.
double density(const Distribution& d, double x);
/// Probability that x is not exceeded [-].
double probability(const Distribution& d, double x);
/// Mean and standard deviation with the truncation [unit], to 1e-6 of the deviation; eq-distribution-moments.
struct Moments {
  double mean, deviation;
};
Moments moments(const Distribution& d);

/// Quantile of the standard normal distribution; `share` in (0, 1).
double normal_quantile(double share);
/// Probability that a standard normal number does not exceed z.
double normal_probability(double z);

}  // namespace ringfilm::study
