#include "ringfilm/cycle/setup/trace_zero.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"

namespace ringfilm::cycle {
namespace {

constexpr double kRatio = 10, kIndex = 1.32, kIntake = 0.95e5;

/// Volume of a cylinder in displacements, by the theorem of Pythagoras.
double volume(double deg) {
  const double r = 0.03975, l = 0.1381, angle = deg * std::numbers::pi / 180;
  const double way = r * (1 - std::cos(angle)) + l - std::sqrt(l * l - std::pow(r * std::sin(angle), 2));
  return 1 / (kRatio - 1) + way / (2 * r);
}

/// A motored cycle, all of whose pressures are `added` too high.
Case motored(double added) {
  Case c;
  c.engine = {0.089, 2 * 0.03975, 0.1381, {}};
  c.gas.model = GasModel::kTrace;
  SampledTrace trace;
  for (int deg = -360; deg < 360; ++deg) {
    const bool is_closed = deg >= -180 && deg <= 180;
    trace.crank_angle_deg.push_back(deg);
    trace.value.push_back(added + (is_closed ? kIntake * std::pow(volume(180) / volume(deg), kIndex) : kIntake));
  }
  c.gas.cylinder_pressure = trace;
  c.gas.compression_ratio = kRatio;
  return c;
}

TEST(Pegging, TakesAnOffsetOutOfATrace) {
  for (const double added : {-0.4e5, 0.0, 0.7e5}) {
    Case c = motored(added);
    EXPECT_EQ(pegging_shift(c), 0);
    c.gas.pegging = Pegging::kPolytropic;
    c.gas.polytropic_index = kIndex;
    EXPECT_NEAR(pegging_shift(c), -added, 1e-3) << "exact for a compression of that index";
    c.gas.pegging = Pegging::kIntake;
    c.gas.intake_pressure = kIntake;
    // Within 10 degree behind bottom dead centre compression raises the pressure by less than 1 %.
    EXPECT_NEAR(pegging_shift(c), -added, 0.01 * kIntake);
  }
}

TEST(Pegging, AWrongIndexMovesTheZeroByTheShareOfItsError) {
  Case c = motored(0);
  c.gas.pegging = Pegging::kPolytropic;
  c.gas.polytropic_index = kIndex + 0.05;
  EXPECT_GT(std::abs(pegging_shift(c)), 1e3);
  EXPECT_LT(std::abs(pegging_shift(c)), 0.3e5);
}

TEST(Pegging, IsRefusedWithoutTheSamplesThatShowIt) {
  Case c = motored(0);
  SampledTrace part;
  for (int deg = -40; deg < 200; ++deg) {
    part.crank_angle_deg.push_back(deg);
    part.value.push_back(1e5);
  }
  c.gas.cylinder_pressure = part;
  c.gas.pegging = Pegging::kPolytropic;
  EXPECT_THROW(pegging_shift(c), InputError);
}

TEST(TraceZero, OffsetsAreAddedToReferenceAndZero) {
  Case c = motored(0);
  c.gas.pressure_reference = PressureReference::kGauge;
  c.gas.pressure_offset = 0.2e5;
  EXPECT_DOUBLE_EQ(rise_of_cylinder_trace(c), 101325 + 0.2e5);
  c.gas.angle_zero = AngleZero::kGasExchangeTdc;
  c.gas.angle_offset_deg = 0.5;
  EXPECT_DOUBLE_EQ(from_firing_deg(c.gas, 360), 0.5);
}

TEST(IndicatedMeanPressure, IsTheWorkOverTheDisplacement) {
  // 10 bar on the way down from TDC to BDC and 2 bar on the way up: 8 bar; 1 bar during gas exchange: none.
  const Case c = motored(0);
  std::vector<double> angle, p;
  for (int i = 0; i < 7200; ++i) {
    angle.push_back(-360 + 0.1 * i);
    p.push_back(angle.back() < -180 || angle.back() >= 180 ? 1e5 : angle.back() < 0 ? 2e5 : 10e5);
  }
  EXPECT_NEAR(indicated_mean_pressure(c.engine, angle, p), 8e5, 200);  // a step of 0.1 degree at the jumps
  const Case even = motored(3e5);
  EXPECT_NEAR(indicated_mean_pressure(even.engine, even.gas.cylinder_pressure->crank_angle_deg,
                                      even.gas.cylinder_pressure->value),
              0, 1);  // compression and expansion are the same, and an offset does no work
}

}  // namespace
}  // namespace ringfilm::cycle
