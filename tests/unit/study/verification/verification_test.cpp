#include "ringfilm/study/verification/verification.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/study/verification/manufactured.hpp"

namespace ringfilm::study {
namespace {

/// Parallel plates under a fall of pressure: load L (p_l + p_r)/2, whatever the grid.
cycle::Case channel() {
  cycle::Case c = cycle::blank_case(cycle::Problem::kPad);
  c.pad.length = 0.02;
  c.pad.gap_x = {0, 0.02};
  c.pad.gap_height = {15e-6, 15e-6};
  c.pad.left_pressure = 3e6;
  c.pad.right_pressure = 0.5e6;
  c.pad.separation = 0.0;
  c.lubricant.viscosity = 0.03;
  c.lubricant.constant_density = 850;
  c.solver.cells = 20;
  return c;
}

Verification with_load(double expected, Tolerance tolerance) {
  Verification verification;
  verification.runs["channel"] = channel();
  ValueCheck check;
  check.label = "load";
  check.run = "channel";
  check.probe = {"load", std::nullopt};
  check.expected = expected;
  check.tolerance = tolerance;
  verification.values.push_back(check);
  return verification;
}

TEST(Verification, HoldsWithinItsToleranceAndFailsBeyondIt) {
  using enum Tolerance::Kind;
  EXPECT_EQ(verify(with_load(35000, {kRelative, 1e-9})).verdict(), Verdict::kHolds);
  EXPECT_EQ(verify(with_load(35004, {kAbsolute, 5})).verdict(), Verdict::kHolds);
  EXPECT_EQ(verify(with_load(35006, {kAbsolute, 5})).verdict(), Verdict::kFails);
  EXPECT_EQ(verify(with_load(-35000, {kRelative, 0.1})).verdict(), Verdict::kFails);
}

TEST(Verification, NumberThatARunDoesNotHaveFails) {
  Verification verification = with_load(35000, {Tolerance::Kind::kRelative, 1e-9});
  verification.values.front().probe.quantity = "rupture_positions.1";  // the channel is full
  const VerificationOutcome outcome = verify(verification);
  EXPECT_TRUE(std::isnan(outcome.rows.front().got));
  EXPECT_EQ(outcome.verdict(), Verdict::kFails);
}

TEST(Verification, RunWithoutSolutionIsReportedAndFails) {
  Verification verification = with_load(35000, {Tolerance::Kind::kRelative, 1e-9});
  verification.runs["channel"].pad.separation.reset();
  verification.runs["channel"].pad.load = 1.0;  // below what the edges alone press
  const VerificationOutcome outcome = verify(verification);
  ASSERT_EQ(outcome.stops.size(), 1u);
  EXPECT_EQ(outcome.verdict(), Verdict::kFails);
}

TEST(Verification, WithoutAnyCheckNothingHolds) { EXPECT_EQ(verify({}).verdict(), Verdict::kFails); }

TEST(Verification, OrderIsTheSlopeOfTheErrors) {
  Verification verification;
  OrderCheck check;
  check.label = "order";
  check.manufactured = "steady";
  check.levels = {40, 80, 160};
  check.order = 2;
  check.tolerance = 0.1;
  verification.orders.push_back(check);
  const VerificationOutcome outcome = verify(verification);
  ASSERT_EQ(outcome.lines.size(), 1u);
  const auto& errors = outcome.lines.front().errors;
  // On a ladder of equal factors least squares through three points are the slope from end to end.
  EXPECT_NEAR(outcome.lines.front().observed_order.value(), std::log(errors[0] / errors[2]) / std::log(4.0), 1e-12);
  EXPECT_EQ(outcome.verdict(), Verdict::kHolds);
}

TEST(Verification, BoundHoldsOnEveryGridOrFails) {
  Verification verification;
  verification.runs["channel"] = channel();
  BoundCheck check;
  check.label = "place of the peak";
  check.run = "channel";
  check.probe = {"peak_position", std::nullopt};
  check.exact = 0;  // pressure falls from the left edge on
  check.fewest_cells = 10;
  check.most_cells = 14;
  check.most = 0.5;
  verification.bounds.push_back(check);
  check.exact = 0.002;  // a cell of ten, 1.4 cells of fourteen
  check.most = 1.2;
  verification.bounds.push_back(check);
  const VerificationOutcome outcome = verify(verification);
  EXPECT_EQ(outcome.rows[0].verdict, Verdict::kHolds);
  EXPECT_NEAR(outcome.rows[1].got, 1.4, 1e-12);
  EXPECT_EQ(outcome.rows[1].verdict, Verdict::kFails);
  EXPECT_EQ(outcome.lines[1].errors.size(), 5u);
}

TEST(Verification, TimeBeyondHalfAStepOfAnyInstantHasNoNumber) {
  Measurement integration;
  integration.instants = {0, 1, 2};
  integration.values["load"] = {5, 6, 7};
  EXPECT_EQ(value(integration, {"load", 1.4}), 6);
  EXPECT_EQ(value(integration, {"load", 2.4}), 7);
  EXPECT_TRUE(std::isnan(value(integration, {"load", 2.6})));
  EXPECT_TRUE(std::isnan(value(integration, {"load", -0.6})));
}

TEST(Manufactured, ErrorInTimeHalvesWithTheStep) {
  const double coarse = manufactured_error("transient", 400, 10), fine = manufactured_error("transient", 400, 20);
  EXPECT_NEAR(coarse / fine, 2.0, 0.1);  // first order; 400 cells leave a twentieth of it
}

}  // namespace
}  // namespace ringfilm::study
