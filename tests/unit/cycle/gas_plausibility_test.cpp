#include "ringfilm/cycle/advice/gas_plausibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "styles_case.hpp"

namespace ringfilm::cycle {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A cycle of a naturally aspirated engine as its trace: compression by 10 from the intake pressure, peak after TDC.
SampledTrace engine_trace(double intake, double exhaust, int first_deg, int last_deg) {
  const models::CrankSlider crank(0.03975, 0.1381);
  const auto volume = [&](double deg) { return crank.stroke() / 9 + crank.position(deg * std::numbers::pi / 180); };
  SampledTrace trace;
  for (int deg = first_deg; deg <= last_deg; deg += 2) {
    double p = intake;
    if (deg >= -180) p = intake * std::pow(volume(-180) / volume(deg), 1.33);
    if (deg > 0) p *= deg < 15 ? 1 + deg / 10.0 : 2.5;
    if (deg > 160) p = exhaust;
    if (deg > 360) p = intake;
    trace.crank_angle_deg.push_back(deg);
    trace.value.push_back(p);
  }
  return trace;
}

Case with(SampledTrace trace) {
  Case c = testing::styles_new_ring();
  c.gas.trace_origin = TraceOrigin::kMeasured;
  c.gas.cylinder_pressure = std::move(trace);
  return c;
}

Case whole() { return with(engine_trace(0.95e5, 1.05e5, -360, 358)); }

Case partial(double intake_pressure) {
  Case c = with(engine_trace(0.95e5, 1.05e5, -143, 123));
  c.gas.intake_pressure = intake_pressure;
  c.gas.exhaust_pressure = 1.05e5;
  return c;
}

/// The same trace with other numbers.
Case changed(Case c, double factor, double offset) {
  SampledTrace trace = *c.gas.cylinder_pressure;
  for (double& p : trace.value) p = factor * p + offset;
  c.gas.cylinder_pressure = std::move(trace);
  return c;
}

Case gauge(Case c) {
  c.gas.pressure_reference = PressureReference::kGauge;
  return c;
}

Case turned(Case c, double by_deg) {
  SampledTrace trace = *c.gas.cylinder_pressure;
  for (double& angle : trace.crank_angle_deg) angle += by_deg;
  c.gas.cylinder_pressure = std::move(trace);
  return c;
}

/// Of the notes on the gas; those on the oil are others.
std::vector<Note> gas_notes(const Case& c) {
  std::vector<Note> notes = advice(prepare(c));
  std::erase_if(notes, [](const Note& note) { return note.topic.rfind("gas-", 0) != 0; });
  return notes;
}

std::vector<std::string> topics(const Case& c) {
  std::vector<std::string> topics;
  for (const Note& note : gas_notes(c)) topics.push_back(note.topic);
  return topics;
}

std::vector<std::string> broken(const Case& c) {
  std::vector<std::string> keys;
  for (const RuleBreach& breach : broken_rules(c)) keys.push_back(breach.key);
  return keys;
}

constexpr double kAtmosphere = 101325;

TEST(GasPlausibility, ProbableTracesHaveNoNote) {
  EXPECT_THAT(topics(whole()), IsEmpty());
  EXPECT_THAT(topics(partial(0.95e5)), IsEmpty());
  EXPECT_THAT(topics(partial(1.1e5)), IsEmpty()) << "losses and waves in the intake";
  EXPECT_THAT(topics(gauge(changed(whole(), 1, -kAtmosphere))), IsEmpty());
  Case charged = with(engine_trace(3.5e5, 3.2e5, -360, 358));
  EXPECT_THAT(topics(charged), IsEmpty());
  EXPECT_THAT(topics(with(engine_trace(0.3e5, 1.05e5, -360, 358))), IsEmpty()) << "a closed throttle";
  Case rig = changed(whole(), 0, 1e5);
  EXPECT_THAT(topics(rig), IsEmpty()) << "a rig without a cylinder head has no peak";
}

TEST(GasPlausibility, APeakFarFromFiringTdcIsNoted) {
  for (const double by : {75.0, 165.0, 345.0, -60.0})
    EXPECT_THAT(topics(turned(whole(), by)), ElementsAre("gas-peak-place")) << by;
  for (const double by : {0.0, 25.0}) EXPECT_THAT(topics(turned(whole(), by)), IsEmpty()) << by;
  EXPECT_THAT(topics(turned(whole(), -30)), ElementsAre("gas-compression-high")) << "its peak is before TDC";
  Case exchanged = whole();
  exchanged.gas.angle_zero = AngleZero::kGasExchangeTdc;
  EXPECT_THAT(topics(exchanged), ElementsAre("gas-peak-place"));
  EXPECT_NE(gas_notes(exchanged).front().message.find("near gas-exchange TDC"), std::string::npos);
}

TEST(GasPlausibility, AnotherReferenceIsNoted) {
  EXPECT_THAT(topics(gauge(whole())), ElementsAre("gas-pressure-high"));
  // Above the atmosphere everywhere, or it is refused as below vacuum.
  const Case gauge_as_absolute = changed(with(engine_trace(1.05e5, 1.1e5, -360, 358)), 1, -kAtmosphere);
  EXPECT_THAT(topics(gauge_as_absolute), ElementsAre("gas-pressure-low"));
  const Case charged = changed(with(engine_trace(1.5e5, 1.4e5, -360, 358)), 1, -kAtmosphere);
  EXPECT_THAT(topics(charged), ElementsAre("gas-pressure-low")) << "the exhaust against the atmosphere";
}

TEST(GasPlausibility, AnotherUnitIsNoted) {
  EXPECT_THAT(topics(changed(whole(), 0.1, 0)), ElementsAre("gas-pressure-low")) << "MPa under bar";
  EXPECT_THAT(topics(changed(whole(), 10, 0)), ElementsAre("gas-pressure-high")) << "bar under MPa";
}

TEST(GasPlausibility, MegapascalsReadAsBarAboveTheAtmosphereAreNoted) {
  for (const double intake : {0.95e5, 1.5e5, 2e5}) {
    const Case as_bar = gauge(changed(with(engine_trace(intake, 1.05e5, -360, 358)), 0.1, -0.1 * kAtmosphere));
    EXPECT_THAT(topics(as_bar), ElementsAre("gas-compression-low")) << intake;
  }
}

TEST(GasPlausibility, ATraceWithoutCompressionHasThePressureOfTheAtmosphere) {
  EXPECT_THAT(topics(changed(whole(), 0, 5e5)), ElementsAre("gas-compression-low"));
  EXPECT_THAT(topics(gauge(changed(whole(), 0, 4e5))), ElementsAre("gas-compression-low"));
  EXPECT_THAT(topics(gauge(changed(whole(), 0, 5e5))), ElementsAre("gas-pressure-high"));
  EXPECT_THAT(topics(changed(whole(), 0, 1.08e5)), IsEmpty());
  EXPECT_THAT(topics(gauge(changed(whole(), 0, 0))), IsEmpty());
}

/// Compression alone: the pressure from 180 degree before to 180 degree after firing TDC, the valves closed from
/// `closing_deg` on.
Case motored(double intake, double ratio, double exponent, double closing_deg = -180) {
  const models::CrankSlider crank(0.03975, 0.1381);
  const auto volume = [&](double deg) {
    return crank.stroke() / (ratio - 1) + crank.position(deg * std::numbers::pi / 180);
  };
  SampledTrace trace;
  for (int deg = -360; deg < 360; ++deg) {
    const bool closed = deg >= closing_deg && deg <= 180;
    trace.crank_angle_deg.push_back(deg);
    trace.value.push_back(intake * (closed ? std::pow(volume(closing_deg) / volume(deg), exponent) : 1));
  }
  return with(std::move(trace));
}

TEST(GasPlausibility, CompressionOfAnyEngineHasNoNote) {
  EXPECT_THAT(topics(motored(0.95e5, 10, 1.33)), IsEmpty());
  EXPECT_THAT(topics(motored(0.95e5, 20, 1.2)), IsEmpty());
  EXPECT_THAT(topics(motored(0.95e5, 4, 1.3)), IsEmpty()) << "a historic engine";
  EXPECT_THAT(topics(motored(0.95e5, 10, 0.9)), IsEmpty()) << "leakage at cranking speed";
  EXPECT_THAT(topics(motored(0.95e5, 13, 1.33, -72)), IsEmpty()) << "the intake valve closes late";
  EXPECT_THAT(topics(motored(4.5e5, 14, 1.36)), IsEmpty()) << "charged, hydrogen: little heat to the walls";
}

TEST(GasPlausibility, AnOffsetOfATraceIsNoted) {
  constexpr double kBar = 1e5;
  const Case aspirated = whole(), diesel = motored(0.95 * kBar, 20, 1.36),
             throttled = with(engine_trace(0.4 * kBar, 1.05 * kBar, -360, 358));
  for (const Case& c : {aspirated, diesel, throttled, partial(0.95 * kBar)}) EXPECT_THAT(topics(c), IsEmpty());
  for (const Case& c : {aspirated, diesel, throttled}) {
    EXPECT_THAT(topics(changed(c, 1, kBar)), ElementsAre("gas-compression-low"));
  }
  for (const double offset : {0.2 * kBar, 0.3 * kBar, 0.5 * kBar}) {
    EXPECT_THAT(topics(changed(aspirated, 1, offset)), ElementsAre("gas-compression-low")) << offset;
  }
  for (const double offset : {-0.2 * kBar, -0.3 * kBar}) {
    EXPECT_THAT(topics(changed(aspirated, 1, offset)), ElementsAre("gas-compression-high")) << offset;
  }
  for (const double offset : {-0.05 * kBar, 0.1 * kBar}) {
    EXPECT_THAT(topics(changed(aspirated, 1, offset)), IsEmpty()) << "of usual pegging";
  }
  const Case charged = with(engine_trace(2 * kBar, 1.9 * kBar, -360, 358)),
             half_open = with(engine_trace(0.5 * kBar, 1.05 * kBar, -360, 358));
  EXPECT_THAT(topics(changed(charged, 1, -kAtmosphere)), ElementsAre("gas-compression-high")) << "gauge as absolute";
  EXPECT_THAT(topics(changed(half_open, 1, -0.25 * kBar)), ElementsAre("gas-compression-high"));
  const std::vector<Note> notes = gas_notes(changed(aspirated, 1, kBar));
  ASSERT_FALSE(notes.empty());
  // By least squares over -120 to -45 degree at a ratio of 8, of 0.95 bar (V(-180)/V)^1.33 + 1 bar at a ratio of 10.
  EXPECT_THAT(notes.front().message, HasSubstr("a polytropic index of 1 or less for a compression ratio of 8"));
  EXPECT_THAT(notes.front().message, HasSubstr("Peg it to the intake pressure at bottom dead centre"));
  EXPECT_THAT(topics(motored(2.5 * kBar, 9, 1.28)), IsEmpty()) << "charged, of a low ratio";
  EXPECT_THAT(topics(motored(1.5 * kBar, 24, 1.38)), IsEmpty()) << "the highest ratio";
  EXPECT_THAT(topics(motored(2 * kBar, 14, 1.33, -75)), IsEmpty()) << "the intake valve closes late";
  EXPECT_THAT(topics(motored(0.95 * kBar, 10, 0.9)), IsEmpty()) << "leakage at cranking speed";
}

TEST(GasPlausibility, AMotoredPeakAwayFromTdcIsNoted) {
  // Heat and leakage: the pressure falls by 0.2 % per degree around TDC, and peaks before it.
  const auto lossy = [](double turn_deg) {
    Case c = motored(0.95e5, 17, 1.36);
    SampledTrace trace = *c.gas.cylinder_pressure;
    for (std::size_t k = 0; k < trace.value.size(); ++k) {
      trace.value[k] *= std::exp(-0.002 * std::clamp(trace.crank_angle_deg[k], -60.0, 60.0));
      trace.crank_angle_deg[k] += turn_deg;
    }
    c.gas.cylinder_pressure = std::move(trace);
    return c;
  };
  for (const double turn : {-1.0, 0.0, 0.6}) EXPECT_THAT(topics(lossy(turn)), IsEmpty()) << turn;
  for (const double turn : {-2.6, -8.0, 2.6}) EXPECT_THAT(topics(lossy(turn)), ElementsAre("gas-peak-place")) << turn;
  EXPECT_THAT(gas_notes(turned(motored(0.95e5, 10, 1.33), -2.6)).front().message,
              HasSubstr("about a peak at -2.6 degree"));
  EXPECT_THAT(topics(turned(whole(), -5)), IsEmpty()) << "combustion shifts the peak";
}

TEST(GasPlausibility, AJumpBetweenIntakeAndTraceIsNotedOrRefused) {
  const double start = engine_trace(0.95e5, 1.05e5, -143, 123).value.front();
  EXPECT_THAT(topics(partial(start / 1.6)), ElementsAre("gas-trace-jump"));
  EXPECT_THAT(broken(partial(start / 1.6)), IsEmpty());
  EXPECT_THAT(topics(partial(start * 1.6)), ElementsAre("gas-trace-jump"));
  EXPECT_THAT(broken(partial(0.95e5)), IsEmpty());
  // The case of the manual: 3.5 bar at -143 degree, where 0.95 bar can be compressed to 1.1.
  EXPECT_THAT(broken(changed(partial(0.95e5), 3.5e5 / start, 0)), ElementsAre("gas.intake_pressure"));
  EXPECT_THAT(broken(changed(partial(0.95e5), 0.1, 0)), ElementsAre("gas.intake_pressure")) << "MPa under bar";
  Case later = with(engine_trace(0.95e5, 1.05e5, -61, 123));
  later.gas.intake_pressure = 0.95e5;
  later.gas.exhaust_pressure = 1.05e5;
  EXPECT_GT(later.gas.cylinder_pressure->value.front(), 3 * 0.95e5);
  EXPECT_THAT(topics(later), IsEmpty()) << "compressed so far";
}

TEST(GasPlausibility, StatedPressuresOfGasExchangeAreCompared) {
  Case exhaust = partial(0.95e5);
  exhaust.gas.exhaust_pressure = 9e5;
  EXPECT_THAT(topics(exhaust), ElementsAre("gas-pressure-high"));
  exhaust.gas.exhaust_pressure = 0.1e5;
  EXPECT_THAT(topics(exhaust), ElementsAre("gas-pressure-low"));
}

Case wiebe() {
  Case c = whole();
  c.gas.model = GasModel::kWiebe;
  c.gas.compression_ratio = 10.5;
  c.gas.peak_pressure = 62e5;
  c.gas.peak_angle_deg = 20;
  c.gas.intake_pressure = 0.95e5;
  c.gas.exhaust_pressure = 1.05e5;
  return c;
}

TEST(GasPlausibility, ProbableWiebeCyclesHaveNoNote) {
  EXPECT_THAT(topics(wiebe()), IsEmpty());
  EXPECT_THAT(topics(turned(wiebe(), 90)), IsEmpty()) << "the trace is not used";
  Case charged = wiebe();
  charged.gas.intake_pressure = 3.5e5;
  charged.gas.exhaust_pressure = 3.2e5;
  charged.gas.peak_pressure = 200e5;
  EXPECT_THAT(topics(charged), IsEmpty());
  Case late = wiebe();
  late.gas.intake_valve_closing_deg = 640;
  EXPECT_THAT(topics(late), IsEmpty()) << "Atkinson";
}

TEST(GasPlausibility, ImprobableWiebeCyclesAreNoted) {
  const auto with_key = [](double Gas::*key, double value) {
    Case c = wiebe();
    c.gas.*key = value;
    return c;
  };
  EXPECT_THAT(topics(with_key(&Gas::peak_pressure, 620e5)), ElementsAre("gas-pressure-high"));
  EXPECT_THAT(topics(with_key(&Gas::peak_angle_deg, 89)), ElementsAre("gas-peak-place"));
  EXPECT_THAT(gas_notes(with_key(&Gas::peak_angle_deg, 89)).front().message, HasSubstr("is gas.peak_angle right?"));
  EXPECT_THAT(topics(with_key(&Gas::intake_valve_closing_deg, 700)), ElementsAre("gas-compression-low"));
  Case intake = wiebe(), exhaust = wiebe();
  intake.gas.intake_pressure = 0.01e5;
  EXPECT_THAT(topics(intake), ElementsAre("gas-pressure-low"));
  exhaust.gas.exhaust_pressure = 9e5;
  EXPECT_THAT(topics(exhaust), ElementsAre("gas-pressure-high"));
}

TEST(GasPlausibility, AnglesOfNoEngineAreNoted) {
  const auto has = [](const Case& c, const char* topic) {
    const std::vector<Note> notes = advice(prepare(c));
    return std::any_of(notes.begin(), notes.end(), [&](const Note& note) { return note.topic == topic; });
  };
  Case c = wiebe();
  EXPECT_FALSE(has(c, "valve-timing-unusual"));
  EXPECT_FALSE(has(c, "burn-duration-short"));
  c.gas.burn_duration_deg = 1;
  EXPECT_TRUE(has(c, "burn-duration-short"));
  c.gas.intake_valve_closing_deg = 700;
  EXPECT_TRUE(has(c, "valve-timing-unusual"));
}

TEST(GasPlausibility, APartOfTheCycleSpansCompressionAndExpansion) {
  EXPECT_THAT(broken(partial(0.95e5)), IsEmpty());
  const auto refusal = [](double factor, double gap_deg) {
    Case c = whole();
    c.gas.intake_pressure = 0.95e5;
    c.gas.exhaust_pressure = 1.05e5;
    SampledTrace trace = *c.gas.cylinder_pressure;
    for (double& angle : trace.crank_angle_deg) angle *= factor;
    trace.crank_angle_deg.resize(trace.crank_angle_deg.size() - static_cast<std::size_t>(gap_deg / 2));
    trace.value.resize(trace.crank_angle_deg.size());
    c.gas.cylinder_pressure = std::move(trace);
    std::string message;
    for (const RuleBreach& breach : broken_rules(c)) message += breach.key + ": " + breach.message;
    return message;
  };
  EXPECT_THAT(refusal(std::numbers::pi / 180, 0), HasSubstr("are its crank angles in radians?"));
  EXPECT_THAT(refusal(std::numbers::pi / 180, 360), HasSubstr("are its crank angles in radians?"));
  EXPECT_THAT(refusal(1.0 / 360, 0), HasSubstr("less than the 180 degree"));
}

/// The same pressures at another speed [rad/s].
Case at_speed(Case c, double speed) {
  c.operating.speed = speed;
  return c;
}

TEST(KeptPressure, IsNotedWhereTheSpeedChangesAndThePressureDoesNot) {
  const Case idle = at_speed(whole(), 90), full = at_speed(whole(), 400);
  const std::optional<std::string> kept = kept_pressure({&idle, &full});
  ASSERT_TRUE(kept);
  EXPECT_THAT(*kept, HasSubstr("operating.speed goes from 859.437 to 3819.72 rpm"));
  EXPECT_THAT(*kept, HasSubstr("the cylinder pressure stays the same, with a peak of"));
}

TEST(KeptPressure, IsNotNotedOfOneSpeedOtherPressuresOrARigWithoutCompression) {
  const Case idle = at_speed(whole(), 90), full = at_speed(whole(), 400), near = at_speed(whole(), 92);
  EXPECT_FALSE(kept_pressure({}));
  EXPECT_FALSE(kept_pressure({&idle}));
  EXPECT_FALSE(kept_pressure({&idle, &near}));  // an uncertain speed
  const Case boosted = at_speed(changed(whole(), 2, 0), 400);
  EXPECT_FALSE(kept_pressure({&idle, &full, &boosted}));
  SampledTrace open = engine_trace(0.95e5, 1.05e5, -360, 358);
  for (double& p : open.value) p = 1.01e5;
  const Case slow = at_speed(with(open), 9), fast = at_speed(with(open), 40);
  EXPECT_FALSE(kept_pressure({&slow, &fast}));
  Case one = at_speed(whole(), 90);
  one.gas.model = GasModel::kWiebe;
  Case other = at_speed(one, 400);
  EXPECT_TRUE(kept_pressure({&one, &other}));
  other.gas.peak_pressure *= 2;
  EXPECT_FALSE(kept_pressure({&one, &other}));
}

}  // namespace
}  // namespace ringfilm::cycle
