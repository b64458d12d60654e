#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"
#include "styles_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

bool has_note(const std::vector<Note>& notes, const std::string& topic) {
  return std::any_of(notes.begin(), notes.end(), [&](const Note& note) { return note.topic == topic; });
}

/// Kinks in both curves where the pressures of the table lie.
Case tabulated_case() {
  Case c = styles_new_ring();
  c.lubricant.table_file = "oil.csv";
  c.lubricant.table = OilTable{{393.15}, {1e5, 5e6, 1e7, 4e7}, {5.2e-3, 5.5e-3, 5.7e-3, 7.5e-3}, {783, 785, 788, 801}};
  return c;
}

std::optional<models::OilFit> fit_of(const Setup& setup) {
  const auto oil = setup.ring.oil.range->at(setup.ring.oil.temperature);
  return oil->fit() == nullptr ? std::nullopt : std::optional(*oil->fit());
}

TEST(Properties, AreFittedToFourTimesTheLargestMeanPressure) {
  Case c = styles_new_ring();
  const auto setup = prepare(c);
  ASSERT_TRUE(fit_of(setup));
  EXPECT_EQ(fit_of(setup)->low, 0);
  EXPECT_DOUBLE_EQ(fit_of(setup)->high, 4 * (2e5 + setup.ring.lands.above.peak()));
  EXPECT_LT(fit_of(setup)->error, 1e-13);
  EXPECT_FALSE(has_note(setup.notes, "properties-exact"));

  c.gas.pressure_behind_ring = 0.5;
  EXPECT_EQ(fit_of(prepare(c))->high, 20e6);  // 13 MPa would do
}

TEST(PressureBehindRing, IsTheShareOfTheExcessOverThePressureBelow) {
  Gas gas;
  for (const double above : {0.9e5, 1.1e5, 62.3e5}) {
    EXPECT_EQ(pressure_behind_ring(gas, above, 1.01325e5), above) << "to the last bit";
    gas.pressure_behind_ring = 0;
    EXPECT_EQ(pressure_behind_ring(gas, above, 1.01325e5), 1.01325e5);
    gas.pressure_behind_ring = 0.25;
    EXPECT_DOUBLE_EQ(pressure_behind_ring(gas, above, 1e5), 1e5 + 0.25 * (above - 1e5));
    gas.pressure_behind_ring = 1;
  }
}

TEST(PressureBehindRing, LoadsTheRingWithItsTensionAndTheShare) {
  Case c = styles_new_ring();
  c.gas.pressure_behind_ring = 0.5;
  const auto setup = prepare(c);
  const double above = setup.ring.lands.above.pressure(20), below = setup.ring.lands.below.pressure(20);
  EXPECT_DOUBLE_EQ(ring_conditions(setup, 20, 0).inputs.load,
                   (setup.ring.elastic_pressure + below + 0.5 * (above - below)) * c.ring.face_width);
}

TEST(Properties, AreFittedToHalfTheRangeWhereNoMoreIsToBeHad) {
  Case c = styles_new_ring();
  c.ring.elastic_pressure = 30e6;  // times four: 145 MPa
  const auto setup = prepare(c);
  ASSERT_TRUE(fit_of(setup));
  EXPECT_DOUBLE_EQ(fit_of(setup)->high, 2 * (30e6 + setup.ring.lands.above.peak()));
}

TEST(Properties, AreThoseOfTheLawsWhereTheCaseAsksForThem) {
  Case c = styles_new_ring();
  c.solver.properties = Properties::kExact;
  const auto setup = prepare(c);
  EXPECT_FALSE(fit_of(setup));
  EXPECT_FALSE(has_note(setup.notes, "properties-exact"));
}

TEST(Properties, OfATableAreTakenFromItWithANote) {
  Case c = tabulated_case();
  EXPECT_FALSE(fit_of(prepare(c)));
  EXPECT_TRUE(has_note(prepare(c).notes, "properties-exact"));
  c.solver.properties = Properties::kExact;
  EXPECT_FALSE(has_note(prepare(c).notes, "properties-exact"));
}

TEST(Properties, ReportInTheResultHowWellAndHowFarTheyAreFitted) {
  Case c = styles_new_ring();
  c.solver.cells = 20;
  c.solver.crank_step_deg = 4;
  c.output.crank_angle_step_deg = 4;
  const CycleResult fitted = simulated(c);
  EXPECT_EQ(fitted.derived.at("property_fit_error"), fit_of(prepare(c))->error);
  EXPECT_EQ(fitted.derived.at("property_fit_pressure"), fit_of(prepare(c))->high);
  c.solver.properties = Properties::kExact;
  EXPECT_EQ(simulated(c).derived.count("property_fit_error"), 0u);
  EXPECT_EQ(simulated(c).derived.count("property_fit_pressure"), 0u);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
