#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/ring.hpp"

namespace {

using namespace ringfilm::models;

std::vector<CrankSlider> all_cranks() { return {{0.03975, 0.1381}, {0.072, 0.2415}, {0.05, 0.0501}, {0.04, 40.0}}; }

TEST(MotionLaws, VelocityIsMinusTheDerivativeOfPosition) {
  for (const auto& crank : all_cranks()) {
    for (double phi = -7; phi < 7; phi += 0.0713) {
      // Central difference over 2e-5 rad: truncation 1e-10 of the stroke, times 100 where the rod is hardly longer than
      // the crank; rounding 1e-11.
      const double step = 1e-5;
      const double slope = (crank.position(phi + step) - crank.position(phi - step)) / (2 * step);
      EXPECT_NEAR(crank.velocity(phi, 1), -slope, 1e-7 * crank.stroke()) << phi;
    }
  }
}

TEST(MotionLaws, VelocityIsOddAboutTdcAndProportionalToSpeed) {
  for (const auto& crank : all_cranks()) {
    for (double phi = 0; phi < 4; phi += 0.1) {
      EXPECT_DOUBLE_EQ(crank.velocity(-phi, 10), -crank.velocity(phi, 10));
      EXPECT_DOUBLE_EQ(crank.velocity(phi, 30), 3 * crank.velocity(phi, 10));
      EXPECT_DOUBLE_EQ(crank.position(-phi), crank.position(phi));
    }
  }
}

TEST(MotionLaws, PositionStaysWithinTheStroke) {
  for (const auto& crank : all_cranks()) {
    for (double phi = 0; phi < 7; phi += 0.01) {
      EXPECT_GE(crank.position(phi), 0);
      EXPECT_LE(crank.position(phi), crank.stroke() * (1 + 1e-15));
    }
  }
}

std::vector<CyclePressure> all_gases() {
  std::vector<double> angle, pressure;
  for (int k = -143; k <= 123; ++k) {
    angle.push_back(k);
    pressure.push_back(1.5e5 + 150e5 / (1 + std::pow((k - 9) / 30.0, 2)));
  }
  return {CyclePressure(1e5), CyclePressure({0, 20, 100, 400}, {20e5, 62e5, 8e5, 1e5}),
          join_partial_trace(angle, pressure, 1.6e5, 2e5),
          wiebe_pressure({.crank = {0.03975, 0.1381},
                          .compression_ratio = 10.5,
                          .peak_pressure = 62e5,
                          .peak_angle_deg = 20,
                          .burn_duration_deg = 60,
                          .intake_pressure = 0.95e5,
                          .exhaust_pressure = 1.05e5,
                          .exhaust_valve_opening_deg = 130,
                          .exhaust_valve_closing_deg = 375,
                          .intake_valve_opening_deg = 345,
                          .intake_valve_closing_deg = 590})};
}

TEST(GasLaws, EveryPressureIsPeriodicPositiveAndBelowItsPeak) {
  for (const auto& gas : all_gases()) {
    for (double angle = 0; angle < 720; angle += 0.37) {
      const double p = gas.pressure(angle);
      EXPECT_GT(p, 0);
      EXPECT_LE(p, gas.peak());
      // The angle loses digits of 7200 degrees, times slopes of up to 10 bar/degree.
      for (const int cycles : {-10, -1, 1, 10}) EXPECT_NEAR(gas.pressure(angle + 720 * cycles), p, 1e-5);
    }
    EXPECT_EQ(gas.pressure(gas.peak_angle_deg()), gas.peak());
  }
}

TEST(GasLaws, EveryPressureIsContinuous) {
  for (const auto& gas : all_gases()) {
    for (double angle = -180; angle < 720; angle += 0.25) {
      EXPECT_NEAR(gas.pressure(angle), gas.pressure(angle + 1e-7), 1e-6 * gas.peak()) << angle;
    }
  }
}

TEST(FaceLaws, TurningMirrorsEveryForm) {
  const double b = 1.5e-3;
  const std::vector<RingFace> faces{RingFace::polynomial({3, -2, 4, 1}, 1e-3, 1e-6, b),
                                    RingFace::parabola(9e-6, 0.7, b),
                                    RingFace::points({0, 2e-4, 9e-4, b}, {5e-6, 1e-6, 0, 7e-6}, b)};
  for (const auto& face : faces) {
    const auto turned = face.turned();
    EXPECT_EQ(turned.face_width(), b);
    EXPECT_NEAR(turned.minimum().height, face.minimum().height, 1e-18);  // rounding of b - x
    EXPECT_NEAR(turned.minimum().x, b - face.minimum().x, 1e-10);        // half the digits of x
    for (double x = 0; x <= b; x += b / 64) EXPECT_NEAR(turned.height(b - x), face.height(x), 1e-18);
  }
}

TEST(FaceLaws, EveryHeightScalesWithItsUnit) {
  const double b = 1.5e-3;
  const auto um = RingFace::polynomial({3, -2, 4, 1}, 1e-3, 1e-6, b),
             nm = RingFace::polynomial({3, -2, 4, 1}, 1e-3, 1e-9, b);
  for (double x = 0; x <= b; x += b / 64) EXPECT_NEAR(nm.height(x) * 1e3, um.height(x), 1e-20);
}

TEST(TensionLaws, ForceAndPressureAreInverse) {
  for (const double bore : {0.06, 0.089, 0.35}) {
    for (const double width : {0.8e-3, 3e-3}) {
      const double p_e = elastic_pressure_from_tangential_force(11, width, bore);
      EXPECT_DOUBLE_EQ(tangential_force_from_elastic_pressure(p_e, width, bore), 11);
    }
  }
}

}  // namespace
