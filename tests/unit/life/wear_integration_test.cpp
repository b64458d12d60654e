#include "ringfilm/life/wear_integration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dry_contact.hpp"

namespace ringfilm::life {
namespace {

using testing::DryContact;
using testing::places;

constexpr double kLoad = 2000, kSpeed = 10, kWidth = 1.2e-3;  // [N/m], [m/s], [m]
constexpr double kCoefficient = 1e-17;                        // [m2/N]

/// Worn depths after a sliding length [m].
WearHistory worn_after(const DryContact& dry, std::size_t n, double sliding, Wear wear = {}) {
  wear.coefficient = kCoefficient;
  return integrate_wear(wear, {sliding / kSpeed}, n, 0,
                        [&](double, const std::vector<double>& worn) { return dry(worn); });
}

std::vector<double> heights(const std::vector<double>& x, const std::function<double(double)>& height) {
  std::vector<double> all;
  for (const double place : x) all.push_back(height(place - 0.5 * kWidth));
  return all;
}

TEST(WearIntegration, AFlatOnAFlatLosesCoefficientTimesPressureTimesSliding) {
  const auto x = places(kWidth, 60);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  const double sliding = 1e5, expected = kCoefficient * kLoad / kWidth * sliding;
  const WearHistory history = worn_after(dry, x.size(), sliding);
  for (const double depth : history.states.front().face) EXPECT_NEAR(depth / expected, 1, 1e-13);
}

TEST(WearIntegration, TheWornAreaIsCoefficientTimesLoadTimesSlidingToRoundOff) {
  const auto x = places(kWidth, 200);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, heights(x, [](double s) { return s * s / 0.02; }));
  const double sliding = 2e5;
  const WearHistory history = worn_after(dry, x.size(), sliding);
  EXPECT_NEAR(dry.area(history.states.front().face) / (kCoefficient * kLoad * sliding), 1, 1e-12);
}

TEST(WearIntegration, AParabolaGetsTheLandOfItsVolume) {
  // Smooth: half width a = (3/2 R k W' s)^(1/3), depth a^2/(2R). The roughness is 1 % of the depth.
  const double R = 0.02;
  const auto x = places(kWidth, 480);
  const DryContact dry(0.02e-6, kLoad, kSpeed, x, heights(x, [R](double s) { return s * s / (2 * R); }));
  Wear wear;
  wear.largest_depth = 5e-9;
  wear.jump_error = 0.5e-9;
  std::vector<double> depth;
  for (const double sliding : {4e4, 8e4}) {
    const auto worn = worn_after(dry, x.size(), sliding, wear).states.front().face;
    depth.push_back(*std::max_element(worn.begin(), worn.end()));
    const double a = std::cbrt(1.5 * R * kCoefficient * kLoad * sliding);
    EXPECT_NEAR(depth.back() / (a * a / (2 * R)), 1, 5e-3);
  }
  EXPECT_NEAR(std::log2(depth[1] / depth[0]), 2.0 / 3, 5e-3);
}

TEST(WearIntegration, ARoofGetsTheLandOfItsVolume) {
  const double m = 0.01;
  const auto x = places(kWidth, 480);
  const DryContact dry(0.02e-6, kLoad, kSpeed, x, heights(x, [m](double s) { return m * std::abs(s); }));
  Wear wear;
  wear.largest_depth = 5e-9;
  wear.jump_error = 0.5e-9;
  const double sliding = 4e4;
  const auto worn = worn_after(dry, x.size(), sliding, wear).states.front().face;
  EXPECT_NEAR(*std::max_element(worn.begin(), worn.end()) / std::sqrt(m * kCoefficient * kLoad * sliding), 1, 5e-3);
}

TEST(WearIntegration, AWavinessDecaysWithTheLengthOfThePressure) {
  // Of a small amplitude: exp(-k |dp/dh| s), dp/dh of the flat contact.
  const double amplitude = 1e-9;
  const auto x = places(kWidth, 64);
  std::vector<double> wave;
  for (std::size_t i = 0; i < x.size(); ++i) {
    wave.push_back(amplitude * std::cos(2 * std::numbers::pi * static_cast<double>(i) / 16));
  }
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, wave);
  double h = 0, p = 0, slope = 0;
  for (double low = 0, high = 5e-6; high - low > 1e-16;) {
    h = 0.5 * (low + high);
    dry.contact().pressure(h, p, slope);
    (p > kLoad / kWidth ? low : high) = h;
  }
  const double sliding = 2 / (kCoefficient * std::abs(slope));
  Wear wear;
  wear.jumps = 200;
  const auto worn = worn_after(dry, x.size(), sliding, wear).states.front().face;
  const double left = wave[16] + worn[16] - (wave[8] + worn[8]);
  EXPECT_NEAR(left / (2 * amplitude), std::exp(-2), 1e-3);
}

