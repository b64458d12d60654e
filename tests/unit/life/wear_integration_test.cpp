#include "ringfilm/life/wear_integration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "ringfilm/base/error.hpp"
#include "ringfilm/life/dry_contact.hpp"

namespace ringfilm::life {
namespace {

constexpr double kLoad = 2000, kSpeed = 10, kWidth = 1.2e-3;  // [N/m], [m/s], [m]
constexpr double kCoefficient = 1e-17;                        // [m2/N]

/// Worn depths after a sliding length [m].
WearHistory worn_after(const DryContact& dry, std::size_t n, double sliding, Wear wear = {}) {
  wear.coefficient = kCoefficient;
  return integrate_wear(wear, {sliding / kSpeed}, n, 0, [&](const WornDepths& now) { return dry(now.face); });
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
  const auto load = [&](const WornDepths& now) { return dry(now.face); };
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
      wear, {0.5e-6 / per_second, 2e-6 / per_second}, x.size(), 0, [&](const WornDepths& now) { return dry(now.face); },
      limits);
  EXPECT_EQ(history.states.size(), 1u);
  ASSERT_TRUE(history.worn_through);
  EXPECT_NEAR(history.worn_through->time * per_second, 1e-6, 1e-18);
  EXPECT_NEAR(history.worn_through->face[0], 1e-6, 1e-18);
}

TEST(WearIntegration, NoStageOfAJumpIsDeeperThanTheCoating) {
  const auto x = places(kWidth, 60);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  Wear wear;
  wear.coefficient = kCoefficient;
  wear.jumps = 2;
  const double per_second = kCoefficient * kLoad / kWidth * kSpeed;
  WearLimits limits;
  limits.deepest = 1e-6;
  double deepest = 0;
  const WearHistory history = integrate_wear(
      wear, {0, 1e-3 / per_second}, x.size(), 0,
      [&](const WornDepths& now) {
        deepest = std::max(deepest, now.face[0]);
        return dry(now.face);
      },
      limits);
  EXPECT_EQ(history.states.size(), 1u);
  EXPECT_LE(deepest, 1e-6 * (1 + 1e-12));
  EXPECT_NEAR(history.worn_through.value().time * per_second, 1e-6, 1e-18);
}

/// A load that grows with the depth w: dw/dt = a (1 + w/l) reaches the depth l after (l/a) ln 2.
TEST(WearIntegration, AJumpThroughTheCoatingHasItsSecondStageWhereTheCoatingEnds) {
  constexpr double kDepth = 1e-6, kRate = 1e-9;  // l [m], a [m/s]
  Wear wear;
  wear.coefficient = 1;
  wear.jumps = 1;
  WearLimits limits;
  limits.deepest = kDepth;
  const auto load = [&](const WornDepths& now) { return WearLoad{{kRate * (1 + now.face[0] / kDepth)}, {}, 0}; };
  const WearHistory history = integrate_wear(wear, {1e5}, 1, 0, load, limits);
  // Loads of a and 2 a at the two stages; the first alone would last l/a.
  EXPECT_NEAR(history.worn_through.value().time, kDepth / (1.5 * kRate), 1e-9);
  EXPECT_NEAR(history.effort.stage_difference, 0.5 * kDepth, 1e-15);
  EXPECT_FALSE(history.effort.lacks_last_stage);
}

TEST(WearIntegration, AFaceAsDeepAsTheCoatingThatHasNoCycleIsMarked) {
  Wear wear;
  wear.coefficient = 1;
  wear.jumps = 1;
  WearLimits limits;
  limits.deepest = 1e-6;
  const auto load = [](const WornDepths& now) -> WearLoad {
    if (now.face[0] > 0) throw ConvergenceError("no film");
    return {{1e-9}, {}, 0};
  };
  const WearHistory history = integrate_wear(wear, {1e5}, 1, 0, load, limits);
  EXPECT_NEAR(history.worn_through.value().time, 1e3, 1e-9);
  EXPECT_TRUE(history.effort.lacks_last_stage);
}

TEST(WearIntegration, APartOfAJumpIsNotReportedDeeperThanTheCoating) {
  const auto x = places(kWidth, 60);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  Wear wear;
  wear.coefficient = kCoefficient;
  wear.jumps = 1;
  const double per_second = kCoefficient * kLoad / kWidth * kSpeed;
  WearLimits limits;
  limits.deepest = 1e-6;
  const WearHistory history = integrate_wear(
      wear, {0, 2e-6 / per_second, 1e-3 / per_second}, x.size(), 0,
      [&](const WornDepths& now) { return dry(now.face); }, limits);
  EXPECT_EQ(history.states.size(), 1u);
  EXPECT_NEAR(history.worn_through.value().time * per_second, 1e-6, 1e-18);
}

/// A parabola that would be lost a hundred times over: its end is found by few jumps, not far from where many find it.
TEST(WearIntegration, TheEndOfACoatingBeforeAnyReportedTimeIsFoundByFewJumps) {
  const auto x = places(kWidth, 120);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, heights(x, [](double s) { return s * s / 0.02; }));
  Wear wear;
  wear.coefficient = kCoefficient;
  const double last = 100 * 100e-6 * kWidth / (kCoefficient * kLoad * kSpeed);
  WearLimits limits;
  limits.deepest = 100e-6;
  const auto load = [&](const WornDepths& now) { return dry(now.face); };
  const WearHistory fine = integrate_wear(wear, {0, last}, x.size(), 0, load, limits);
  limits.decay_depth = 0.15e-6;
  double passed = 0;
  limits.after_jump = [&](const WornDepths& now) { passed = now.time; };
  const WearHistory coarse = integrate_wear(wear, {0, last}, x.size(), 0, load, limits);
  EXPECT_GT(fine.effort.jumps, 600);
  EXPECT_FALSE(fine.effort.coarse_depth);
  EXPECT_LT(coarse.effort.jumps, 150);
  EXPECT_EQ(coarse.effort.coarse_depth, 1e-6);
  EXPECT_EQ(coarse.states.size(), 1u);
  EXPECT_NEAR(coarse.worn_through.value().time / fine.worn_through.value().time, 1, 0.02);
  EXPECT_EQ(passed, coarse.worn_through->time);
}

