#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "../../traps/floating_point_traps.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/models/gas/gas.hpp"

namespace {

using boost::math::double_constants::degree;
using ringfilm::InputError;
using ringfilm::models::CrankSlider;
using ringfilm::models::wiebe_pressure;
using ringfilm::models::WiebeCycle;

WiebeCycle petrol() {
  return {.crank = {.crank_radius = 0.03975, .connecting_rod_length = 0.1381},
          .compression_ratio = 10.5,
          .peak_pressure = 62e5,
          .peak_angle_deg = 20,
          .burn_duration_deg = 60,
          .intake_pressure = 0.95e5,
          .exhaust_pressure = 1.05e5,
          .exhaust_valve_opening_deg = 130,
          .exhaust_valve_closing_deg = 375,
          .intake_valve_opening_deg = 345,
          .intake_valve_closing_deg = 590};
}

double volume(const WiebeCycle& c, double angle) {
  return c.crank.stroke() / (c.compression_ratio - 1) + c.crank.position(angle * degree);
}

TEST(WiebePressure, MeetsPeakAndAngleOrReportsWhyNot) {
  int met = 0;
  for (double ratio = 8; ratio <= 25; ratio += 2.5) {
    for (const double peak : {20e5, 40e5, 62e5, 110e5, 180e5, 250e5}) {
      for (const double angle : {3.0, 5.05, 8.0, 12.34, 20.0, 30.0}) {
        auto cycle = petrol();
        cycle.compression_ratio = ratio;
        cycle.peak_pressure = peak;
        cycle.peak_angle_deg = angle;
        const double motored = 0.95e5 * std::pow(ratio, 1.4);  // above what any compression gives
        try {
          const auto p = wiebe_pressure(cycle);
          EXPECT_NEAR(p.peak() / peak, 1, 1e-6);
          EXPECT_NEAR(p.peak_angle_deg(), angle, 0.01);
          ++met;
        } catch (const InputError& error) {
          EXPECT_LT(peak, 1.4 * motored) << error.what();
        }
      }
    }
  }
  EXPECT_GT(met, 200);  // of 288; the rest asks for less than compression alone gives
}

TEST(WiebePressure, IsPolytropicBeforeAndAfterCombustion) {
  const auto cycle = petrol();
  const auto p = wiebe_pressure(cycle);
  const auto exponent = [&](double a, double b) {
    return -std::log(p.pressure(b) / p.pressure(a)) / std::log(volume(cycle, b) / volume(cycle, a));
  };
  // 62 bar at 20 degrees ends its combustion of 60 degrees before 100. The angles are not samples: linear interpolation
  // over 0.1 degree adds 1e-5.
  EXPECT_NEAR(exponent(-120, -60), exponent(-90, -40), 1e-4);
  EXPECT_NEAR(exponent(100, 125), exponent(-120, -60), 1e-3);
  EXPECT_NEAR(p.pressure(590), 0.95e5, 1e-6);
}

TEST(WiebePressure, ReleasesHeatAtNoTimeBackwards) {
  const auto cycle = petrol();
  const auto p = wiebe_pressure(cycle);
  double last = 0;
  for (double a = -130; a <= 130; a += 1) {
    const double invariant = p.pressure(a) * std::pow(volume(cycle, a), 1.33);
    EXPECT_GE(invariant, last * (1 - 1e-4)) << a;  // linear interpolation between samples
    last = invariant;
  }
}

TEST(WiebePressure, IsPeriodicContinuousAndHoldsTheGasExchangePressures) {
  for (const double ratio : {8.0, 12.0, 18.0, 25.0}) {
    auto cycle = petrol();
    cycle.compression_ratio = ratio;
    cycle.peak_pressure = 160e5;
    cycle.peak_angle_deg = 10;
    const auto p = wiebe_pressure(cycle);
    for (int k = 0; k < 7200; ++k) {
      const double a = 0.1 * k, here = p.pressure(a), next = p.pressure(a + 0.1);
      // The steepest rise, combustion within 60 degrees or less, stays below a tenth of the peak per degree.
      EXPECT_LT(std::abs(next - here), 0.01 * cycle.peak_pressure) << a;
      EXPECT_GT(here, 0.9e5);
    }
    EXPECT_EQ(p.pressure(200), 1.05e5);
    EXPECT_EQ(p.pressure(340), 1.05e5);
    EXPECT_EQ(p.pressure(400), 0.95e5);
    EXPECT_EQ(p.pressure(580), 0.95e5);
    EXPECT_EQ(p.pressure(0), p.pressure(720));
  }
}

TEST(WiebePressure, TakesValveAnglesOfTheCycleBefore) {
  auto shifted = petrol();
  shifted.intake_valve_closing_deg -= 720;
  shifted.intake_valve_opening_deg -= 720;
  const auto one = wiebe_pressure(petrol()), other = wiebe_pressure(shifted);
  for (double a = 0; a < 720; a += 3.3) EXPECT_EQ(one.pressure(a), other.pressure(a));
}

TEST(WiebePressure, AllowsValvesWithoutOverlap) {
  auto cycle = petrol();
  cycle.exhaust_valve_closing_deg = 350;
  cycle.intake_valve_opening_deg = 372;
  const auto p = wiebe_pressure(cycle);
  EXPECT_EQ(p.pressure(349), 1.05e5);
  EXPECT_EQ(p.pressure(373), 0.95e5);
}

TEST(WiebePressure, RefusesWhatCannotBeAndReportsWhy) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  const auto refusal = [](const std::function<void(WiebeCycle&)>& change) {
    auto cycle = petrol();
    change(cycle);
    try {
      wiebe_pressure(cycle);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(contains(refusal([](auto& c) { c.peak_pressure = 10e5; }), "compression alone gives"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.peak_angle_deg = 0; }), "not after firing TDC"));
  EXPECT_TRUE(contains(refusal([](auto& c) {
                         c.burn_duration_deg = 400;
                         c.peak_angle_deg = 3;
                       }),
                       "intake valve closes"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.peak_angle_deg = 140; }), "gas.exhaust_valve_opening = 130 degree"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.exhaust_valve_opening_deg = 320; }), "no room"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.intake_valve_closing_deg = 370; }), "no room"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.exhaust_pressure = 65e5; }), "the pressure is higher, 65 bar, at"));
  EXPECT_TRUE(contains(refusal([](auto& c) {
                         c.compression_ratio = 1.1;
                         c.peak_pressure = 1.1e5;
                         c.exhaust_pressure = 2.34e5;
                       }),
                       "the pressure is higher, 2.34 bar, at"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.compression_ratio = 1; }), "gas.compression_ratio"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.burn_duration_deg = 0; }), "gas.burn_duration"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.intake_pressure = -1; }), "gas.intake_pressure"));
  EXPECT_TRUE(contains(refusal([](auto& c) { c.peak_pressure = NAN; }), "gas.peak_pressure"));
}

}  // namespace
