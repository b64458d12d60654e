#include "ringfilm/study/sampling/distribution.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace ringfilm::study {
namespace {

Distribution truncated(Distribution d, std::optional<double> lowest, std::optional<double> highest) {
  d.lowest = lowest;
  d.highest = highest;
  return d;
}

/// Densities as textbooks have them, not yet divided by what a truncation leaves.
double formula(const Distribution& d, double x) {
  switch (d.shape) {
    case Shape::kNormal: {
      const double z = (x - d.mean) / d.deviation;
      return std::exp(-z * z / 2) / (d.deviation * std::sqrt(2 * std::numbers::pi));
    }
    case Shape::kLognormal: {
      const double z = std::log(x / d.median) / d.log_deviation;
      return std::exp(-z * z / 2) / (x * d.log_deviation * std::sqrt(2 * std::numbers::pi));
    }
    case Shape::kUniform:
      return 1 / (d.upper - d.lower);
    case Shape::kTriangular:
      break;
  }
  const double height = 2 / (d.upper - d.lower);
  return x < d.mode ? height * (x - d.lower) / (d.mode - d.lower) : height * (d.upper - x) / (d.upper - d.mode);
}

/// Integral of g times the formula; in parts, so that corners lie at their ends.
template <class G>
double integral(const Distribution& d, double from, double to, const G& g) {
  const double corner = d.shape == Shape::kTriangular ? std::clamp(d.mode, from, to) : (from + to) / 2;
  double sum = 0;
  for (const auto& [a, b] : {std::pair(from, corner), std::pair(corner, to)}) {
    constexpr int kParts = 40;
    for (int i = 0; i < kParts; ++i) {
      const double left = a + (b - a) * i / kParts, right = a + (b - a) * (i + 1) / kParts;
      if (right > left)
        sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
            [&](double x) { return g(x) * formula(d, x); }, left, right, 0);
    }
  }
  return sum;
}

/// With ends beyond which nothing is left that quadrature could see.
struct Example {
  const char* name;
  Distribution d;
  double from, to;
};

std::vector<Example> examples() {
  return {
      {"normal", normal(3, 0.5), 3 - 12 * 0.5, 3 + 12 * 0.5},
      {"lognormal", lognormal(2, 0.4), 2 * std::exp(-12 * 0.4), 2 * std::exp(12 * 0.4)},
      {"uniform", uniform(-1, 4), -1, 4},
      {"triangular", triangular(-1, 0.5, 4), -1, 4},
      {"right-angled", triangular(2, 2, 5), 2, 5},
      {"normal above 0", truncated(normal(1, 0.8), 0, {}), 0, 1 + 12 * 0.8},
      {"normal between", truncated(normal(1, 0.8), 0.5, 1.1), 0.5, 1.1},
      {"upper tail", truncated(normal(0, 1), 4, 5), 4, 5},
      {"lower tail", truncated(normal(0, 1), -5, -4), -5, -4},
      {"lognormal below", truncated(lognormal(2, 0.4), {}, 3), 2 * std::exp(-12 * 0.4), 3},
      {"part of a uniform", truncated(uniform(-1, 4), 0, 2), 0, 2},
      {"wider than a uniform", truncated(uniform(-1, 4), -7, 9), -1, 4},
      {"part of a triangle", truncated(triangular(-1, 0.5, 4), 0, 3), 0, 3},
  };
}

TEST(Distribution, QuantilesHoldTheirShareOfTheDensity) {
  for (const auto& [name, d, from, to] : examples()) {
    const double whole = integral(d, from, to, [](double) { return 1.0; });
    for (const double share : {1e-6, 0.05, 0.3, 0.5, 0.77, 0.95, 0.999}) {
      const double x = quantile(d, share);
      // Rounding of x alone moves the share by some 1e-16 times x over the width.
      EXPECT_NEAR(integral(d, from, x, [](double) { return 1.0; }) / whole, share, 1e-11) << name;
      EXPECT_NEAR(probability(d, x), share, 1e-11) << name;
      EXPECT_NEAR(density(d, x), formula(d, x) / whole, 1e-11 * formula(d, x) / whole) << name;
    }
  }
}

TEST(Distribution, QuantilesRiseAndStayInside) {
  for (const auto& [name, d, from, to] : examples()) {
    double before = -std::numeric_limits<double>::infinity();
    for (const double share : {0x1.0p-53, 1e-9, 0.1, 0.4, 0.5, 0.6, 0.9, 1 - 1e-9, 1 - 0x1.0p-53}) {
      const double x = quantile(d, share);
      EXPECT_GT(x, before) << name << " " << share;
      EXPECT_GE(x, d.lowest.value_or(from)) << name;
      EXPECT_LE(x, d.highest.value_or(to)) << name;
      before = x;
    }
    if (d.lowest || d.shape != Shape::kNormal) {
      EXPECT_EQ(density(d, std::min(from, 0.0) - 8), 0) << name;
    }
    EXPECT_NEAR(probability(d, from - 1e-3), 0, 1e-12) << name;
    EXPECT_NEAR(probability(d, to + 1e-3), 1, 1e-12) << name;
  }
}

