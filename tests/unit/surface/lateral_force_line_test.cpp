#include "ringfilm/surface/friction_loop/lateral_force_line.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "friction_examples.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LineFit, PassesThroughPointsOfALine) {
  std::vector<LinePoint> points;
  for (int i = 0; i < 6; ++i) points.push_back({1e-9 * i, 3e-3 + 2e6 * 1e-9 * i, 1e-10, 1e-4});
  const LineFit fit = fit_line(points, DeviationScale::kStated);
  EXPECT_NEAR(fit.slope, 2e6, 2e6 * 1e-12);
  EXPECT_NEAR(fit.offset, 3e-3, 1e-14);
  EXPECT_NEAR(fit.chi_squared, 0, 1e-18);
}

TEST(LineFit, HoldsFarOffLoadsAndRefusesSlopesThatAreNoNumber) {
  // Loads so far off zero that the square of their mean has no number, while the offset's error has one.
  std::vector<LinePoint> points{{1e160, 2, 0, 1}, {2e160, 3, 0, 1}, {3e160, 5, 0, 1}, {4e160, 5, 0, 1}};
  EXPECT_NEAR(fit_line(points, DeviationScale::kFromResiduals).offset_deviation, std::sqrt(0.35 * (1.0 / 4 + 6.25 / 5)),
              1e-13);
  for (LinePoint& p : points) p.y *= 1e200, p.y_deviation *= 1e200, p.x *= 1e-300;
  EXPECT_THROW(fit_line(points, DeviationScale::kFromResiduals), InputError);
}

/// Pearson's points with York's weights, the usual check of such fits (york2004, table II).
TEST(LineFit, AgreesWithTheFiguresOfYorkForPearsonsData) {
  const double x[] = {0.0, 0.9, 1.8, 2.6, 3.3, 4.4, 5.2, 6.1, 6.5, 7.4};
  const double y[] = {5.9, 5.4, 4.4, 4.6, 3.5, 3.7, 2.8, 2.8, 2.4, 1.5};
  const double wx[] = {1000, 1000, 500, 800, 200, 80, 60, 20, 1.8, 1};
  const double wy[] = {1, 1.8, 4, 8, 20, 20, 70, 70, 100, 500};
  std::vector<LinePoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({x[i], y[i], 1 / std::sqrt(wx[i]), 1 / std::sqrt(wy[i])});
  const LineFit fit = fit_line(points, DeviationScale::kStated);
  EXPECT_NEAR(fit.slope, -0.480533407, 1e-9);
  EXPECT_NEAR(fit.offset, 5.47991022, 1e-8);
  EXPECT_NEAR(fit.slope_deviation, 0.0579850090, 1e-9);
  EXPECT_NEAR(fit.offset_deviation, 0.294970735, 1e-8);
  EXPECT_NEAR(fit.chi_squared / 8, 1.48329415, 1e-8);
}

TEST(LineFit, IsTheClosedFormOfDemingWhereAllDeviationsAreEqual) {
  Normal normal(11);
  std::vector<LinePoint> points;
  double x_mean = 0, y_mean = 0;
  const int n = 12;
  for (int i = 0; i < n; ++i) {
    points.push_back({i + 0.3 * normal(), 2 + 1.7 * i + 0.6 * normal(), 0.3, 0.6});
    x_mean += points.back().x / n;
    y_mean += points.back().y / n;
  }
  double xx = 0, xy = 0, yy = 0;
  for (const LinePoint& p : points) {
    xx += (p.x - x_mean) * (p.x - x_mean);
    xy += (p.x - x_mean) * (p.y - y_mean);
    yy += (p.y - y_mean) * (p.y - y_mean);
  }
  const double delta = 4;  // (0.6/0.3)^2
  const double slope =
      (yy - delta * xx + std::sqrt((yy - delta * xx) * (yy - delta * xx) + 4 * delta * xy * xy)) / (2 * xy);
  const LineFit fit = fit_line(points, DeviationScale::kFromResiduals);
  EXPECT_NEAR(fit.slope, slope, 1e-11);
  EXPECT_NEAR(fit.offset, y_mean - slope * x_mean, 1e-10);
  // Only the ratio of the deviations counts.
  for (LinePoint& p : points) p.x_deviation *= 7, p.y_deviation *= 7;
  EXPECT_NEAR(fit_line(points, DeviationScale::kFromResiduals).slope_deviation, fit.slope_deviation, 1e-12);
}

