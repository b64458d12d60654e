#include "ringfilm/life/wear/run_in_depth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/life/wear_integration.hpp"

namespace ringfilm::life {
namespace {

constexpr double kScale = 0.1e-6;

TEST(RunInDepth, AnUnwornSurfaceHasAllOfItsExcess) {
  for (const std::vector<double>& depth : {std::vector<double>{}, {0, 0, 0}}) {
    const RunInDepth run_in = run_in_depth(depth, {}, kScale);
    EXPECT_EQ(run_in.excess_left, 1);
    EXPECT_EQ(run_in.loss_per_depth, 1);
  }
}

TEST(RunInDepth, AUniformDepthLeavesTheExponential) {
  for (const double depth : {1e-12, 0.03e-6, 0.1e-6, 0.7e-6}) {
    const RunInDepth run_in = run_in_depth({depth, depth, depth}, {1e-4, 3e-4, 2e-4}, kScale);
    EXPECT_NEAR(run_in.excess_left, std::exp(-depth / kScale), 1e-15);
    EXPECT_NEAR(run_in.loss_per_depth, (1 - std::exp(-depth / kScale)) * kScale / depth, 1e-9);  // round-off of 1 - e
  }
}

TEST(RunInDepth, PlacesCountByTheVolumeThatTheyHaveLost) {
  // 1 of depth 1 and width 1, 6 of depth 2 and width 3, none of the unworn one.
  const RunInDepth run_in = run_in_depth({kScale, 2 * kScale, 0}, {1, 3, 5}, kScale);
  EXPECT_NEAR(run_in.excess_left, (std::exp(-1.0) + 6 * std::exp(-2.0)) / 7, 1e-15);
  EXPECT_NEAR(run_in.loss_per_depth, ((1 - std::exp(-1.0)) + 3 * (1 - std::exp(-2.0))) / 7, 1e-15);
}

/// What is left after two depths is the product of what each leaves: the law has no memory.
TEST(RunInDepth, ALifeThatIsContinuedHasTheRoughnessOfTheWhole) {
  const double first = 0.04e-6, second = 0.09e-6;
  const double whole = run_in_depth({first + second}, {}, kScale).excess_left;
  EXPECT_NEAR(run_in_depth({first}, {}, kScale).excess_left * run_in_depth({second}, {}, kScale).excess_left, whole,
              1e-15);
}

/// Peaks lose (1 - e^-x) of their excess where the depth x is lost: never more than at the first depth.
TEST(RunInDepth, PeaksNeverLoseMoreThanTheirShareOfTheFirstDepth) {
  double before = 1;
  for (double depth = 1e-10; depth < 10e-6; depth *= 1.7) {
    const RunInDepth run_in = run_in_depth({depth, 0.2 * depth, 3 * depth}, {}, kScale);
    EXPECT_LT(run_in.loss_per_depth, before);
    EXPECT_GT(run_in.loss_per_depth, 0);
    EXPECT_GT(run_in.excess_left, 0);
    before = run_in.loss_per_depth;
  }
}

/// Closed form: under a constant load the depth is k q t, and the excess falls with the time constant l/(k q).
TEST(RunInDepth, UnderAConstantLoadTheExcessFallsExponentiallyOverTime) {
  constexpr double kLoad = 2e6;  // [Pa m/s]
  Wear wear;
  wear.coefficient = 1e-20;
  wear.liner_coefficient = 5e-18;
  const double time_constant = kScale / (*wear.liner_coefficient * kLoad);
  const std::vector<double> times = {0, 0.5 * time_constant, time_constant, 4 * time_constant};
  const auto load = [](const WornDepths&) { return WearLoad{{kLoad}, {kLoad, kLoad}, 0}; };
  const WearHistory history = integrate_wear(wear, times, 1, 2, load);
  ASSERT_EQ(history.states.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double left = run_in_depth(history.states[i].liner, {}, kScale).excess_left;
    EXPECT_NEAR(left, std::exp(-times[i] / time_constant), 1e-13);
  }
}

}  // namespace
}  // namespace ringfilm::life
