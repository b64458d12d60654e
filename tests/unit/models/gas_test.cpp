#include "ringfilm/models/gas/gas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../../traps/floating_point_traps.hpp"
#include "ringfilm/base/error.hpp"

namespace {

using ringfilm::InputError;
using ringfilm::models::covers_cycle;
using ringfilm::models::CyclePressure;
using ringfilm::models::join_partial_trace;

/// A bump over firing TDC, positive everywhere.
double bump(double angle) { return 1e5 * (1 + 60 * std::exp(-std::pow((angle - 15) / 40, 2))); }

struct Trace {
  std::vector<double> angle, pressure;
};
Trace sampled(double from, double to, double step) {
  Trace t;
  for (int k = 0; from + k * step <= to + 1e-9; ++k) {
    t.angle.push_back(from + k * step);
    t.pressure.push_back(bump(t.angle.back()));
  }
  return t;
}

TEST(CyclePressure, ConstantIsTheSameAtEveryAngle) {
  const CyclePressure p(1.5e5);
  for (const double angle : {-1e4, -0.5, 0.0, 719.9, 1e6}) EXPECT_EQ(p.pressure(angle), 1.5e5);
  EXPECT_EQ(p.peak(), 1.5e5);
}

TEST(CyclePressure, IsLinearBetweenSamplesAndAcrossTheSeam) {
  const CyclePressure p({-180, 0, 300}, {1e5, 3e5, 2e5});
  EXPECT_NEAR(p.pressure(-90), 2e5, 1e-9);
  EXPECT_NEAR(p.pressure(150), 2.5e5, 1e-9);
  EXPECT_NEAR(p.pressure(420), 1.5e5, 1e-9);  // half way from 300 to 540
  EXPECT_NEAR(p.pressure(420 - 720), 1.5e5, 1e-9);
}

TEST(CyclePressure, DoesNotDependOnWhereItsSamplesStart) {
  const std::vector<double> value{2e5, 9e5, 4e5, 1e5};
  const CyclePressure from_zero({0, 30, 200, 500}, value);
  const CyclePressure from_minus({-220, 0, 30, 200}, {1e5, 2e5, 9e5, 4e5});
  const CyclePressure later({720, 750, 920, 1220}, value);
  for (double angle = -800; angle < 1600; angle += 3.7) {
    EXPECT_NEAR(from_minus.pressure(angle), from_zero.pressure(angle), 1e-7);  // rounding of angles times 2e4 Pa/degree
    EXPECT_NEAR(later.pressure(angle), from_zero.pressure(angle), 1e-7);
  }
}

TEST(CyclePressure, LastSampleMayRepeatTheFirst) {
  const CyclePressure repeated({0, 30, 500, 720}, {2e5, 9e5, 4e5, 2e5}), once({0, 30, 500}, {2e5, 9e5, 4e5});
  for (double angle = 0; angle < 720; angle += 7) EXPECT_EQ(repeated.pressure(angle), once.pressure(angle));
  const CyclePressure unequal({0, 360, 720}, {2e5, 9e5, 4e5});
  EXPECT_EQ(unequal.pressure(0), 3e5);  // the mean of two readings of one angle
  EXPECT_NEAR(unequal.pressure(-1e-9), 3e5, 1e-3);
}

TEST(CyclePressure, PeakLiesInZeroTo720) {
  const CyclePressure p({-180, -5, 300}, {1e5, 3e5, 2e5});
  EXPECT_EQ(p.peak(), 3e5);
  EXPECT_EQ(p.peak_angle_deg(), 715);
  EXPECT_EQ(p.pressure(p.peak_angle_deg()), p.peak());
}

TEST(CyclePressure, RefusesWhatIsNotATrace) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  EXPECT_THROW(CyclePressure({}, {}), InputError);
  EXPECT_THROW(CyclePressure({0, 1}, {1e5}), InputError);
  EXPECT_THROW(CyclePressure({0, 1, 1}, {1e5, 1e5, 1e5}), InputError);
  EXPECT_THROW(CyclePressure({0, 2, 1}, {1e5, 1e5, 1e5}), InputError);
  EXPECT_THROW(CyclePressure({0, 721}, {1e5, 1e5}), InputError);
  EXPECT_THROW(CyclePressure({0, NAN}, {1e5, 1e5}), InputError);
  EXPECT_THROW(CyclePressure({0, 1}, {1e5, INFINITY}), InputError);
  EXPECT_THROW(CyclePressure(0.0), InputError);
}

TEST(CyclePressure, ReportsWhichSampleIsNegativeAndHintsAtGauge) {
  try {
    CyclePressure({0, 10, 20}, {1e5, -0.05e5, 1e5});
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("-0.05 bar at 10 degree"), std::string::npos) << text;
    EXPECT_NE(text.find("gas.pressure_reference"), std::string::npos) << text;
  }
}

