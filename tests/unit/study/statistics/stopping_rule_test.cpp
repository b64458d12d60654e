#include "ringfilm/study/statistics/stopping_rule.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "../study_example.hpp"

namespace ringfilm::study {
namespace {

using namespace testing;
using ::testing::ElementsAre;

Study going_on(std::uint64_t scenarios, Indices indices) {
  Study study =
      study_of({factor("operating.speed", uniform(100, 400)), factor("contact.roughness", normal(5e-7, 1e-8))},
               Method::kSobol, scenarios);
  study.bases.push_back({"other", study.bases.front().input});
  study.sampling.indices = indices;
  study.sampling.until = StoppingRule{"fmep", std::nullopt, 1, 1000};
  return study;
}

TEST(StoppingRule, LooksAtTwiceAsManyPointsUpToTheMost) {
  const StoppingRule until{"fmep", std::nullopt, 1, 100};
  std::vector<std::uint64_t> looks;
  for (std::optional<std::uint64_t> n = 16; n; n = next_look(until, *n)) looks.push_back(*n);
  EXPECT_THAT(looks, ElementsAre(16, 32, 64, 100));
  EXPECT_FALSE(next_look(until, 100));
}

TEST(StoppingRule, ListsItsLooks) {
  Study study;
  study.sampling.scenarios = 16;
  study.sampling.until = StoppingRule{"fmep", std::nullopt, 1, 100};
  for (const std::uint64_t n : {16, 32, 64, 100}) EXPECT_TRUE(is_look(study, n)) << n;
  for (const std::uint64_t n : {0, 8, 17, 48, 128}) EXPECT_FALSE(is_look(study, n)) << n;
}

TEST(StoppingRule, EachBaseHasTheIntervalOfItsOwnSample) {
  const Plan plan(going_on(4, Indices::kNone));
  // Scenarios go from base to base: the first has 1, 2, 3, 4, the second always 7.
  const std::vector<IntervalWidth> found = interval_widths(plan, {1, 7, 2, 7, 3, 7, 4, 7});
  ASSERT_EQ(found.size(), 2u);
  // Deviation sqrt(5/3); Student's t of 0.975 with 3 degrees of freedom is 3.18245.
  EXPECT_NEAR(*found[0].width, 2 * 3.18245 * std::sqrt(5.0 / 3) / 2, 1e-4);
  EXPECT_EQ(found[1].width, 0);
  EXPECT_FALSE(is_sure({"fmep", std::nullopt, 1, 100}, found));
  EXPECT_TRUE(is_sure({"fmep", std::nullopt, 5, 100}, found));
}

TEST(StoppingRule, PointsThatShareCoordinatesAreNoSample) {
  const Plan plan(going_on(2, Indices::kFirstAndTotal));
  ASSERT_EQ(plan.points_per_row(), 4u);
  std::vector<double> values(plan.size(), 1e9);
  for (const std::uint64_t p : {0, 1, 4, 5}) values[plan.scenario(0, p)] = values[plan.scenario(1, p)] = 3;
  for (const IntervalWidth& one : interval_widths(plan, values)) EXPECT_EQ(one.width, 0);
}

TEST(StoppingRule, WithoutSolvedScenariosNothingIsSure) {
  const Plan plan(going_on(2, Indices::kNone));
  const std::vector<double> none(plan.size(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(is_sure({"fmep", std::nullopt, 1e300, 100}, interval_widths(plan, none)));
}

}  // namespace
}  // namespace ringfilm::study
