#include "ringfilm/study/ensemble/alternatives.hpp"

#include <gtest/gtest.h>

#include "../study_case.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"

namespace {

using namespace ringfilm;
using study::other_choices;
using study::other_numbers;
using study::testing::coarse_case;

TEST(Alternatives, ThatBreakARuleAreNotOffered) {
  cycle::Case c = coarse_case();
  c.lubricant.viscosity_temperature = cycle::ViscosityTemperature::kHoupert;
  EXPECT_EQ(other_choices("lubricant.viscosity_temperature", c).size(), 1u);
  c.lubricant.kinematic_viscosity = {
      {c.lubricant.reference_temperature, 60e-6}};  // enough for Houpert, not for Walther
  ASSERT_TRUE(cycle::broken_rules(c).empty());
  EXPECT_TRUE(other_choices("lubricant.viscosity_temperature", c).empty());
  // A rod no longer than the crank radius, 39.75 mm, would not turn.
  const auto rods = other_numbers("engine.connecting_rod_length", c, 0.1381, kMillimetre, {0.039, 0.150});
  ASSERT_EQ(rods.size(), 1u);
  EXPECT_EQ(rods.front().setting, "engine.connecting_rod_length = \"150 mm\"");
}

TEST(Alternatives, KeepToTheRangeOfTheirKeyWithOrWithoutItsEnds) {
  const cycle::Case c = coarse_case();
  // 0 to 5 with both ends; above 0 to 2 m.
  const char* friction = "contact.boundary_shear_strength_coefficient";
  EXPECT_EQ(other_numbers(friction, c, 0.3581, kPlainNumber, {-1, 0, 5, 5.01}).size(), 2u);
  EXPECT_EQ(other_numbers("engine.bore", c, 0.089, kMillimetre, {0, 2, 2.01}).size(), 1u);
}

TEST(Alternatives, AreRoundedBeforeTheyAreApplied) {
  cycle::Case c = coarse_case();
  const auto bores = other_numbers("engine.bore", c, c.engine.bore, kMillimetre, {0.1234567});
  ASSERT_EQ(bores.size(), 1u);
  EXPECT_EQ(bores.front().setting, "engine.bore = \"123.5 mm\"");
  bores.front().apply(c);
  EXPECT_DOUBLE_EQ(c.engine.bore, 0.1235);  // one multiplication
}

}  // namespace