TEST(Distribution, QuantilesAreThoseOfTheLibraryInLongNumbers) {
  const boost::math::normal_distribution<long double> wide_normal(3, 0.5L);
  const boost::math::lognormal_distribution<long double> wide_lognormal(std::log(2.0L), 0.4L);
  for (const double share : {1e-12, 0.01, 0.4, 0.9, 0.9999}) {
    EXPECT_NEAR(quantile(normal(3, 0.5), share), static_cast<double>(boost::math::quantile(wide_normal, share)), 1e-14);
    const auto wide = static_cast<double>(boost::math::quantile(wide_lognormal, share));
    EXPECT_NEAR(quantile(lognormal(2, 0.4), share), wide, 1e-14 * wide);
    EXPECT_NEAR(normal_probability(normal_quantile(share)), share, 1e-15);
  }
}

TEST(Distribution, MomentsAreThoseOfTheDensity) {
  for (const auto& [name, d, from, to] : examples()) {
    const double whole = integral(d, from, to, [](double) { return 1.0; });
    const double mean = integral(d, from, to, [](double x) { return x; }) / whole;
    const double variance = integral(d, from, to, [&](double x) { return (x - mean) * (x - mean); }) / whole;
    const Moments m = moments(d);
    EXPECT_NEAR(m.mean, mean, 1e-6 * std::sqrt(variance)) << name;
    EXPECT_NEAR(m.deviation, std::sqrt(variance), 1e-6 * std::sqrt(variance)) << name;
  }
}

TEST(Distribution, MomentsOfClosedForm) {
  const Moments n = moments(normal(3, 0.5));
  EXPECT_NEAR(n.mean, 3, 1e-12);
  EXPECT_NEAR(n.deviation, 0.5, 1e-9);
  const Moments u = moments(uniform(1, 4));
  EXPECT_NEAR(u.deviation, 3 / std::sqrt(12.0), 1e-9);
  // Half of a normal: mean sqrt(2/pi), variance 1 - 2/pi.
  const Moments half = moments(truncated(normal(0, 1), 0, {}));
  EXPECT_NEAR(half.mean, std::sqrt(2 / std::numbers::pi), 1e-7);
  EXPECT_NEAR(half.deviation, std::sqrt(1 - 2 / std::numbers::pi), 1e-7);
}

TEST(Distribution, LognormalHasTheMomentsAskedFor) {
  const Moments m = moments(lognormal_of_moments(0.097, 0.02));
  EXPECT_NEAR(m.mean, 0.097, 1e-9);
  EXPECT_NEAR(m.deviation, 0.02, 1e-9);
}

TEST(Distribution, TailsKeepTheirDigits) {
  // Beyond 8 deviations the probability below rounds to 1, and counting from there would leave nothing.
  const Distribution far = truncated(normal(0, 1), 5.5, {});
  const double x = quantile(far, 0.5);
  const boost::math::normal_distribution<long double> wide;
  const long double half = boost::math::cdf(complement(wide, 5.5L)) / 2;
  EXPECT_NEAR(x, static_cast<double>(boost::math::quantile(complement(wide, half))), 1e-12);
}

TEST(Distribution, ReportsWhyItCannotBeDrawnFrom) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto first = [](const Distribution& d) { return complaints(d).empty() ? "" : complaints(d)[0].predicate; };
  EXPECT_EQ(first(normal(1, -0.1)), "has the standard deviation -0.1");
  EXPECT_EQ(first(normal(1, 0)), "has the standard deviation 0");
  EXPECT_EQ(first(normal(nan, 1)), "has a number that is not finite");
  EXPECT_EQ(first(lognormal(1, -1)), "has the standard deviation of the logarithm -1");
  EXPECT_EQ(first(lognormal(-2, 1)), "has the median -2");
  EXPECT_EQ(first(lognormal_of_moments(2, -1)).substr(0, 43), "has the standard deviation of the logarithm");
  EXPECT_EQ(first(uniform(2, 2)), "has its lower end 2 not below its upper end 2");
  EXPECT_EQ(first(triangular(0, 3, 2)), "has its mode 3 outside 0 to 2");
  EXPECT_EQ(first(truncated(normal(0, 1), 2, 1)), "is truncated to 2 to 1");
  const std::string nothing = "has no support: its truncation leaves less than one part in 10^9";
  EXPECT_EQ(first(truncated(normal(0, 1), 7, {})), nothing);
  EXPECT_EQ(first(truncated(uniform(0, 1), 2, 3)), nothing);
  EXPECT_EQ(first(truncated(lognormal(1, 1), {}, -1)), nothing);
  EXPECT_EQ(first(truncated(triangular(0, 1, 2), {}, 0)), nothing);
  EXPECT_EQ(first(lognormal(1, 200)), "exceeds the range of numbers");
  for (const Example& good : examples()) EXPECT_EQ(first(good.d), "") << good.name;
}

}  // namespace
}  // namespace ringfilm::study