TEST(CoversCycle, LooksAtTheSeamToo) {
  EXPECT_TRUE(covers_cycle(sampled(0, 719, 1).angle));
  EXPECT_TRUE(covers_cycle(sampled(-360, 360, 10).angle));
  EXPECT_TRUE(covers_cycle(sampled(-180, 539.9, 0.1).angle));
  EXPECT_FALSE(covers_cycle(sampled(0, 700, 1).angle));
  EXPECT_FALSE(covers_cycle(sampled(-143, 123, 1).angle));
  EXPECT_FALSE(covers_cycle({}));
}

TEST(PartialTrace, KeepsItsSamplesAndTakesTheGivenPressures) {
  const auto [angle, pressure] = sampled(-143, 123, 1);
  const auto joined = join_partial_trace(angle, pressure, 1.6e5, 1.9e5);
  for (std::size_t k = 0; k < angle.size(); ++k) EXPECT_NEAR(joined.pressure(angle[k]), pressure[k], 1e-6);
  for (double a = 180; a <= 340; a += 1) EXPECT_EQ(joined.pressure(a), 1.9e5) << a;
  for (double a = 380; a <= 537; a += 1) EXPECT_EQ(joined.pressure(a), 1.6e5) << a;
  EXPECT_NEAR(joined.pressure(360), 1.75e5, 1);  // the blend is symmetric
}

TEST(PartialTrace, IsJoinedWithoutJumpsAndWithoutOvershoot) {
  for (const double first : {-300.0, -180.0, -143.0, -60.0}) {
    for (const double last : {60.0, 123.0, 170.0, 220.0, 300.0}) {
      const auto [angle, pressure] = sampled(first, last, 0.5);
      const auto joined = join_partial_trace(angle, pressure, 0.9e5, 1.3e5);
      double before = joined.pressure(last);
      const double low = std::min({0.9e5, pressure.front(), pressure.back()});
      const double high = std::max({1.3e5, pressure.front(), pressure.back()});
      for (double a = last; a <= first + 720; a += 0.1) {
        const double p = joined.pressure(a);
        // Over 20 degrees or more a monotone cubic is nowhere steeper than 3 times its secant.
        EXPECT_LE(std::abs(p - before), 3.01 * (high - low) / 20 * 0.1 + 1) << first << " " << last << " " << a;
        EXPECT_GE(p, low - 1e-6);
        EXPECT_LE(p, high + 1e-6);
        before = p;
      }
    }
  }
}

TEST(PartialTrace, LeavesItsEndsWithTheirSlope) {
  // An expansion as in an engine: 4.9 bar at 123 degrees and less than three times the secant to 2 bar at 180 degrees.
  const auto expansion = [](double angle) { return 62e5 * std::pow(1 + std::pow(angle / 50, 2), -1.3); };
  Trace trace;
  for (int a = -123; a <= 123; ++a) {
    trace.angle.push_back(a);
    trace.pressure.push_back(expansion(a));
  }
  const auto joined = join_partial_trace(trace.angle, trace.pressure, 2e5, 2e5);
  const auto step = [&](double from) { return joined.pressure(from + 1) - joined.pressure(from); };
  EXPECT_NEAR(step(123) / step(122), 1, 0.1);  // the curvature of trace and blend over two degrees
  EXPECT_NEAR(step(-124) / step(-123), 1, 0.1);
}

TEST(PartialTrace, MayBeCountedFromAnotherCycle) {
  const auto [angle, pressure] = sampled(-143, 123, 1);
  std::vector<double> later = angle;
  for (double& a : later) a += 720;
  const auto one = join_partial_trace(angle, pressure, 1e5, 1e5), other = join_partial_trace(later, pressure, 1e5, 1e5);
  for (double a = 0; a < 720; a += 1.7) EXPECT_EQ(one.pressure(a), other.pressure(a));
}

TEST(PartialTrace, OfOneRevolutionFromFiringIsRefusedAsHalfAFourStrokeCycle) {
  const auto refusal = [](double first) -> std::string {
    try {
      join_partial_trace({first, first + 180, first + 360}, {1e5, 2e5, 1e5}, 1e5, 1e5);
    } catch (const ringfilm::InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string expected = "one revolution; a four-stroke cycle of 720 degrees is expected";
  EXPECT_NE(refusal(0).find(expected), std::string::npos);
  EXPECT_NE(refusal(20).find(expected), std::string::npos);
  EXPECT_EQ(refusal(-180), "");  // the closed part of a cycle
}

TEST(PartialTrace, WithoutSpaceOrWithoutTdcIsRefused) {
  const auto refused = [](double first, double last) {
    const auto [angle, pressure] = sampled(first, last, 1);
    EXPECT_THROW(join_partial_trace(angle, pressure, 1e5, 1e5), InputError) << first << " " << last;
  };
  refused(-310, 100);
  refused(-100, 310);
  refused(-350, 350);
  refused(20, 200);
  refused(-200, -20);
  EXPECT_THROW(join_partial_trace({0}, {1e5}, 1e5, 1e5), InputError);
  const auto [angle, pressure] = sampled(-143, 123, 1);
  EXPECT_THROW(join_partial_trace(angle, pressure, 0, 1e5), InputError);
  EXPECT_THROW(join_partial_trace(angle, pressure, 1e5, -1e5), InputError);
}

}  // namespace
