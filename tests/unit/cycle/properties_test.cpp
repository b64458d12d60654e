#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "ringfilm/cycle/integration/setup.hpp"
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

TEST(Properties, AreFittedToFourTimesTheLargestMeanPressure) {
  Case c = styles_new_ring();
  const auto setup = prepare(c);
  ASSERT_NE(setup.oil->fit(), nullptr);
  EXPECT_EQ(setup.oil->fit()->low, 0);
  EXPECT_DOUBLE_EQ(setup.oil->fit()->high, 4 * (2e5 + setup.cylinder_pressure.peak()));
  EXPECT_LT(setup.oil->fit()->error, 1e-13);
  EXPECT_FALSE(has_note(setup.notes, "properties-exact"));

  c.gas.pressure_behind_ring = 0.5;
  EXPECT_EQ(prepare(c).oil->fit()->high, 20e6);  // 13 MPa would do
}

TEST(Properties, AreFittedToHalfTheRangeWhereNoMoreIsToBeHad) {
  Case c = styles_new_ring();
  c.ring.elastic_pressure = 30e6;  // times four: 145 MPa
  const auto setup = prepare(c);
  ASSERT_NE(setup.oil->fit(), nullptr);
  EXPECT_DOUBLE_EQ(setup.oil->fit()->high, 2 * (30e6 + setup.cylinder_pressure.peak()));
}

TEST(Properties, AreThoseOfTheLawsWhereTheCaseAsksForThem) {
  Case c = styles_new_ring();
  c.solver.properties = Properties::kExact;
  const auto setup = prepare(c);
  EXPECT_EQ(setup.oil->fit(), nullptr);
  EXPECT_FALSE(has_note(setup.notes, "properties-exact"));
}

TEST(Properties, OfATableAreTakenFromItWithANote) {
  Case c = tabulated_case();
  EXPECT_EQ(prepare(c).oil->fit(), nullptr);
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
  EXPECT_EQ(fitted.derived.at("property_fit_error"), prepare(c).oil->fit()->error);
  EXPECT_EQ(fitted.derived.at("property_fit_pressure"), prepare(c).oil->fit()->high);
  c.solver.properties = Properties::kExact;
  EXPECT_EQ(simulated(c).derived.count("property_fit_error"), 0u);
  EXPECT_EQ(simulated(c).derived.count("property_fit_pressure"), 0u);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
