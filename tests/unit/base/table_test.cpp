#include "ringfilm/base/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace {

using ringfilm::InputError;
using ringfilm::interpolate_linear;
using ringfilm::MonotoneBlend;
using ringfilm::MonotoneCubic;

// Values of order one, a handful of operations.
constexpr double kRounding = 1e-14;

TEST(InterpolateLinear, PassesThroughSamplesAndContinuesTheEndSlopes) {
  const std::vector<double> x{0, 1, 3}, y{2, 4, 0};
  EXPECT_EQ(interpolate_linear(x, y, 1), 4);
  EXPECT_NEAR(interpolate_linear(x, y, 0.25), 2.5, kRounding);
  EXPECT_NEAR(interpolate_linear(x, y, -1), 0, kRounding);
  EXPECT_NEAR(interpolate_linear(x, y, 4), -2, kRounding);
}

TEST(InterpolateLinear, OneSampleIsAConstant) {
  const std::vector<double> x{5}, y{7};
  EXPECT_EQ(interpolate_linear(x, y, -100), 7);
}

TEST(InterpolateLinear, ListsOfUnlikeLengthsAreRefused) {
  const std::vector<double> three{1, 2, 3}, two{1, 2}, none;
  EXPECT_THROW(interpolate_linear(three, two, 2.5), InputError);
  EXPECT_THROW(interpolate_linear(two, three, 1.5), InputError);
  EXPECT_THROW(interpolate_linear(none, none, 1), InputError);
  EXPECT_THROW(MonotoneCubic(three, two), InputError);
  EXPECT_THROW(MonotoneCubic({1}, {1}), InputError);
}

TEST(MonotoneCubic, PassesThroughItsSamples) {
  const std::vector<double> x{0, 0.3, 1, 4}, y{1, 5, 5.5, 30};
  const MonotoneCubic cubic(x, y);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(cubic.at(x[k]).value, y[k], 30 * kRounding);
}

TEST(MonotoneCubic, IsExactForAStraightLineEvenBeyondItsEnds) {
  const MonotoneCubic cubic({0, 1, 2.5, 3}, {1, 3, 6, 7});
  for (const double x : {-2.0, 0.0, 0.7, 1.0, 2.9, 10.0}) {
    EXPECT_NEAR(cubic.at(x).value, 1 + 2 * x, 20 * kRounding);
    EXPECT_NEAR(cubic.at(x).slope, 2, kRounding);
  }
}

TEST(MonotoneCubic, StaysMonotoneBesideASharpBend) {
  const MonotoneCubic cubic({0, 1, 2, 3, 4}, {0, 0, 0.001, 10, 10});
  double last = cubic.at(-1).value;
  for (int k = -100; k <= 500; ++k) {
    const auto [value, slope] = cubic.at(k / 100.0);
    EXPECT_GE(value, last - kRounding);
    EXPECT_GE(slope, -kRounding);
    last = value;
  }
}

TEST(MonotoneCubic, ConvergesToASmoothMonotoneFunctionAtSecondOrderOrBetter) {
  // The slopes are limited only where data turn; exp does not, so that halving the spacing must gain a factor 4 at
  // least.
  const auto largest_error = [](int n) {
    std::vector<double> x, y;
    for (int k = 0; k <= n; ++k) {
      x.push_back(2.0 * k / n);
      y.push_back(std::exp(x.back()));
    }
    const MonotoneCubic cubic(x, y);
    double error = 0;
    for (double at = 0; at <= 2; at += 0.0037) error = std::max(error, std::abs(cubic.at(at).value - std::exp(at)));
    return error;
  };
  EXPECT_GT(largest_error(10) / largest_error(20), 4);
}

TEST(MonotoneBlend, MeetsBothEndsAndLeavesWithTheGivenSlopes) {
  const MonotoneBlend blend({10, 5, -0.3}, {20, 1, -0.1});
  EXPECT_NEAR(blend.at(10), 5, kRounding);
  EXPECT_NEAR(blend.at(20), 1, 5 * kRounding);
  // Differences over 1e-6 of a curve with second derivatives of order 0.1: 1e-7 of truncation, 1e-9 of rounding.
  EXPECT_NEAR((blend.at(10 + 1e-6) - 5) / 1e-6, -0.3, 1e-6);
  EXPECT_NEAR((1 - blend.at(20 - 1e-6)) / 1e-6, -0.1, 1e-6);
}

TEST(MonotoneBlend, GivesUpASlopeThatWouldOvershoot) {
  for (const double slope : {+5.0, -50.0}) {
    const MonotoneBlend blend({0, 1, slope}, {1, 0, slope});
    double last = 1;
    for (int k = 1; k <= 1000; ++k) {
      const double value = blend.at(k / 1000.0);
      EXPECT_LE(value, last + kRounding);
      EXPECT_GE(value, -kRounding);
      last = value;
    }
  }
}

TEST(MonotoneBlend, IsConstantBetweenEqualEnds) {
  const MonotoneBlend blend({0, 3, 1}, {7, 3, -2});
  EXPECT_EQ(blend.at(2.2), 3);
}

}  // namespace
