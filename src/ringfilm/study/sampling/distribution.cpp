#include "ringfilm/study/sampling/distribution.hpp"

#include <algorithm>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <cmath>
#include <limits>

#include "ringfilm/base/number_text.hpp"

namespace ringfilm::study {
namespace {

// No long double inside: it is wider on some machines than on others. An overflow gives infinity, which is then
// reported.
using QuantileRules =
    boost::math::policies::policy<boost::math::policies::promote_double<false>,
                                  boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;
using Normal = boost::math::normal_distribution<double, QuantileRules>;
using Lognormal = boost::math::lognormal_distribution<double, QuantileRules>;
using Uniform = boost::math::uniform_distribution<double, QuantileRules>;
using Triangular = boost::math::triangular_distribution<double, QuantileRules>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Ends of the whole distribution, before it is cut off.
struct Ends {
  double low, high;
};

Ends ends(const Distribution& d) {
  switch (d.shape) {
    case Shape::kNormal:
      return {-kInfinity, kInfinity};
    case Shape::kLognormal:
      return {0, kInfinity};
    case Shape::kUniform:
    case Shape::kTriangular:
      break;
  }
  return {d.lower, d.upper};
}

/// Calls `ask` with the distribution of the library.
template <class Ask>
double asked(const Distribution& d, const Ask& ask) {
  switch (d.shape) {
    case Shape::kNormal:
      return ask(Normal(d.mean, d.deviation));
    case Shape::kLognormal:
      return ask(Lognormal(std::log(d.median), d.log_deviation));
    case Shape::kUniform:
      return ask(Uniform(d.lower, d.upper));
    case Shape::kTriangular:
      break;
  }
  return ask(Triangular(d.lower, d.mode, d.upper));
}

double whole_below(const Distribution& d, double x) {
  const Ends range = ends(d);
  if (x <= range.low) return 0;
  if (x >= range.high) return 1;
  return asked(d, [x](const auto& whole) { return boost::math::cdf(whole, x); });
}

double whole_above(const Distribution& d, double x) {
  const Ends range = ends(d);
  if (x <= range.low) return 1;
  if (x >= range.high) return 0;
  return asked(d, [x](const auto& whole) { return boost::math::cdf(boost::math::complement(whole, x)); });
}

/// What the truncation leaves, counted from below where the lower end is in the lower half and from above otherwise: so
/// that no digits are lost in either tail.
struct Kept {
  bool from_below;
  double first, last;  ///< probabilities at the lower and at the upper end
  double share() const { return from_below ? last - first : first - last; }
};

Kept kept(const Distribution& d) {
  const double low = d.lowest.value_or(-kInfinity), high = d.highest.value_or(kInfinity);
  const double below = whole_below(d, low);
  if (below <= 0.5) return {true, below, whole_below(d, high)};
  return {false, whole_above(d, low), whole_above(d, high)};
}

bool is_finite(const Distribution& d) {
  for (const double x : {d.mean, d.deviation, d.median, d.log_deviation, d.lower, d.mode, d.upper, d.lowest.value_or(0),
                         d.highest.value_or(0)}) {
    if (!std::isfinite(x)) return false;
  }
  return true;
}

std::vector<Complaint> complaints_of_shape(const Distribution& d) {
  std::vector<Complaint> found;
  const auto positive = [&found](const char* what, double deviation) {
    if (deviation > 0) return;
    found.push_back({std::string("has the ") + what + " " + number_text(deviation),
                     "it must be above 0; what does not vary is not a factor"});
  };
  switch (d.shape) {
    case Shape::kNormal:
      positive("standard deviation", d.deviation);
      break;
    case Shape::kLognormal:
      positive("standard deviation of the logarithm", d.log_deviation);
      if (d.median <= 0) {
        found.push_back({"has the median " + number_text(d.median), "that of a lognormal distribution is above 0"});
      }
      break;
    case Shape::kTriangular:
      if (d.mode < d.lower || d.mode > d.upper) {
        found.push_back(
            {"has its mode " + number_text(d.mode) + " outside " + number_text(d.lower) + " to " + number_text(d.upper),
             "lower <= mode <= upper is required"});
      }
      [[fallthrough]];
    case Shape::kUniform:
      if (d.lower >= d.upper) {
        found.push_back(
            {"has its lower end " + number_text(d.lower) + " not below its upper end " + number_text(d.upper),
             "exchange them, or omit what does not vary"});
      }
      break;
  }
  return found;
}

}  // namespace

Distribution normal(double mean, double deviation) {
  Distribution d;
  d.mean = mean;
  d.deviation = deviation;
  return d;
}

Distribution lognormal(double median, double log_deviation) {
  Distribution d;
  d.shape = Shape::kLognormal;
  d.median = median;
  d.log_deviation = log_deviation;
  return d;
}

Distribution lognormal_of_moments(double mean, double deviation) {
  const double relative = deviation / mean, variance = std::log1p(relative * relative);
  // A negative deviation stays visible, to be complained of.
  return lognormal(mean / std::sqrt(1 + relative * relative), std::copysign(std::sqrt(variance), relative));
}

Distribution uniform(double lower, double upper) {
  Distribution d;
  d.shape = Shape::kUniform;
  d.lower = lower;
  d.upper = upper;
  return d;
}

Distribution triangular(double lower, double mode, double upper) {
  Distribution d = uniform(lower, upper);
  d.shape = Shape::kTriangular;
  d.mode = mode;
  return d;
}

std::vector<Complaint> complaints(const Distribution& d) {
  if (!is_finite(d)) return {{"has a number that is not finite", "state finite numbers"}};
  std::vector<Complaint> found = complaints_of_shape(d);
  if (!found.empty()) return found;
  if (d.lowest && d.highest && *d.lowest >= *d.highest) {
    return {{"is truncated to " + number_text(*d.lowest) + " to " + number_text(*d.highest),
             "the first must be below the second"}};
  }
  constexpr double kMin = 1e-9;
  if (kept(d).share() < kMin) {
    return {{"has no support: its truncation leaves less than one part in 10^9",
             "check the bounds of `truncate` against the values that the distribution has"}};
  }
  if (!std::isfinite(quantile(d, 0x1.0p-53)) || !std::isfinite(quantile(d, 1 - 0x1.0p-53))) {
    return {{"exceeds the range of numbers", "state a smaller deviation"}};
  }
  return {};
}

double quantile(const Distribution& d, double share) {
  const Kept part = kept(d);
  const double p = part.first + share * (part.last - part.first);
  const double x = asked(d, [&](const auto& whole) {
    return part.from_below ? boost::math::quantile(whole, p) : boost::math::quantile(boost::math::complement(whole, p));
  });
  return std::clamp(x, d.lowest.value_or(-kInfinity), d.highest.value_or(kInfinity));
}

double density(const Distribution& d, double x) {
  const Ends range = ends(d);
  if (x < std::max(range.low, d.lowest.value_or(range.low)) || x > std::min(range.high, d.highest.value_or(range.high)))
    return 0;
  return asked(d, [x](const auto& whole) { return boost::math::pdf(whole, x); }) / kept(d).share();
}

double probability(const Distribution& d, double x) {
  const Kept part = kept(d);
  const double at = part.from_below ? whole_below(d, x) : whole_above(d, x);
  return std::clamp((at - part.first) / (part.last - part.first), 0.0, 1.0);
}

Moments moments(const Distribution& d) {
  // Over the normal score z of the share everything is smooth and dies out: equal steps converge faster than any power.
  constexpr double kEnd = 8, kStep = 1.0 / 256;
  double weight = 0, first = 0;
  std::vector<double> x, w;
  for (double z = -kEnd; z <= kEnd; z += kStep) {
    x.push_back(quantile(d, normal_probability(z)));
    w.push_back(std::exp(-z * z / 2));
    weight += w.back();
    first += w.back() * x.back();
  }
  const double mean = first / weight;
  double second = 0;
  for (std::size_t i = 0; i < x.size(); ++i) second += w[i] * (x[i] - mean) * (x[i] - mean);
  return {mean, std::sqrt(second / weight)};
}

double normal_quantile(double share) { return boost::math::quantile(Normal(), share); }

double normal_probability(double z) { return boost::math::cdf(Normal(), z); }

}  // namespace ringfilm::study
