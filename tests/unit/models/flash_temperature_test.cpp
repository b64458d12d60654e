#include "ringfilm/models/flash_temperature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

/// Against the sum of moving line sources (Carslaw and Jaeger), by plain quadrature.
namespace ringfilm::models {
namespace {

constexpr HeatedSolid kIron{55, 7200, 490};
constexpr double kWidth = 1.2e-3, kFlux = 3e6;

/// Simpson's rule on ln x and the like is the caller's substitution.
template <class Function>
double integral(const Function& f, double a, double b, int n) {
  const double step = (b - a) / n;
  double sum = f(a) + f(b);
  for (int k = 1; k < n; ++k) sum += (k % 2 == 1 ? 4 : 2) * f(a + k * step);
  return sum * step / 3;
}

/// e^(-s) K_0(|s|) by the integral of exp(-s - |s| cosh t).
double kernel(double s) {
  const double end = std::acosh(1 + 50 / std::abs(s));
  return integral([s](double t) { return std::exp(-s - std::abs(s) * std::cosh(t)); }, 0, end, 400);
}

/// Mean rise under the band: a line of heat at distance z raises the surface of the half-space by
/// Q/(pi k) e^(-U z/(2 kappa)) K_0(U |z|/(2 kappa)), and each z occurs (width - |z|) times.
double mean_of_line_sources(double speed) {
  const double kappa = kIron.conductivity / (kIron.density * kIron.specific_heat);
  const double scale = speed / (2 * kappa);
  const auto of_distance = [&](double ln_z) {
    const double z = std::exp(ln_z);
    return z * (kWidth - z) * (kernel(scale * z) + kernel(-scale * z));
  };
  return kFlux / (std::numbers::pi * kIron.conductivity * kWidth) *
         integral(of_distance, std::log(1e-8 * kWidth), std::log(kWidth), 1000);
}

TEST(FlashTemperature, IsThatOfMovingLineSources) {
  for (const double speed : {0.002, 0.02, 0.2, 1.0, 2.7}) {
    const double rise = flash_temperature(kFlux, kWidth, speed, kIron);
    EXPECT_NEAR(rise / mean_of_line_sources(speed), 1, 1e-5) << speed;
  }
}

TEST(FlashTemperature, OfAFastBandIsThatOfHeatFlowingInwards) {
  // Each place is heated for z/U: T = 2 q sqrt(kappa t/pi)/k, in the mean over the band 2/3 of the end.
  const double kappa = kIron.conductivity / (kIron.density * kIron.specific_heat), speed = 2000;
  const double end = 2 * kFlux / kIron.conductivity * std::sqrt(kappa * kWidth / (std::numbers::pi * speed));
  EXPECT_NEAR(flash_temperature(kFlux, kWidth, speed, kIron) / (2 * end / 3), 1, 1e-4);
}

TEST(FlashTemperature, HasNoStepWhereItsFormChanges) {
  const double kappa = kIron.conductivity / (kIron.density * kIron.specific_heat);
  for (const double x : {1e-3, 30.0}) {
    const double speed = 2 * kappa * x / kWidth;
    const double below = flash_temperature(kFlux, kWidth, speed * (1 - 1e-9), kIron);
    EXPECT_NEAR(flash_temperature(kFlux, kWidth, speed * (1 + 1e-9), kIron) / below, 1, 1e-6) << x;
  }
}

TEST(FlashTemperature, IsNothingAtRest) { EXPECT_EQ(flash_temperature(0, kWidth, 0, kIron), 0); }

}  // namespace
}  // namespace ringfilm::models
