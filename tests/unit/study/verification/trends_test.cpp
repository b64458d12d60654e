#include "ringfilm/study/verification/trends.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ringfilm::study {
namespace {

Trend expecting(TrendExpectation expectation) {
  Trend trend;
  trend.expectation = expectation;
  trend.least_change = 0.02;
  return trend;
}

bool agrees(const Trend& trend, const std::vector<double>& values, double change_of_other = 0) {
  return agreement(trend, values, change_of_other) == Agreement::kAgrees;
}

TEST(Trends, RiseAndFallAreBeyondTheScatterAndNeverTurn) {
  const Trend rises = expecting(TrendExpectation::kRises), falls = expecting(TrendExpectation::kFalls);
  EXPECT_TRUE(agrees(rises, {1, 1.05, 1.1}));
  EXPECT_TRUE(agrees(rises, {1, 0.99, 1.1}));  // 1 % down is scatter
  EXPECT_FALSE(agrees(rises, {1, 1.3, 1.1}));
  EXPECT_FALSE(agrees(rises, {1, 1.01}));
  EXPECT_FALSE(agrees(rises, {1.1, 1}));
  EXPECT_TRUE(agrees(falls, {1.1, 1.05, 1}));
  EXPECT_FALSE(agrees(falls, {1, 0.99}));
  EXPECT_FALSE(agrees(falls, {1, 1.1}));
}

TEST(Trends, AMinimumInsideIsBelowBothEnds) {
  const Trend trend = expecting(TrendExpectation::kHasMinimumInside);
  EXPECT_TRUE(agrees(trend, {1.2, 1, 1.1}));
  EXPECT_FALSE(agrees(trend, {1.2, 1, 1.01}));
  EXPECT_FALSE(agrees(trend, {1.3, 1.2, 1}));
}

TEST(Trends, UnchangedNumbersStayNearTheFirst) {
  const Trend trend = expecting(TrendExpectation::kUnchanged);
  EXPECT_TRUE(agrees(trend, {1, 1.01, 0.99}));
  EXPECT_FALSE(agrees(trend, {1, 1.05, 1}));
}

TEST(Trends, ALargerChangeIsOneOfEitherSign) {
  const Trend trend = expecting(TrendExpectation::kLargerChangeThan);
  EXPECT_TRUE(agrees(trend, {1, 0.8}, 0.1));
  EXPECT_FALSE(agrees(trend, {1, 0.95}, 0.1));
}

TEST(Trends, LimitsHoldEachNumber) {
  Trend trend = expecting(TrendExpectation::kWithin);
  trend.least_limit = 1;
  trend.most_limit = 3;
  EXPECT_TRUE(agrees(trend, {1, 2, 3}));
  EXPECT_FALSE(agrees(trend, {1, 3.5}));
}

TEST(Trends, ARunWithoutANumberDisagrees) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [word, expectation] : trend_expectations()) {
    EXPECT_FALSE(agrees(expecting(expectation), {1, none}, 0.1)) << word;
  }
}

TEST(Trends, AnOutcomeIsAsRecordedWhenItsRunsEnded) {
  TrendOutcome outcome;
  outcome.trend.known = Agreement::kDisagrees;
  outcome.found = Agreement::kDisagrees;
  EXPECT_TRUE(outcome.is_as_recorded());
  outcome.stops = {"2000 rpm: no film"};
  EXPECT_FALSE(outcome.is_as_recorded());
  outcome.stops.clear();
  outcome.found = Agreement::kAgrees;
  EXPECT_FALSE(outcome.is_as_recorded());
}

TEST(Trends, AProbeKnowsItsKindByItsWindow) {
  TrendProbe probe{"total_friction", std::nullopt, 1, CrankWindow{0, 60, WindowValue::kMax}};
  EXPECT_TRUE(find_probed(probe, probe.quantity));
  probe.share_of = "boundary_friction";
  EXPECT_EQ(probed_quantity(probe).unit, "1");
  probe.window.reset();
  EXPECT_FALSE(find_probed(probe, probe.quantity));  // no value of the cycle has this name
  EXPECT_TRUE(is_of_gas({"blow_by_flow", std::nullopt, std::nullopt, std::nullopt}));
  EXPECT_FALSE(is_of_gas({"fmep", std::nullopt, std::nullopt, std::nullopt}));
}

}  // namespace
}  // namespace ringfilm::study
