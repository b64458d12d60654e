#include "ringfilm/surface/face/face_spline.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "friction_examples.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

std::vector<double> grid(int n, double step) {
  std::vector<double> x(n);
  for (int i = 0; i < n; ++i) x[i] = step * i;
  return x;
}

TEST(SmoothingSpline, LetsHalfOfTheCutOffWavelengthThrough) {
  const std::vector<double> x = grid(4001, 1e-6);
  for (const double wavelength : {50e-6, 100e-6, 200e-6}) {
    std::vector<double> wave(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) wave[i] = 1e-6 * std::cos(2 * std::numbers::pi * x[i] / wavelength);
    const SmoothingSpline spline(x, wave, 100e-6);
    // Ten wavelengths from either end the ends are forgotten; the grid adds (step/wavelength)^2.
    EXPECT_NEAR(spline.height_m()[2000] / 1e-6, 1 / (1 + std::pow(100e-6 / wavelength, 4)), 2e-3) << wavelength;
  }
}

TEST(SmoothingSpline, KeepsStraightLinesAndContinuesStraight) {
  std::vector<double> x{0, 1e-6, 1.5e-6, 4e-6, 4.2e-6, 6e-6, 7e-6, 9e-6, 10e-6}, line(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) line[i] = 3e-6 - 0.2 * x[i];
  const SmoothingSpline spline(x, line, 8e-6);
  for (const double at : {-2e-6, 0.3e-6, 5e-6, 9.9e-6, 12e-6}) EXPECT_NEAR(spline.height_m(at), 3e-6 - 0.2 * at, 1e-18);
}

TEST(SmoothingSpline, IsContinuousInItsSlope) {
  Normal normal(2);
  const std::vector<double> x = grid(60, 1e-6);
  std::vector<double> noise(x.size());
  for (double& v : noise) v = 1e-6 * normal();
  const SmoothingSpline spline(x, noise, 10e-6);
  const double d = 1e-11;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double left = (spline.height_m(x[i]) - spline.height_m(x[i] - d)) / d;
    const double right = (spline.height_m(x[i] + d) - spline.height_m(x[i])) / d;
    // The curvature of about 0.1 um over (1.6 um)^2 times d is 4e-7.
    EXPECT_NEAR(left, right, 5e-6) << i;
  }
}

TEST(SmoothingSpline, EstimatesItsOwnError) {
  const std::vector<double> x = grid(801, 1e-6);
  double squares_inside = 0, squares_end = 0;
  const int trials = 400;
  for (int t = 0; t < trials; ++t) {
    Normal normal(500 + t);
    std::vector<double> noise(x.size());
    for (double& v : noise) v = normal();
    const SmoothingSpline spline(x, noise, 80e-6);
    squares_inside += std::pow(spline.height_m()[400], 2) / trials;
    squares_end += std::pow(spline.height_m()[0], 2) / trials;
  }
  const SmoothingSpline spline(x, x, 80e-6);
  // A standard deviation from 400 values has an error of 3.5 %; 4 sigma.
  EXPECT_NEAR(std::sqrt(squares_inside), spline.error_share(400e-6), 0.14 * spline.error_share(400e-6));
  EXPECT_NEAR(std::sqrt(squares_end), spline.error_share(0), 0.25 * spline.error_share(0));
}

TEST(SmoothingSpline, RefusesWhatItCannotSmooth) {
  const std::vector<double> x = grid(50, 1e-6);
  EXPECT_THROW(SmoothingSpline(x, x, 3e-6), InputError);
  EXPECT_THROW(SmoothingSpline(x, x, 60e-6), InputError);
  EXPECT_THROW(SmoothingSpline(grid(5, 1e-6), grid(5, 1e-6), 4e-6), InputError);
  EXPECT_THROW(SmoothingSpline(x, grid(49, 1), 10e-6), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
