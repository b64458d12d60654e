#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/models/oil/oil_of_functions.hpp"
#include "styles_case.hpp"

namespace ringfilm::cycle::testing {
namespace {

Case coarse_ring() {
  Case c = styles_new_ring();
  c.solver.cells = 40;
  c.solver.crank_step_deg = 4;
  c.output.crank_angle_step_deg = 4;
  return c;
}

const Note* note_of(const std::vector<Note>& notes, const std::string& topic) {
  const auto found = std::find_if(notes.begin(), notes.end(), [&](const Note& note) { return note.topic == topic; });
  return found == notes.end() ? nullptr : &*found;
}

TEST(OwnOil, ThatIsTheOilOfTheCaseGivesItsBits) {
  const Case c = coarse_ring();
  Case without = c;  // what the case states of its oil is not looked at
  without.lubricant = {};
  const auto law = prepared_oil(c.lubricant, {}, {c.operating.oil_temperature, c.engine.stroke})
                       .range->at(c.operating.oil_temperature);
  const CycleResult own = simulate(prepare(without, {"the same", law}));
  const CycleResult stated = simulated(c);
  ASSERT_EQ(own.samples.size(), stated.samples.size());
  // All but the Stribeck number: the viscosity at 1 atm comes from the law, where the case has it at the zero of
  // pressures.
  EXPECT_EQ(own.values.mean_power_loss, stated.values.mean_power_loss);
  EXPECT_EQ(own.values.min_film_thickness, stated.values.min_film_thickness);
  EXPECT_EQ(own.values.mean_absolute_oil_flow, stated.values.mean_absolute_oil_flow);
  EXPECT_NEAR(own.derived.at("oil_viscosity") / stated.derived.at("oil_viscosity"), 1, 2e-3);  // alpha x 1 atm
}

TEST(OwnOil, OfFunctionsFindsTheFilmOfTheLawsTheyState) {
  Case c = coarse_ring();
  c.lubricant.viscosity_pressure = ViscosityPressure::kNone;
  c.lubricant.compressibility = Compressibility::kNone;
  const OilSetup oil = prepared_oil(c.lubricant, {}, {c.operating.oil_temperature, c.engine.stroke}).setup;
  const auto law = models::oil_of_functions([&](double) { return oil.viscosity; }, [&](double) { return oil.density; });
  const CycleResult own = simulate(prepare(c, {"even", law}));
  // What the iteration may leave in film and pressure, solver.tolerance = 1e-8, along 180 steps.
  EXPECT_NEAR(own.values.mean_power_loss / simulated(c).values.mean_power_loss, 1, 1e-6);
  EXPECT_TRUE(prepare(c, {"even", law}).ring.oil.range->has_fit());
}

TEST(OwnOil, IsNotedInTheResult) {
  const Case c = coarse_ring();
  const auto law =
      models::oil_of_functions([](double p) { return 7e-3 * std::exp(1.2e-8 * p); }, [](double) { return 790.0; });
  const CycleResult result = simulate(prepare(c, {"Barus, batch 7", law}));
  const Note* note = note_of(result.notes, "own-oil");
  ASSERT_NE(note, nullptr);
  EXPECT_NE(note->message.find("\"Barus, batch 7\""), std::string::npos) << note->message;
  EXPECT_EQ(note_of(simulated(c).notes, "own-oil"), nullptr);
  EXPECT_NEAR(result.derived.at("oil_density"), 790, 1e-9);
}

TEST(OwnOil, WithoutALawOrAValueIsRefused) {
  const Case c = coarse_ring();
  EXPECT_THROW(prepare(c, OwnOil{"none", nullptr}), InputError);
  const auto dry = models::oil_of_functions([](double) { return 0.0; }, [](double) { return 790.0; });
  EXPECT_THROW(prepare(c, {"dry", dry}), InputError);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
