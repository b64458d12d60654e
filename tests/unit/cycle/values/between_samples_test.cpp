#include "ringfilm/cycle/between_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace ringfilm::cycle {
namespace {

using Curve = std::function<double(double)>;

/// Samples at steps of unequal lengths, dead centres among them.
std::vector<double> unequal_angles() {
  std::vector<double> angles;
  for (int stroke = 0; stroke < 4; ++stroke) {
    for (const double within : {0.0, 1.0, 3.0, 7.0, 20.0, 50.0, 60.0, 100.0, 150.0, 172.0}) {
      angles.push_back(180 * stroke + within);
    }
  }
  return angles;
}

std::vector<double> values(const std::vector<double>& angles, const Curve& curve) {
  std::vector<double> v;
  for (const double angle : angles) v.push_back(curve(angle));
  return v;
}

auto of(const std::vector<double>& v) {
  return [&v](std::size_t k) { return v[k]; };
}

/// Angle from the middle of its stroke: a parabola in it has kinks at the dead centres.
double from_middle(double angle) { return std::fmod(angle, 180) - 90; }

TEST(BetweenSamples, ParabolasOfStrokesAreExact) {
  const std::vector<double> angles = unequal_angles();
  const BetweenSamples between(angles);
  const Curve curve = [](double angle) { return 5 + from_middle(angle) * from_middle(angle) / 1000; };
  const std::vector<double> v = values(angles, curve);
  EXPECT_NEAR(between.mean(of(v)), 5 + 90.0 * 90 / 3 / 1000, 1e-12);
  for (const double angle : {0.5, 90.0, 179.0, 300.0, 533.3, 719.9}) {
    EXPECT_NEAR(between.at(angle, of(v)), curve(angle), 1e-12) << angle;
  }
  for (int stroke = 0; stroke < 4; ++stroke) {
    double sum = 0;
    for (std::size_t k = 0; k < v.size(); ++k) sum += between.weights(stroke)[k] * v[k];
    EXPECT_NEAR(sum, 180 * (5 + 90.0 * 90 / 3 / 1000), 1e-9) << stroke;
  }
  const auto negative = [&](std::size_t k) { return -v[k]; };
  const auto lowest = between.largest_near(7, negative);  // next to the vertex at 90 degree
  EXPECT_NEAR(-lowest.value, 5, 1e-12);
  EXPECT_NEAR(lowest.angle_deg, 90, 1e-6);
}

TEST(BetweenSamples, AKinkAtADeadCentreIsItsOwnPeak) {
  const std::vector<double> angles = unequal_angles();
  const BetweenSamples between(angles);
  const std::vector<double> v =
      values(angles, [](double angle) { return std::abs(std::cos(angle * std::numbers::pi / 360)); });
  const auto peak = between.largest_near(0, of(v));
  EXPECT_EQ(peak.value, 1);
  EXPECT_EQ(peak.angle_deg, 0);
}

// Of smooth curves the mean is of fourth order and more, that of straight lines of second.
TEST(BetweenSamples, MeansAreOfFourthOrder) {
  const auto error = [](int n) {
    std::vector<double> angles;
    for (int k = 0; k < n; ++k) angles.push_back(720.0 * k / n);
    const Curve curve = [](double angle) {
      return std::exp(std::sin(std::fmod(angle, 180) * std::numbers::pi / 180));  // kinks at the dead centres
    };
    const std::vector<double> v = values(angles, curve);
    constexpr double kMean = 1.9763090636898988;  // I_0(1) + L_0(1), modified functions of Bessel and Struve
    return std::abs(BetweenSamples(angles).mean(of(v)) - kMean);
  };
  EXPECT_GT(error(18 * 4) / error(36 * 4), 12);
}

// The parabola through the second sample falls steeply on, where the film has come to rest.
TEST(BetweenSamples, CurvesDoNotOvershootNextToAJump) {
  std::vector<double> angles;
  for (int k = 0; k < 72; ++k) angles.push_back(10 * k);
  std::vector<double> film(72, 6.0);
  film[6] = film[7] = 0.3;
  film[8] = 0.35;
  const BetweenSamples between(angles);
  const auto lowest = between.largest_near(6, [&](std::size_t k) { return -film[k]; });
  EXPECT_GT(-lowest.value, 0.27);
  EXPECT_LE(-lowest.value, 0.3);
}

// A ring that lifts off behind the dead centre: the parabola through its first samples falls steeply at its beginning.
TEST(BetweenSamples, CurvesDoNotOvershootBetweenADeadCentreAndAJump) {
  for (const double mirror : {1.0, -1.0}) {  // behind the dead centre and before it
    std::vector<double> angles, film;
    for (int k = 0; k < 72; ++k) angles.push_back(10 * k);
    for (int k = 0; k < 72; ++k) film.push_back(60);
    const auto at = [&](int k) -> double& { return film[static_cast<std::size_t>(18 + mirror * k)]; };
    at(0) = 0.33;
    at(1) = 0.32;
    at(2) = 14;
    at(-1) = 0.34;
    at(-2) = 0.35;
    const BetweenSamples between(angles);
    for (const int k : {17, 18, 19}) {
      const auto lowest = between.largest_near(k, [&](std::size_t i) { return -film[i]; });
      EXPECT_GT(-lowest.value, 0.31) << mirror << ", " << k;
    }
  }
}

TEST(BetweenSamples, VeryUnequalStepsAreNotJoined) {
  std::vector<double> angles;
  for (int k = 0; k < 72; ++k) angles.push_back(10 * k);
  angles.insert(angles.begin() + 7, 60.1);  // after 60
  std::vector<double> v(angles.size(), 1.0);
  v[7] = 1 + 1e-4;
  // The noise of the sample next to it counts by the length of its steps, not by the slope that it makes.
  EXPECT_NEAR(BetweenSamples(angles).mean(of(v)), 1 + 1e-4 * 0.5 * 10 / 720, 2e-7);
}

TEST(BetweenSamples, StepsThatHoldADeadCentreAreStraight) {
  const BetweenSamples between({100, 300, 500, 700});
  const std::vector<double> v = {1, 3, 2, 5};
  EXPECT_DOUBLE_EQ(between.mean(of(v)), (200 * 2 + 200 * 2.5 + 200 * 3.5 + 120 * 3) / 720.0);
  EXPECT_DOUBLE_EQ(between.at(200, of(v)), 2);
  EXPECT_DOUBLE_EQ(between.at(40, of(v)), 3);
}

}  // namespace
}  // namespace ringfilm::cycle