TEST(LineFit, IsLeastSquaresWhereLoadsAreExact) {
  const std::vector<LinePoint> points{{1, 2, 0, 1}, {2, 3, 0, 1}, {3, 5, 0, 1}, {4, 5, 0, 1}};
  const LineFit fit = fit_line(points, DeviationScale::kFromResiduals);
  EXPECT_NEAR(fit.slope, 1.1, 1e-14);
  EXPECT_NEAR(fit.offset, 1.0, 1e-13);
  // Residuals -0.1, -0.2, 0.7, -0.4: squares 0.7 over 2 degrees of freedom, over 5 squares of x.
  EXPECT_NEAR(fit.slope_deviation, std::sqrt(0.35 / 5), 1e-14);
  EXPECT_NEAR(fit.offset_deviation, std::sqrt(0.35 * (1.0 / 4 + 6.25 / 5)), 1e-14);
  EXPECT_NEAR(fit.covariance, -2.5 * 0.35 / 5, 1e-14);
}

TEST(LineFit, KnowsStudentsFactors) {
  // Any table of the t distribution.
  EXPECT_NEAR(coverage_factor(0.95, 6), 2.447, 5e-4);
  EXPECT_NEAR(coverage_factor(0.95, 1), 12.706, 5e-4);
  EXPECT_NEAR(coverage_factor(0.95, kInfinity), 1.959964, 1e-6);
}

TEST(LineFit, HasNoIntervalOfOtherConfidence) {
  for (const double confidence : {-0.1, 0.0, 1.0, 1.5}) {
    EXPECT_THROW(coverage_factor(confidence, 6), ringfilm::InputError) << confidence;
  }
  EXPECT_THROW(coverage_factor(0.95, 0), ringfilm::InputError);
}

struct Coverage {
  double slope, offset;
};

/// Share of the 95 % intervals that hold the true line, with errors in both directions.
Coverage coverage(DeviationScale scale, double stated_over_true) {
  Normal normal(20261);
  const int trials = 2000;
  int slopes = 0, offsets = 0;
  for (int t = 0; t < trials; ++t) {
    std::vector<LinePoint> points;
    for (int i = 1; i <= 8; ++i) {
      const double x_deviation = 0.05 + 0.01 * i, y_deviation = 0.02;
      points.push_back({i + x_deviation * normal(), 0.3 + 0.25 * i + y_deviation * normal(),
                        x_deviation * stated_over_true, y_deviation * stated_over_true});
    }
    const LineFit fit = fit_line(points, scale);
    slopes += std::abs(fit.slope - 0.25) <= fit.slope_half_width(0.95);
    offsets += std::abs(fit.offset - 0.3) <= fit.offset_half_width(0.95);
  }
  return {static_cast<double>(slopes) / trials, static_cast<double>(offsets) / trials};
}

/// 2000 trials report a share of 95 % to 0.5 % (one sigma).
TEST(LineFit, IntervalsHoldTheTruthAsOftenAsStated) {
  for (const Coverage c : {coverage(DeviationScale::kStated, 1), coverage(DeviationScale::kFromResiduals, 1),
                           coverage(DeviationScale::kFromResiduals, 5)}) {
    EXPECT_GT(c.slope, 0.93);
    EXPECT_LT(c.slope, 0.97);
    EXPECT_GT(c.offset, 0.93);
    EXPECT_LT(c.offset, 0.97);
  }
  // The test can fail: deviations stated at half their size do not hold the truth.
  EXPECT_LT(coverage(DeviationScale::kStated, 0.5).slope, 0.8);
}

TEST(LineFit, ReportsThatStatedDeviationsAreTooSmall) {
  Normal normal(4);
  std::vector<LinePoint> points;
  for (int i = 0; i < 10; ++i) points.push_back({1.0 * i, i + 0.5 * normal(), 0, 0.1});
  EXPECT_LT(fit_line(points, DeviationScale::kStated).chi_squared_probability, 0.01);
}

TEST(LineFit, RefusesWhatFixesNoLine) {
  const auto line = [](std::vector<LinePoint> points) { return fit_line(points, DeviationScale::kStated); };
  EXPECT_THROW(line({{1, 1, 0, 1}, {2, 2, 0, 1}}), InputError);
  EXPECT_THROW(line({{1, 1, 0, 1}, {1, 2, 0, 1}, {1, 3, 0, 1}}), InputError);
  EXPECT_THROW(line({{1, 1, 0, 1}, {2, 2, 0, 1}, {3, std::nan(""), 0, 1}}), InputError);
  EXPECT_THROW(line({{1, 1, 0, 1}, {2, 2, 0, 1}, {3, 3, 0, 0}}), InputError);
  EXPECT_THROW(line({{1, 1, 0, 1}, {2, 2, 0, 1}, {3, 3, -1, 1}}), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