TEST(WearIntegration, ACoatingThatLastsToAReportedTimeIsNotWornByFewJumps) {
  const auto x = places(kWidth, 60);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  Wear wear;
  wear.coefficient = kCoefficient;
  const double per_second = kCoefficient * kLoad / kWidth * kSpeed;
  WearLimits limits;
  limits.deepest = 1e-6;
  limits.decay_depth = 0.15e-6;
  const WearHistory history = integrate_wear(
      wear, {0.9e-6 / per_second}, x.size(), 0, [&](const WornDepths& now) { return dry(now.face); }, limits);
  EXPECT_FALSE(history.effort.coarse_depth);
  EXPECT_EQ(history.states.size(), 1u);
}

/// A load that ends halfway through the coating, whose first rate promised its end.
TEST(WearIntegration, AnEndThatDoesNotComeIsIntegratedAsUsual) {
  Wear wear;
  wear.coefficient = 1;
  WearLimits limits;
  limits.deepest = 1e-6;
  limits.decay_depth = 0.15e-6;
  const auto load = [](const WornDepths& now) {
    return WearLoad{{1e-9 * std::max(0.0, 1 - now.face[0] / 0.5e-6)}, {}, 0};
  };
  const WearHistory history = integrate_wear(wear, {1e4}, 1, 0, load, limits);
  EXPECT_FALSE(history.effort.coarse_depth);
  EXPECT_FALSE(history.worn_through);
  EXPECT_NEAR(history.states.front().face[0], 0.5e-6 * (1 - std::exp(-20.0)), 0.02e-6);
}

TEST(WearIntegration, TooManyJumpsAreRefusedWithTimeAndDepth) {
  const auto x = places(kWidth, 2);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  Wear wear;
  wear.largest_depth = 1e-18;
  try {
    worn_after(dry, x.size(), 1e5, wear);
    FAIL();
  } catch (const ConvergenceError& stopped) {
    EXPECT_THAT(stopped.what(), ::testing::HasSubstr("um deep: 100000 jumps were taken"));
  }
}

TEST(WearIntegration, NextToNoWearIsOneJump) {
  const auto x = places(kWidth, 60);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  Wear wear;
  wear.coefficient = 1e-320;
  const WearHistory history =
      integrate_wear(wear, {1e4}, x.size(), 0, [&](const WornDepths& now) { return dry(now.face); });
  EXPECT_EQ(history.effort.jumps, 1);
}

TEST(WearIntegration, ItEndsWhereEnoughIsWorn) {
  const auto x = places(kWidth, 60);
  const DryContact dry(0.5e-6, kLoad, kSpeed, x, std::vector<double>(x.size(), 0.0));
  Wear wear;
  wear.coefficient = kCoefficient;
  double worn = 0;
  WearLimits limits;
  limits.after_jump = [&](const WornDepths& now) { worn = now.face[0]; };
  limits.is_enough = [&] { return worn > 1e-6; };
  const WearHistory history = integrate_wear(
      wear, {1e9}, x.size(), 0, [&](const WornDepths& now) { return dry(now.face); }, limits);
  EXPECT_GT(history.states.back().face[0], 1e-6);
  EXPECT_LT(history.states.back().face[0], 1.2e-6);
}

}  // namespace
}  // namespace ringfilm::life
