#include "ringfilm/cycle/setup/indicated_pressure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ringfilm/cycle/advice/gas_plausibility.hpp"

namespace ringfilm::cycle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kRatio = 10, kIndex = 1.32, kIntake = 1e5, kBurnt = 2;

Engine engine() {
  Engine engine;
  engine.bore = engine.stroke = 0.08;
  engine.connecting_rod_length = 0.14;
  return engine;
}

/// Volume in strokes, written out anew.
double volume(double crank_angle_deg) {
  const double r = 0.04, l = 0.14, phi = crank_angle_deg * std::numbers::pi / 180;
  return 1 / (kRatio - 1) + (r + l - r * std::cos(phi) - std::sqrt(l * l - std::pow(r * std::sin(phi), 2))) / 0.08;
}

/// p V^n = C up to TDC, twice as much after it, and gas exchange at one pressure: the cycle of Otto with an index.
std::vector<double> angles() {
  std::vector<double> angles;
  for (double angle = -360; angle < 360; angle += 0.25) angles.push_back(angle);
  return angles;
}

std::vector<double> otto(double exhaust = kIntake, double offset = 0) {
  std::vector<double> pressure;
  for (const double angle : angles()) {
    const bool is_closed = angle >= -180 && angle <= 180;
    const double p = kIntake * std::pow(volume(180) / volume(angle), kIndex) * (angle > 0 ? kBurnt : 1);
    pressure.push_back((is_closed ? p : angle > 0 ? exhaust : kIntake) + offset);
  }
  return pressure;
}

/// Gross IMEP of that cycle: (k - 1) p V [r^(n - 1) - 1]/(n - 1), V = r/(r - 1) strokes.
double otto_imep() {
  return (kBurnt - 1) * kIntake * kRatio / (kRatio - 1) * (std::pow(kRatio, kIndex - 1) - 1) / (kIndex - 1);
}

TEST(IndicatedPressure, IsThatOfAnOttoCycle) {
  // The jumps at the dead centres, where the piston rests, are spread over one sample: 1e-3.
  const IndicatedPressure found = indicated_pressure(engine(), models::CyclePressure(angles(), otto()));
  EXPECT_NEAR(found.gross, otto_imep(), 1e-3 * otto_imep());
  EXPECT_NEAR(found.net, otto_imep(), 1e-3 * otto_imep());
}

TEST(IndicatedPressure, GasExchangeTakesItsDifferenceOfPressures) {
  const IndicatedPressure found = indicated_pressure(engine(), models::CyclePressure(angles(), otto(1.2e5)));
  EXPECT_NEAR(found.gross - found.net, 0.2e5, 1e-3 * otto_imep());
}

TEST(IndicatedPressure, AnOffsetDoesNoWork) {
  const models::CyclePressure raised(angles(), otto(kIntake, 0.5e5));
  EXPECT_NEAR(indicated_pressure(engine(), raised).net, otto_imep(), 1e-3 * otto_imep());
}

TEST(IndicatedPressure, ChangesWithTdcAsItStates) {
  std::vector<double> later = angles();
  for (double& angle : later) angle += 1;
  const double moved = indicated_pressure(engine(), models::CyclePressure(later, otto())).net;
  const IndicatedPressure found = indicated_pressure(engine(), models::CyclePressure(angles(), otto()));
  EXPECT_NEAR(moved - found.net, found.per_degree, 0.1 * std::abs(found.per_degree));
  EXPECT_GT(std::abs(found.per_degree), 0.02 * otto_imep());
}

TEST(IndicatedPressure, TheIndexOfCompressionIsThatOfTheCycle) {
  const models::CyclePressure cylinder(angles(), otto());
  EXPECT_NEAR(polytropic_index(engine(), cylinder, -90, -45, kRatio), kIndex, 1e-3);
  Case c;
  c.engine = engine();
  c.gas.model = GasModel::kTrace;
  EXPECT_FALSE(compression_index(c, cylinder));  // the ratio of an engine with a trace is not known
  c.gas.compression_ratio = kRatio;
  c.stated.insert("gas.compression_ratio");
  EXPECT_NEAR(compression_index(c, cylinder).value(), kIndex, 1e-3);
  // An offset makes it n p/(p + offset), eq-compression-index: below 1.32 by 0.1 to 0.4 for 0.5 bar at 1.5 to 6 bar.
  const models::CyclePressure raised(angles(), otto(kIntake, 0.5e5));
  EXPECT_NEAR(compression_index(c, raised).value(), 1.1, 0.1);
}

TEST(IndicatedPressure, AnOffsetOfATraceIsNotedWhereTheCompressionRatioIsKnown) {
  const auto topics = [](double offset) {
    Case c;
    c.engine = engine();
    c.gas.model = GasModel::kTrace;
    c.gas.compression_ratio = kRatio;
    c.stated.insert("gas.compression_ratio");
    c.gas.cylinder_pressure = SampledTrace{angles(), otto(kIntake, offset)};
    std::vector<Note> notes;
    append_gas_notes(c, models::CyclePressure(angles(), otto(kIntake, offset)), notes);
    std::string text;
    for (const Note& note : notes) text += note.topic + " ";
    return text;
  };
  EXPECT_EQ(topics(0), "");
  EXPECT_EQ(topics(0.3e5), "gas-compression-low ");
  EXPECT_EQ(topics(-0.3e5), "gas-compression-high ");
}

TEST(IndicatedPressure, ABentCompressionIsNotedWhereALowerRatioHidesTheOffset) {
  const auto topics = [](double offset, double ratio) {
    Case c;
    c.engine = engine();
    c.gas.model = GasModel::kTrace;
    c.gas.compression_ratio = ratio;
    c.stated.insert("gas.compression_ratio");
    c.gas.cylinder_pressure = SampledTrace{angles(), otto(kIntake, offset)};
    const models::CyclePressure cylinder(angles(), otto(kIntake, offset));
    EXPECT_NEAR(compression_index(c, cylinder).value(), 1.33, 0.1) << "no note of the index alone";
    std::vector<Note> notes;
    append_gas_notes(c, cylinder, notes);
    std::string text;
    for (const Note& note : notes) text += note.topic + " ";
    return text;
  };
  EXPECT_EQ(topics(0.5e5, 0.6 * kRatio), "gas-compression-low ");
  EXPECT_EQ(topics(0, kRatio), "");
}

TEST(IndicatedPressure, AnotherOneThanStatedIsNoted) {
  Case c;
  c.engine = engine();
  c.gas.model = GasModel::kTrace;
  c.gas.cylinder_pressure = SampledTrace{angles(), otto(1.2e5)};
  const models::CyclePressure cylinder(angles(), otto(1.2e5));
  const auto messages = [&](double imep) {
    c.gas.imep = imep;
    std::vector<Note> notes;
    append_gas_notes(c, cylinder, notes);
    std::string text;
    for (const Note& note : notes) {
      if (note.topic == "gas-imep-differs") text += note.message;
    }
    return text;
  };
  EXPECT_THAT(messages(otto_imep()), IsEmpty());          // gross
  EXPECT_THAT(messages(otto_imep() - 0.2e5), IsEmpty());  // net
  EXPECT_THAT(messages(1.1 * otto_imep()), HasSubstr("One degree of TDC changes it by"));
}

}  // namespace
}  // namespace ringfilm::cycle
