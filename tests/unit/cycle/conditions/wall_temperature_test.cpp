#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../styles_case.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"

namespace ringfilm::cycle {
namespace {

/// 190 degC ring, a liner from 180 degC at TDC to 110 degC at BDC, 79.5 mm below.
Case warm_case() {
  Case c = testing::styles_new_ring();
  c.thermal.ring = 463.15;
  c.thermal.liner = {{0, 453.15}, {0.0795, 383.15}};
  return c;
}

Case coarse(Case c) {
  c.solver.cells = 40;
  c.solver.crank_step_deg = 4;
  c.output.crank_angle_step_deg = 4;
  return c;
}

double film_temperature(const Case& c, double angle) {
  return ring_conditions(prepare(c), angle, film::kSteady).film_temperature;
}

TEST(WallTemperatures, GiveTheFilmTheirMeanAtThePositionOfTheRing) {
  Case c = warm_case();
  EXPECT_DOUBLE_EQ(film_temperature(c, 0), 0.5 * (463.15 + 453.15));
  EXPECT_NEAR(film_temperature(c, 180), 0.5 * (463.15 + 383.15), 1e-9);
  const cycle::Setup setup = prepare(c);
  const double s = setup.engine.crank.position(std::acos(-1.0) / 3);
  EXPECT_NEAR(film_temperature(c, 60), 0.5 * (463.15 + 453.15 - 70 * s / 0.0795), 1e-9);
  c.thermal.film = FilmTemperature::kLiner;
  EXPECT_DOUBLE_EQ(film_temperature(c, 0), 453.15);
  c.thermal.film = FilmTemperature::kRing;
  EXPECT_DOUBLE_EQ(film_temperature(c, 60), 463.15);
}

TEST(WallTemperatures, AreConstantBeyondThePointsOfTheLiner) {
  Case c = warm_case();
  c.thermal.film = FilmTemperature::kLiner;
  c.thermal.liner = {{0.02, 440}, {0.03, 400}};
  EXPECT_EQ(film_temperature(c, 0), 440);
  EXPECT_EQ(film_temperature(c, 180), 400);
}

TEST(WallTemperatures, OfOneValueGiveTheBitsOfThatOilTemperature) {
  Case isothermal = coarse(testing::styles_new_ring());
  Case walls = isothermal;
  walls.thermal.ring = walls.operating.oil_temperature;
  walls.thermal.liner = {{0, walls.operating.oil_temperature}};
  const CycleResult a = simulate(prepare(isothermal)), b = simulate(prepare(walls));
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (const CurveQuantity& quantity : curve_quantities()) {
    if (quantity.name == "stribeck_number") continue;  // viscosity at 1 atm, not at the zero of pressures
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
      const double x = a.samples[i].*quantity.value, y = b.samples[i].*quantity.value;
      EXPECT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << quantity.name << " at " << i;
    }
  }
}

TEST(WallTemperatures, FitsAgreeWithTheLaws) {
  Case c = coarse(warm_case());
  const CycleResult fitted = simulate(prepare(c));
  EXPECT_TRUE(prepare(c).ring.oil.range->has_fit());
  c.solver.properties = Properties::kExact;
  const CycleResult exact = simulate(prepare(c));
  // The fits agree to 1e-10, contact's to 1e-7, the iteration to 1e-8.
  EXPECT_NEAR(fitted.values.fmep / exact.values.fmep, 1, 1e-6);
  EXPECT_NEAR(fitted.values.min_film_thickness / exact.values.min_film_thickness, 1, 1e-6);
}

TEST(WallTemperatures, OfALongStrokeAreOfQuasiSteadyOils) {
  // At each crank angle the viscosity is that of the temperature there: the same film of an oil at that one
  // temperature.
  const Case c = warm_case();
  const cycle::Setup setup = prepare(c);
  for (const double angle : {0.0, 75.0, 180.0, 430.0}) {
    const RingConditions at = ring_conditions(setup, angle, film::kSteady);
    Case one = testing::styles_new_ring();
    one.operating.oil_temperature = at.film_temperature;
    const auto oil = prepare(one).ring.oil.range->at(at.film_temperature);
    EXPECT_NEAR(at.inputs.oil->viscosity(3e6) / oil->viscosity(3e6), 1, 1e-12);
    EXPECT_NEAR(at.inputs.oil->density(3e6) / oil->density(3e6), 1, 1e-12);
    ASSERT_NE(at.inputs.oil->fit(), nullptr);
    EXPECT_NEAR(at.inputs.oil->fit()->at(3e6).K / oil->fit()->at(3e6).K, 1, 1e-10);
    EXPECT_NEAR(at.inputs.oil->fit()->at(3e6).rho / oil->fit()->at(3e6).rho, 1, 1e-10);
  }
}

TEST(WallTemperatures, InABatchAgreeWithThoseAlone) {
  std::vector<Case> cases(5, coarse(warm_case()));
  for (std::size_t i = 0; i < cases.size(); ++i) cases[i].operating.speed *= 1 + 0.1 * static_cast<double>(i);
  std::size_t given = 0, ended = 0;
  simulate_batch(
      [&]() -> std::optional<cycle::Setup> {
        if (given == cases.size()) return std::nullopt;
        return prepare(cases[given++]);
      },
      [&](const BatchOutcome& outcome) {
        ++ended;
        const CycleResult alone = simulate(prepare(cases[outcome.index]));
        // What the iteration may leave in film and pressure, solver.tolerance = 1e-8, along the cycle.
        EXPECT_NEAR(outcome.result.values.fmep / alone.values.fmep, 1, 1e-6);
        EXPECT_NEAR(outcome.result.values.min_film_thickness / alone.values.min_film_thickness, 1, 1e-6);
      });
  EXPECT_EQ(ended, cases.size());
}

TEST(WallTemperatures, KeepMassWithTheDensityOfEachStep) {
  Case c = coarse(warm_case());
  c.solver.tolerance = 1e-11;
  EXPECT_LT(simulate(prepare(c)).effort.max_mass_residual, 1e-8);
}

TEST(WallTemperatures, HaveNoNoteOnADensityThatIsOneValue) {
  Case c = warm_case();
  const auto extrapolates_density = [](const Case& one) {
    const std::vector<Note> notes = advice(prepare(one));
    return std::any_of(notes.begin(), notes.end(), [](const Note& n) { return n.topic == "density-extrapolated"; });
  };
  EXPECT_TRUE(extrapolates_density(c));  // measured between 15 and 40 degC
  c.lubricant.constant_density = 800;
  EXPECT_FALSE(extrapolates_density(c));
}

std::vector<std::string> broken(const Case& c) {
  std::vector<std::string> keys;
  for (const RuleBreach& breach : broken_rules(c)) keys.push_back(breach.key);
  return keys;
}

TEST(WallTemperatures, ThatAreMissingOrReversedAreRefused) {
  using ::testing::ElementsAre;
  using ::testing::IsEmpty;
  Case c = warm_case();
  EXPECT_THAT(broken(c), IsEmpty());
  c.thermal.ring.reset();
  EXPECT_THAT(broken(c), ElementsAre("thermal.ring"));
  c.thermal.film = FilmTemperature::kLiner;
  EXPECT_THAT(broken(c), IsEmpty());
  c.thermal.liner = {{0.02, 440}, {0.01, 400}};
  EXPECT_THAT(broken(c), ElementsAre("thermal.liner"));
  c.thermal.liner = {{-0.02, 440}};
  EXPECT_THAT(broken(c), ElementsAre("thermal.liner"));
  c.thermal = {.ring = 400, .liner = {}, .film = FilmTemperature::kMeanOfWalls};
  EXPECT_THAT(broken(c), ElementsAre("thermal.liner"));
}

// The Walther line of an oil continues below its pour point.
TEST(WallTemperatures, BelowThePourPointOfTheOilAreRefused) {
  using ::testing::ElementsAre;
  using ::testing::IsEmpty;
  Case c = warm_case();
  c.thermal.film = FilmTemperature::kRing;
  c.thermal.ring = 273.15 - 20;
  EXPECT_THAT(broken(c), IsEmpty());
  c.thermal.ring = 273.15 - 70;
  EXPECT_THAT(broken(c), ElementsAre("thermal.ring"));
  c.thermal = {};
  c.operating.oil_temperature = 273.15 - 70;
  EXPECT_THAT(broken(c), ElementsAre("operating.oil_temperature"));
}

}  // namespace
}  // namespace ringfilm::cycle
