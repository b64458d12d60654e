#include "ringfilm/models/crank_slider.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace {

using boost::math::double_constants::degree;
using boost::math::double_constants::pi;
using ringfilm::models::CrankSlider;

constexpr CrankSlider kV12{.crank_radius = 0.03975, .connecting_rod_length = 0.1381};
constexpr double k1500Rpm = 1500 * 2 * pi / 60;

TEST(CrankSlider, RestsAtBothDeadCentres) {
  // sin(pi) in floating point is 1e-16; times a velocity of order 10 m/s.
  EXPECT_EQ(kV12.velocity(0, k1500Rpm), 0);
  EXPECT_NEAR(kV12.velocity(pi, k1500Rpm), 0, 1e-14);
  EXPECT_EQ(kV12.position(0), 0);
  EXPECT_NEAR(kV12.position(pi), kV12.stroke(), 1e-16);
}

TEST(CrankSlider, AgreesWithTheIndependentModel) {
  // shared/reference/new_1500_reynolds.csv at 1 degree, ten digits given.
  EXPECT_NEAR(kV12.velocity(1 * degree, k1500Rpm), -0.1403327255, 1e-10);
}

TEST(CrankSlider, MovesDownInThePowerStrokeAndUpInTheExhaustStroke) {
  EXPECT_LT(kV12.velocity(90 * degree, k1500Rpm), 0);
  EXPECT_GT(kV12.velocity(270 * degree, k1500Rpm), 0);
}

TEST(CrankSlider, PositionIsTheTriangleOfCrankAndRod) {
  // Law of cosines for the distance d of piston pin and crank axis: l^2 = r^2 + d^2 - 2 r d cos(phi).
  for (double phi = 0; phi < 2 * pi; phi += 0.1) {
    const double r = kV12.crank_radius, l = kV12.connecting_rod_length, d = r + l - kV12.position(phi);
    EXPECT_NEAR(r * r + d * d - 2 * r * d * std::cos(phi), l * l, 1e-16 * 4);  // four terms of 0.03 m2
  }
}

TEST(CrankSlider, PositionNearTdcKeepsItsDigits) {
  // Series: r (1 + r/l) phi^2/2, next term of relative size phi^2.
  const double phi = 1e-7, r = kV12.crank_radius, l = kV12.connecting_rod_length;
  EXPECT_NEAR(kV12.position(phi) / (r * (1 + r / l) * phi * phi / 2), 1, 1e-13);
}

TEST(CrankSlider, VelocityIntegratesToTheStroke) {
  const auto down = [](double phi) { return -kV12.velocity(phi, 1); };
  const double travelled = boost::math::quadrature::gauss_kronrod<double, 61>::integrate(down, 0, pi);
  EXPECT_NEAR(travelled, kV12.stroke(), 1e-14);  // an analytic integrand: the rule is exact to rounding
}

TEST(CrankSlider, AccelerationIsTheSlopeOfTheVelocity) {
  const double step = 1e-5;
  for (double phi = 0; phi < 4 * pi; phi += 0.1) {
    const double slope = (kV12.velocity(phi + step, k1500Rpm) - kV12.velocity(phi - step, k1500Rpm)) / (2 * step);
    EXPECT_NEAR(kV12.acceleration(phi, k1500Rpm), slope * k1500Rpm, 1e-5) << phi;  // of 1000 m/s2
  }
  EXPECT_LT(kV12.acceleration(0, k1500Rpm), 0);  // from TDC the piston goes down
}

TEST(CrankSlider, BecomesASineWithAnEndlessRod) {
  const CrankSlider slider{.crank_radius = 0.04, .connecting_rod_length = 4e7};
  // The next term is r/l = 1e-9 of the first.
  for (double phi = 0.1; phi < 6; phi += 0.7) EXPECT_NEAR(slider.velocity(phi, 1), -0.04 * std::sin(phi), 1e-10);
}

}  // namespace
