#include "ringfilm/study/statistics/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ringfilm/study/sampling/distribution.hpp"
#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::study {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

/// Probability that exactly k of n are below, by its recurrence; independent of the library's incomplete beta.
std::vector<double> binomial(std::size_t n, double share) {
  std::vector<double> p(n + 1);
  const auto all = static_cast<double>(n);
  for (std::size_t k = 0; k <= n; ++k) {
    p[k] = std::exp(std::lgamma(all + 1) - std::lgamma(static_cast<double>(k) + 1) -
                    std::lgamma(static_cast<double>(n - k) + 1.0) + static_cast<double>(k) * std::log(share) +
                    static_cast<double>(n - k) * std::log1p(-share));
  }
  return p;
}

TEST(Statistics, MeanAndItsStandardError) {
  const std::vector<double> values = {1, 2, kNan, 3, 4, std::numeric_limits<double>::infinity()};
  const auto mean = mean_of(values);
  ASSERT_TRUE(mean);
  EXPECT_DOUBLE_EQ(mean->value, 2.5);
  EXPECT_DOUBLE_EQ(mean->deviation, std::sqrt(5.0 / 3));
  EXPECT_DOUBLE_EQ(mean->standard_error, std::sqrt(5.0 / 12));
  EXPECT_EQ(mean->count, 4u);
  EXPECT_EQ(mean->omitted, 2u);
  EXPECT_FALSE(mean_of(std::vector<double>{1, kNan}));
}

TEST(Statistics, SmallScatterAboutALargeMeanIsKept) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(1e9 + (i % 2 == 0 ? 0.5 : -0.5));
  const auto mean = mean_of(values);
  EXPECT_NEAR(mean->value, 1e9, 1e-6);
  EXPECT_NEAR(mean->deviation, 0.5 * std::sqrt(1000.0 / 999), 1e-6);
}

TEST(Statistics, StudentWidensTheIntervalOfFew) {
  // Tables: t of 0.975 is 12.706 with one degree of freedom, 2.262 with nine, 1.960 with very many.
  EXPECT_NEAR(mean_half_width(2), 12.706, 5e-4);
  EXPECT_NEAR(mean_half_width(10), 2.262, 5e-4);
  EXPECT_NEAR(mean_half_width(1000000), 1.960, 5e-4);
}

TEST(Statistics, QuantileFollowsDefinition8) {
  // Of 1 ... n the place is share (n + 1/3) + 1/3, from 1.
  std::vector<double> values;
  for (int i = 1; i <= 11; ++i) values.push_back(i);
  EXPECT_DOUBLE_EQ(quantile_of(values, 0.5).value, 6);
  EXPECT_NEAR(quantile_of(values, 0.25).value, 0.25 * (11 + 1.0 / 3) + 1.0 / 3, 1e-12);
  EXPECT_DOUBLE_EQ(quantile_of(values, 0.001).value, 1);
  EXPECT_DOUBLE_EQ(quantile_of(values, 0.999).value, 11);
  EXPECT_THROW(quantile_of(std::vector<double>{}, 0.5), std::invalid_argument);
  EXPECT_THROW(quantile_of(values, 1.0), std::invalid_argument);
  EXPECT_THROW(quantile_of(values, kNan), std::invalid_argument);
}

TEST(Statistics, PlacesOfAMedianAreThoseOfTables) {
  // The classic interval of the median of 100: values 40 and 61 in order.
  const Places median = quantile_places(100, 0.5);
  EXPECT_EQ(median.low, 39u);
  EXPECT_EQ(median.high, 60u);
  EXPECT_FALSE(quantile_places(5, 0.5).low) << "2 in 2^5 is more than 5 %";
  EXPECT_EQ(quantile_places(6, 0.5).low, 0u) << "2 in 2^6 is less";
  EXPECT_EQ(quantile_places(6, 0.5).high, 5u);
  // 0.95^n falls below 0.025 at n = 72.
  EXPECT_FALSE(quantile_places(71, 0.95).high);
  EXPECT_EQ(quantile_places(72, 0.95).high, 71u);
}

TEST(Statistics, PlacesAreTheNarrowestThatHoldTheConfidence) {
  for (const std::size_t n : {1u, 2u, 10u, 37u, 100u, 1000u}) {
    for (const double share : {0.01, 0.05, 0.5, 0.8, 0.95}) {
      for (const double confidence : {0.9, 0.95, 0.999}) {
        const std::vector<double> p = binomial(n, share);
        const double tail = (1 - confidence) / 2;
        // The value at place l is above the quantile if at most l are below it.
        std::vector<double> cumulative;
        double sum = 0;
        for (const double one : p) cumulative.push_back(sum += one);
        std::optional<std::size_t> low, high;
        for (std::size_t l = 0; l < n; ++l) {
          if (cumulative[l] <= tail) low = l;
          if (!high && 1 - cumulative[l] <= tail) high = l;
        }
        const Places places = quantile_places(n, share, confidence);
        EXPECT_EQ(places.low, low) << n << " " << share << " " << confidence;
        EXPECT_EQ(places.high, high) << n << " " << share << " " << confidence;
      }
    }
  }
}

