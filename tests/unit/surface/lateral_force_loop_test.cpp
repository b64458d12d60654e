#include "ringfilm/surface/friction_loop/lateral_force_loop.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "friction_examples.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

LoopPlan quiet() {
  LoopPlan plan;
  plan.point_noise_V = plan.loop_noise_V = 0;
  return plan;
}

TEST(FrictionLoop, GivesHalfTheDifferenceBetweenTheTurningEnds) {
  Normal normal(1);
  const LoopPlan plan = quiet();
  const LoopFriction friction = loop_friction(friction_loop(plan, 1.0, 1.0, normal), 0.12);
  EXPECT_NEAR(friction.tmr_V, 0.09, 1e-14);
  // The sample's slope of 0.05 V a line is in the offset alone; its middle is the middle of the line.
  EXPECT_NEAR(friction.offset_V, 0.3 + 0.025, 1e-14);
  EXPECT_EQ(friction.points, 30);  // 0.12 of 39 steps are 4.7: five points go at each end
}

TEST(FrictionLoop, IsTooSmallWhereTheEndsAreLeftIn) {
  Normal normal(1);
  const FrictionLoop loop = friction_loop(quiet(), 1.0, 1.0, normal);
  EXPECT_LT(loop_friction(loop, 0).tmr_V, 0.95 * loop_friction(loop, 0.12).tmr_V);
}

TEST(FrictionLoop, CountsNeighboursThatHangTogetherOnce) {
  Normal normal(7);
  // First-order autoregressive noise of rho = 0.8: n (1 - rho)/(1 + rho) = n/9 independent points.
  const double rho = 0.8;
  const int n = 20000;
  std::vector<double> noise(n), white(n);
  double last = 0;
  for (int i = 0; i < n; ++i) {
    last = rho * last + std::sqrt(1 - rho * rho) * normal();
    noise[i] = last;
    white[i] = normal();
  }
  // The sum over lags is known to about sqrt(4 M/n), M some 30 lags: 8 %; the first negative one ends it, 15 % allowed.
  EXPECT_NEAR(independent_points(noise), n / 9.0, 0.15 * n / 9.0);
  EXPECT_GT(independent_points(white), 0.9 * n);
  EXPECT_EQ(independent_points(std::vector<double>(50, 3.0)), 50);
}

TEST(FrictionLoop, StandardErrorIsTheScatterOfMeans) {
  // The standard errors reported, against the scatter of 400 loops: its own error is 1/sqrt(800) = 3.5 %; 4 sigma
  // allowed.
  LoopPlan plan;
  plan.loop_noise_V = 0;
  Normal normal(3);
  double reported = 0, squares = 0, sum = 0;
  const int n = 400;
  for (int i = 0; i < n; ++i) {
    const LoopFriction friction = loop_friction(friction_loop(plan, 1, 1, normal), 0.12);
    reported += friction.tmr_deviation_V / n;
    sum += friction.tmr_V / n;
    squares += (friction.tmr_V - 0.09) * (friction.tmr_V - 0.09) / n;
  }
  EXPECT_NEAR(sum, 0.09, 4 * std::sqrt(squares / n));
  // White noise counts some lags above zero by chance, which makes the reported error larger, never smaller.
  EXPECT_GT(reported, 0.86 * std::sqrt(squares));
  EXPECT_LT(reported, 1.4 * std::sqrt(squares));
}

TEST(FrictionOfLoads, JoinsLoopsOfOneLoadInRisingOrder) {
  LoopPlan plan = quiet();
  Normal normal(5);
  std::vector<FrictionLoop> loops;
  for (const double load : {2.0, 1.0, 2.0, 3.0}) loops.push_back(friction_loop(plan, load, load, normal));
  loops[0].trace_V.assign(loops[0].trace_V.size(), 1.0);
  loops[0].retrace_V.assign(loops[0].trace_V.size(), 0.6);
  loops[2].trace_V.assign(loops[0].trace_V.size(), 1.0);
  loops[2].retrace_V.assign(loops[0].trace_V.size(), 0.4);
  const auto loads = friction_of_loads(loops, 0.12, 0.01);
  ASSERT_EQ(loads.size(), 3u);
  EXPECT_EQ(loads[1].load, 2.0);
  EXPECT_EQ(loads[1].loops, 2);
  EXPECT_NEAR(loads[1].tmr_V, 0.25, 1e-15);
  EXPECT_NEAR(loads[1].tmr_scatter_V, 0.05 * std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(loads[1].tmr_deviation_V, 0.05, 1e-15);
  // The scatter is pooled: the single loops have it too.
  EXPECT_NEAR(loads[0].tmr_deviation_V, 0.05 * std::sqrt(2.0), 1e-15);
  EXPECT_EQ(loads[0].load_deviation, 0.01);
}

TEST(FrictionLoop, IsMadeOfEachWholeLineOfAScan) {
  std::vector<double> trace(36, 0.4), retrace(36, 0.2);
  retrace[13] = std::numeric_limits<double>::quiet_NaN();
  const auto loops = loops_of_scan(0.7, 12, 1e-8, trace, retrace);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[1].load, 0.7);
  EXPECT_NEAR(loops[1].position_m.back(), 11e-8, 1e-20);
  EXPECT_NEAR(loop_friction(loops[0], 0.1).tmr_V, 0.1, 1e-15);
  EXPECT_THROW(loops_of_scan(0.7, 13, 1e-8, trace, retrace), InputError);
  EXPECT_THROW(loops_of_scan(0.7, 12, 0, trace, retrace), InputError);
  EXPECT_THROW(loops_of_scan(0.7, 36, 1e-8, trace, retrace), InputError);
}

TEST(FrictionLoop, RefusesInvalidInput) {
  Normal normal(1);
  const FrictionLoop good = friction_loop(quiet(), 1, 1, normal);
  EXPECT_NO_THROW(loop_friction(good, 0.1));
  EXPECT_THROW(loop_friction(good, 0.5), InputError);
  EXPECT_THROW(loop_friction(good, -0.1), InputError);
  EXPECT_THROW(loop_friction(good, std::numeric_limits<double>::quiet_NaN()), InputError);
  EXPECT_THROW(loop_friction(good, 0.45), InputError);  // four points left
  EXPECT_THROW(loop_friction({}, 0.1), InputError);
  FrictionLoop bad = good;
  bad.retrace_V.pop_back();
  EXPECT_THROW(loop_friction(bad, 0.1), InputError);
  bad = good;
  std::swap(bad.position_m[3], bad.position_m[4]);
  EXPECT_THROW(loop_friction(bad, 0.1), InputError);
  bad = good;
  bad.trace_V[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(loop_friction(bad, 0.1), InputError);
  EXPECT_THROW(friction_of_loads({good}, 0.1, -1), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
