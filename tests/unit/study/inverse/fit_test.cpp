#include "ringfilm/study/inverse/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace ringfilm::study;
using testing::ElementsAre;
using testing::HasSubstr;

FitParameter parameter(const std::string& key, double lower, double upper) {
  FitParameter one;
  one.key = key;
  one.lower = lower;
  one.upper = upper;
  one.unit = "1";
  return one;
}

/// Values at ten conditions, for t = 1 to 10.
template <class Law>
Measured measured(const Law& law, double deviation, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0, deviation);
  Measured one;
  one.quantity.name = "value";
  for (int t = 1; t <= 10; ++t) {
    one.bases.push_back(0);
    one.values.push_back(law(t) + (seed > 0 ? scatter(random) : 0));
    one.deviations.push_back(deviation);
  }
  return one;
}

/// A model of two parameters at ten conditions.
template <class Law>
Model model(const std::vector<FitParameter>& parameters, const Law& law) {
  return [parameters, law](const std::vector<std::vector<double>>& places) {
    std::vector<std::optional<ModelOutput>> outputs;
    for (const auto& at : places) {
      std::vector<double> x;
      for (std::size_t j = 0; j < at.size(); ++j) x.push_back(value_at(parameters[j], at[j]));
      ModelOutput output{{{}}, {{}}, {x[0]}};
      for (int t = 1; t <= 10; ++t) output.values[0].push_back(law(x, t));
      outputs.push_back(output);
    }
    return outputs;
  };
}

double line(const std::vector<double>& x, int t) { return x[0] + x[1] * t; }
double product(const std::vector<double>& x, int t) { return x[0] * x[1] * t; }

Fit line_fit(unsigned seed) {
  Fit fit;
  fit.parameters = {parameter("a", 0, 10), parameter("b", 0, 4)};
  fit.measured = {measured([](int t) { return 3 + 2. * t; }, 0.5, seed)};
  return fit;
}

/// Deviations of intercept and slope of a straight line over t = 1 to 10: 0.5 times the roots of 7/15 and 2/165.
const double kIntercept = 0.5 * std::sqrt(7. / 15), kSlope = 0.5 * std::sqrt(2. / 165);

TEST(Fit, LineHasTheIntervalsOfLinearRegression) {
  const Fit fit = line_fit(0);
  const FitResult result = ringfilm::study::fit(fit, {0.5, 0.5}, model(fit.parameters, line));
  EXPECT_NEAR(result.parameters[0].value, 3, 1e-3);
  EXPECT_NEAR(result.parameters[1].value, 2, 1e-3);
  EXPECT_NEAR(result.parameters[0].deviation, kIntercept, 1e-6);
  // The profile ends within 2 % of the width.
  EXPECT_NEAR(result.parameters[0].high - 3, 1.96 * kIntercept, 0.02 * 1.96 * kIntercept);
  EXPECT_NEAR(2 - result.parameters[1].low, 1.96 * kSlope, 0.02 * 1.96 * kSlope);
  EXPECT_TRUE(result.parameters[0].identified && result.parameters[1].identified);
  EXPECT_NEAR(result.correlation[0][1], -5.5 / std::sqrt(38.5), 1e-6);  // -mean(t)/sqrt(mean(t^2))
  EXPECT_NEAR(result.predicted[0].high - result.predicted[0].value, 1.96 * kIntercept, 1e-3);
  EXPECT_TRUE(result.not_identified.empty());
}

TEST(Fit, IntervalsCoverTheTruthAsOftenAsTheyState) {
  int n_covered = 0;
  constexpr int kFits = 200;
  for (unsigned seed = 1; seed <= kFits; ++seed) {
    Fit fit = line_fit(seed);
    fit.starts = 1;
    const FitResult result = ringfilm::study::fit(fit, {0.5, 0.5}, model(fit.parameters, line));
    n_covered += result.parameters[1].low <= 2 && 2 <= result.parameters[1].high;
  }
  // 95 % of 200 are 190 with a deviation of 3.1: within three of them.
  EXPECT_NEAR(n_covered, 0.95 * kFits, 9.3);
}

TEST(Fit, FactorsOfAProductAreNotIdentified) {
  Fit fit;
  fit.parameters = {parameter("speed", 1, 10), parameter("viscosity", 1, 10)};
  fit.measured = {measured([](int t) { return 12. * t; }, 0.5, 1)};
  const FitResult result = ringfilm::study::fit(fit, {0.4, 0.4}, model(fit.parameters, product));
  EXPECT_FALSE(result.parameters[0].identified);
  EXPECT_FALSE(result.parameters[1].identified);
  EXPECT_NEAR(result.parameters[0].value * result.parameters[1].value, 12, 0.1);  // deviation 0.5/sqrt(385)
  EXPECT_THAT(result.not_identified, ElementsAre("only the product speed x viscosity is determined"));
}