TEST(WearIntegration, HalvingTheJumpsChangesTheDepthByLessThanTheStages) {
  const auto x = places(kWidth, 120);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, heights(x, [](double s) { return s * s / 0.02; }));
  Wear wear;
  wear.jumps = 8;
  const WearHistory coarse = worn_after(dry, x.size(), 2e4, wear);
  wear.jumps = 16;
  const WearHistory fine = worn_after(dry, x.size(), 2e4, wear);
  double difference = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    difference = std::max(difference, std::abs(coarse.states[0].face[i] - fine.states[0].face[i]));
  }
  EXPECT_LT(difference, coarse.effort.stage_difference);
  EXPECT_LT(fine.effort.stage_difference, 0.35 * coarse.effort.stage_difference);
}

TEST(WearIntegration, AJumpWhoseStagesDifferTooMuchIsRejected) {
  const auto x = places(kWidth, 120);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, heights(x, [](double s) { return s * s / 0.02; }));
  const WearHistory history = worn_after(dry, x.size(), 1e5);
  EXPECT_LE(history.effort.stage_difference, Wear{}.jump_error);
  EXPECT_GT(history.effort.jumps, 3);
}

TEST(WearIntegration, TimesBetweenEqualJumpsAreReportedWithoutChangingTheLater) {
  const auto x = places(kWidth, 120);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, heights(x, [](double s) { return s * s / 0.02; }));
  Wear wear;
  wear.coefficient = kCoefficient;
  wear.jumps = 4;
  const auto load = [&](double, const std::vector<double>& worn) { return dry(worn); };
  const double end = 2e4;
  const WearHistory both = integrate_wear(wear, {0, 0.3 * end, end}, x.size(), 0, load);
  const WearHistory alone = integrate_wear(wear, {end}, x.size(), 0, load);
  EXPECT_EQ(both.states[2].face, alone.states[0].face);
  EXPECT_EQ(both.states[1].time, 0.3 * end);
  EXPECT_EQ(dry.area(both.states[0].face), 0);
  EXPECT_NEAR(dry.area(both.states[1].face) / dry.area(both.states[2].face), 0.3, 1e-12);
}

TEST(WearIntegration, RunningInIsAStepOfTheCoefficient) {
  Wear wear;
  wear.coefficient = 2;
  wear.running_in_coefficient = 10;
  wear.running_in_time = 5;
  EXPECT_EQ(coefficient_integral(wear, 0, 4), 40);
  EXPECT_EQ(coefficient_integral(wear, 4, 7), 14);
  EXPECT_EQ(coefficient_integral(wear, 6, 8), 4);
}

TEST(WearIntegration, ItEndsWhereTheCoatingIsWornThrough) {
  const auto x = places(kWidth, 60);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  Wear wear;
  wear.coefficient = kCoefficient;
  const double per_second = kCoefficient * kLoad / kWidth * kSpeed;
  WearLimits limits;
  limits.deepest = 1e-6;
  const WearHistory history = integrate_wear(
      wear, {0.5e-6 / per_second, 2e-6 / per_second}, x.size(), 0,
      [&](double, const std::vector<double>& worn) { return dry(worn); }, limits);
  EXPECT_EQ(history.states.size(), 1u);
  ASSERT_TRUE(history.worn_through);
  EXPECT_NEAR(*history.worn_through * per_second, 1e-6, 1e-18);
}

}  // namespace
}  // namespace ringfilm::life
