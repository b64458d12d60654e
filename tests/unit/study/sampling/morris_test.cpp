#include "ringfilm/study/sampling/morris.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "../study_example.hpp"

namespace ringfilm::study {
namespace {

using namespace testing;

std::vector<double> values_along(const MorrisTrajectories& trajectories, std::uint64_t n, const Formula& formula) {
  std::vector<double> values;
  for (std::uint64_t i = 0; i < n * trajectories.points_per_trajectory(); ++i)
    values.push_back(formula(trajectories.point(i)));
  return values;
}

TEST(Morris, EachStepMovesOneFactorAndEachFactorMovesOnce) {
  const std::size_t k = 5, levels = 6;
  const MorrisTrajectories trajectories(k, levels, 3);
  for (std::uint64_t t = 0; t < 50; ++t) {
    std::set<std::size_t> moved;
    for (std::uint64_t s = 0; s <= k; ++s) {
      const std::uint64_t i = t * (k + 1) + s;
      const std::vector<double> here = trajectories.point(i);
      for (const double x : here) {
        EXPECT_NEAR(x * (levels - 1), std::round(x * (levels - 1)), 1e-12);
        EXPECT_GE(x, 0);
        EXPECT_LE(x, 1);
      }
      const auto step = trajectories.step_to(i);
      EXPECT_EQ(step.has_value(), s > 0);
      if (s == 0) continue;
      const std::vector<double> before = trajectories.point(i - 1);
      for (std::size_t j = 0; j < k; ++j) {
        // levels/(2 (levels - 1)) = 3/5
        const double change = j == step->factor ? step->change : 0;
        EXPECT_NEAR(here[j] - before[j], change, 1e-12);
      }
      EXPECT_NEAR(std::abs(step->change), 0.6, 1e-12);
      moved.insert(step->factor);
    }
    EXPECT_EQ(moved.size(), k);
  }
}

TEST(Morris, LevelsAndOrdersAreEven) {
  const MorrisTrajectories trajectories(3, 4, 1);
  std::map<long, int> levels;
  std::map<std::size_t, int> firsts;
  for (std::uint64_t t = 0; t < 4000; ++t) {
    ++levels[std::lround(3 * trajectories.point(4 * t)[1])];
    ++firsts[trajectories.step_to(4 * t + 1)->factor];
  }
  for (const long level : {0, 1, 2, 3}) EXPECT_NEAR(levels[level], 1000, 4.5 * std::sqrt(4000 * 0.25 * 0.75));
  for (const std::size_t j : {0u, 1u, 2u}) EXPECT_NEAR(firsts[j], 4000 / 3.0, 4.5 * std::sqrt(4000 * 2.0 / 9));
}

TEST(Morris, EffectsOfALinearFunctionAreItsSlopes) {
  const MorrisTrajectories trajectories(3, 4, 1);
  const auto effects = morris_effects(
      trajectories, values_along(trajectories, 10, [](const auto& x) { return 3 * x[0] - 5 * x[1] + 100; }));
  ASSERT_EQ(effects.size(), 3u);
  const std::vector<double> slopes = {3, -5, 0};
  for (std::size_t j = 0; j < 3; ++j) {
    ASSERT_TRUE(effects[j]);
    EXPECT_EQ(effects[j]->count, 10u);
    EXPECT_NEAR(effects[j]->mean, slopes[j], 1e-12);
    EXPECT_NEAR(effects[j]->mean_absolute, std::abs(slopes[j]), 1e-12);
    EXPECT_NEAR(effects[j]->deviation, 0, 1e-12);
    EXPECT_NEAR(effects[j]->mean_absolute_error, 0, 1e-12);
  }
}

TEST(Morris, CurvatureAndInteractionShowInTheDeviation) {
  // (x - 1/2)^2 with 4 levels: every effect is +1/3 or -1/3, as likely, whatever the step.
  // 2 y z: that of y is 2 z, z being one of four levels: mean 1, variance 4 times that of 0, 1/3, 2/3, 1, which is
  // 5/36.
  constexpr std::uint64_t n = 4000;
  const MorrisTrajectories trajectories(3, 4, 2);
  const auto effects = morris_effects(trajectories, values_along(trajectories, n, [](const auto& x) {
                                        return (x[0] - 0.5) * (x[0] - 0.5) + 2 * x[1] * x[2];
                                      }));
  const double few = 4.5 / std::sqrt(static_cast<double>(n));
  EXPECT_NEAR(effects[0]->mean, 0, few / 3);
  EXPECT_NEAR(effects[0]->mean_absolute, 1.0 / 3, 1e-12);
  EXPECT_NEAR(effects[0]->deviation, 1.0 / 3, few / 3);
  const double deviation = std::sqrt(20.0 / 36);
  for (const std::size_t j : {1u, 2u}) {
    EXPECT_NEAR(effects[j]->mean, 1, few * deviation);
    EXPECT_NEAR(effects[j]->deviation, deviation, few * deviation);
    EXPECT_NEAR(effects[j]->mean_absolute_error, deviation / std::sqrt(static_cast<double>(n)), 1e-3);
  }
}

TEST(Morris, AScenarioThatWasNotSolvedSpoilsTheStepsThatTouchIt) {
  const MorrisTrajectories trajectories(2, 4, 1);
  std::vector<double> values = values_along(trajectories, 5, [](const auto& x) { return x[0] + 2 * x[1]; });
  values[4] = std::numeric_limits<double>::quiet_NaN();  // the middle of the second trajectory
  const auto effects = morris_effects(trajectories, values);
  for (const std::size_t j : {0u, 1u}) {
    EXPECT_EQ(effects[j]->count, 4u);
    EXPECT_EQ(effects[j]->omitted, 1u);
    EXPECT_NEAR(effects[j]->mean, static_cast<double>(j) + 1, 1e-12);
  }
  EXPECT_FALSE(morris_effects(trajectories, std::span(values).first(3))[0]) << "one effect states nothing of scatter";
}

TEST(Morris, PlanPutsLevelsIntoTheRangesOfFactors) {
  Study study = study_of(
      {factor("operating.speed", Span{100, 400, 2, Spacing::kLinear}), factor("contact.roughness", normal(5e-7, 1e-7))},
      Method::kMorris);
  study.sampling.trajectories = 8;
  const Plan plan(study);
  EXPECT_EQ(plan.size(), 24u);
  std::set<long> speeds;
  std::set<double> heights;
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    const auto x = numbers(plan.point(i));
    speeds.insert(std::lround(x[0]));
    heights.insert(x[1]);
  }
  EXPECT_EQ(speeds, (std::set<long>{100, 200, 300, 400}));
  ASSERT_EQ(heights.size(), 4u);
  EXPECT_NEAR(*heights.begin(), 5e-7 - 2.5758293e-7, 1e-12) << "quantile of 0.5 %, not minus infinity";
  const auto effects = morris_effects(plan.trajectories(), values_of(plan, [](const auto& x) { return 2 * x[0]; }));
  EXPECT_NEAR(effects[0]->mean, 600, 1e-9) << "over the whole range";
  EXPECT_FALSE(plan.is_sample(0));
  EXPECT_THROW(Plan(study_of({factor("operating.speed", Levels{{100}})})).trajectories(), std::logic_error);
}

}  // namespace
}  // namespace ringfilm::study