TEST(Fit, PriorOfOneFactorIdentifiesNeitherByTheMeasurement) {
  Fit fit;
  fit.parameters = {parameter("speed", 1, 10), parameter("viscosity", 1, 10)};
  fit.parameters[0].prior_mean = 4;
  fit.parameters[0].prior_deviation = 0.1;
  fit.measured = {measured([](int t) { return 12. * t; }, 0.5, 1)};
  const FitResult result = ringfilm::study::fit(fit, {0.4, 0.4}, model(fit.parameters, product));
  EXPECT_NEAR(result.parameters[0].value, 4, 0.01);
  EXPECT_NEAR(result.parameters[1].value, 3, 0.05);
  EXPECT_FALSE(result.parameters[1].identified);
}

TEST(Fit, OffsetIsFoundNextToTheParameters) {
  // The offset of 1 is that of its prior: the slope is determined, and intercept and offset share what is left.
  Fit fit = line_fit(0);
  fit.parameters = {parameter("a", 2.999, 3.001), parameter("b", 0, 4)};
  for (double& value : fit.measured[0].values) value += 1;
  fit.measured[0].offset = 5;
  const FitResult result = ringfilm::study::fit(fit, {0.5, 0.5}, model(fit.parameters, line));
  ASSERT_EQ(result.nuisances.size(), 1u);
  EXPECT_EQ(result.nuisances[0].name, "offset");
  EXPECT_NEAR(result.nuisances[0].value, 1, 0.02);  // drawn to 0 by (0.34/5)^2
}

TEST(Fit, WrongModelWithDiscrepancyDoesNotExcludeTheTruth) {
  // Measured 3 + 2 t + 0.08 t^2, fitted by a line with its intercept known: the slope at the origin is 2.
  Fit fit;
  fit.parameters = {parameter("a", 2.999, 3.001), parameter("b", 0, 4)};
  fit.measured = {measured([](int t) { return 3 + 2. * t + 0.08 * t * t; }, 0.05, 1)};
  const FitResult sure = ringfilm::study::fit(fit, {0.5, 0.5}, model(fit.parameters, line));
  EXPECT_GT(sure.parameters[1].low, 2);
  EXPECT_THAT(sure.notes, testing::Contains(HasSubstr("does not describe the measurement")));
  fit.measured[0].discrepancy = Discrepancy::kEstimated;
  const FitResult honest = ringfilm::study::fit(fit, {0.5, 0.5}, model(fit.parameters, line));
  EXPECT_GT(honest.series[0].discrepancy, 0.5);
  EXPECT_GT(honest.parameters[1].high - honest.parameters[1].low,
            5 * (sure.parameters[1].high - sure.parameters[1].low));
}

TEST(Fit, MinimumBeyondABoundIsNoted) {
  Fit fit = line_fit(0);
  fit.parameters[1] = parameter("b", 0, 1.5);
  const FitResult result = ringfilm::study::fit(fit, {0.5, 0.5}, model(fit.parameters, line));
  EXPECT_EQ(result.parameters[1].value, 1.5);
  EXPECT_TRUE(result.parameters[1].at_upper);
  EXPECT_THAT(result.notes, testing::Contains(HasSubstr("b is at its upper bound")));
}

TEST(Fit, ShiftOfACurveIsFound) {
  Fit fit;
  fit.parameters = {parameter("amplitude", 0, 10)};
  Measured curve;
  curve.quantity.name = "curve";
  curve.bases = {0};
  curve.angle_shift_deg = 3;
  constexpr double kDegree = 3.14159265358979 / 180;
  for (int angle = -360; angle < 360; angle += 5) {
    curve.crank_angle_deg.push_back(angle);
    curve.values.push_back(4 * std::sin((angle + 2) * kDegree));
    curve.deviations.push_back(0.1);
  }
  fit.measured = {curve};
  const Model sine = [&](const std::vector<std::vector<double>>& places) {
    std::vector<std::optional<ModelOutput>> outputs;
    for (const auto& at : places) {
      ModelOutput output{{{}}, {{}}, {}};
      for (int angle = -360; angle < 360; ++angle) {
        output.axes[0].push_back(angle);
        output.values[0].push_back(value_at(fit.parameters[0], at[0]) * std::sin(angle * kDegree));
      }
      outputs.push_back(output);
    }
    return outputs;
  };
  const FitResult result = ringfilm::study::fit(fit, {0.5}, sine);
  EXPECT_NEAR(result.parameters[0].value, 4, 0.02);
  EXPECT_NEAR(result.nuisances[0].value, 2, 0.05);  // drawn to 0 by its prior, and straight between samples
}

}  // namespace