TEST(Statistics, IntervalsOfQuantilesCoverAsOftenAsStated) {
  constexpr int kSamples = 4000;
  constexpr std::size_t kValues = 150;
  for (const double share : {0.05, 0.5, 0.95}) {
    const Distribution d = lognormal(2, 0.7);
    const double exact = quantile(d, share);
    int covered = 0, unbiased = 0;
    for (int s = 0; s < kSamples; ++s) {
      std::vector<double> values;
      for (std::size_t i = 0; i < kValues; ++i) values.push_back(quantile(d, share_of(hash(11, s, i))));
      const Quantile found = quantile_of(sorted_values(values), share);
      ASSERT_TRUE(found.low && found.high);
      covered += *found.low <= exact && exact <= *found.high;
      unbiased += found.value > exact;
      EXPECT_LE(*found.low, found.value);
      EXPECT_GE(*found.high, found.value);
    }
    const Places places = quantile_places(kValues, share);
    const std::vector<double> p = binomial(kValues, share);
    double expected = 0;
    for (std::size_t k = *places.low + 1; k <= *places.high; ++k) expected += p[k];
    EXPECT_GE(expected, 0.95);
    // Four standard deviations of a count of 4000.
    EXPECT_NEAR(covered, kSamples * expected, 4 * std::sqrt(kSamples * expected * (1 - expected))) << share;
    EXPECT_NEAR(unbiased, kSamples / 2, 4 * std::sqrt(kSamples / 4.0) + 0.02 * kSamples)
        << "median-unbiased to the 2 % that definition 8 leaves at " << share;
  }
}

TEST(Statistics, IntervalsOfMeansCoverAsOftenAsStated) {
  constexpr int kSamples = 4000;
  int covered = 0;
  for (int s = 0; s < kSamples; ++s) {
    std::vector<double> values;
    for (int i = 0; i < 12; ++i) values.push_back(3 + 0.5 * normal_quantile(share_of(hash(12, s, i))));
    const auto mean = mean_of(values);
    covered += std::abs(mean->value - 3) <= mean_half_width(mean->count) * mean->standard_error;
  }
  // Exact for normal values: 95 % give or take four standard deviations.
  EXPECT_NEAR(covered, 0.95 * kSamples, 4 * std::sqrt(kSamples * 0.95 * 0.05));
}

TEST(Statistics, WidthOfAnIntervalIsThatBetweenItsEnds) {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  EXPECT_EQ(interval_width(values, 0.5), 61 - 40) << "values 40 and 61 in order, as tables have it";
  EXPECT_FALSE(interval_width(std::span(values).first(50), 0.95)) << "no upper end below 72 values";
  EXPECT_FALSE(interval_width({}, 0.5));
  // Of 1 ... 100 the variance is 100 101 / 12; t of 0.975 with 99 degrees of freedom is 1.9842.
  EXPECT_NEAR(*interval_width(values, std::nullopt), 2 * 1.9842 * std::sqrt(101.0 / 12), 1e-3);
  EXPECT_FALSE(interval_width(std::span(values).first(1), std::nullopt));
}

TEST(Statistics, ConvergenceIsTheStatisticsOfEachBeginning) {
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) values.push_back(normal_quantile(share_of(hash(13, i))));
  values[3] = kNan;
  const auto stages = convergence(values, {0.05, 0.5});
  ASSERT_EQ(stages.size(), 4u);
  const std::vector<std::uint64_t> counts = {16, 32, 64, 100};
  for (std::size_t s = 0; s < stages.size(); ++s) {
    EXPECT_EQ(stages[s].n, counts[s]);
    const auto begin = std::span(values).first(counts[s]);
    EXPECT_EQ(stages[s].mean->value, mean_of(begin)->value);
    EXPECT_EQ(stages[s].mean->omitted, 1u);
    EXPECT_EQ(stages[s].quantiles.at(1).value, quantile_of(sorted_values(begin), 0.5).value);
  }
  EXPECT_FALSE(stages[0].quantiles[0].low) << "16 values state nothing of what is below their 5 % quantile";
  ASSERT_EQ(convergence({}, {0.5}).size(), 1u);
  EXPECT_FALSE(convergence({}, {0.5})[0].mean);
  EXPECT_TRUE(convergence({}, {0.5})[0].quantiles.empty());
}

TEST(Statistics, DifferencesOfTheSamePointsHaveNarrowerIntervalsThanTheirLevels) {
  std::vector<double> first, second;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const double common = 10 + 5 * normal_quantile(share_of(hash(1, i)));
    first.push_back(common);
    second.push_back(0.9 * common);
  }
  first[3] = kNan;
  const auto mean = mean_of(first);
  const auto difference = relative_difference(first, second);
  ASSERT_TRUE(mean && difference);
  EXPECT_NEAR(difference->value, -0.1, 1e-12);
  EXPECT_NEAR(difference->standard_error, 0.1 * mean->standard_error / mean->value, 1e-12);
  EXPECT_EQ(difference->count, 199u);
  EXPECT_EQ(difference->omitted, 1u);
  EXPECT_FALSE(relative_difference(std::vector<double>{0, 0}, std::vector<double>{1, 2}));
  EXPECT_THROW(relative_difference(first, std::vector<double>{1}), std::invalid_argument);
}

}  // namespace
}  // namespace ringfilm::study
