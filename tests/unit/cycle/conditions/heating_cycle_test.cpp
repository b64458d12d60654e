#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "../styles_case.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"
#include "ringfilm/models/oil/oil_of_functions.hpp"

/// Viscous heating, flash temperature and the gas that a film holds, over a cycle.
namespace ringfilm::cycle::testing {
namespace {

Case new_ring(double speed_rpm) {
  Case c = styles_new_ring();
  c.film.cavitation = Cavitation::kMassConserving;
  c.operating.speed = speed_rpm * std::numbers::pi / 30;
  return c;
}

Case heated(Case c) {
  c.thermal.viscous_heating = ViscousHeating::kInFilm;
  return c;
}

const Sample& at(const CycleResult& result, double angle_deg) {
  for (const Sample& s : result.samples) {
    if (s.crank_angle_deg == angle_deg) return s;
  }
  throw std::out_of_range("no sample at that angle");
}

TEST(ViscousHeating, IsThatOfAnIndependentModel) {
  const CycleResult result = simulated(new_ring(1500));
  // An independent implementation in two digits, with the friction power in place of the heat made in the film.
  for (const auto& [angle, rise] : {std::pair{20., 0.06}, {75., 0.24}, {285., 0.15}, {435., 0.15}}) {
    EXPECT_NEAR(at(result, angle).viscous_heating_rise, rise, 0.025) << angle;
  }
  EXPECT_EQ(at(result, 75).film_temperature, new_ring(1500).operating.oil_temperature);
}

TEST(ViscousHeating, OfTheFilmChangesFrictionAsInAnIndependentModel) {
  for (const auto& [speed, change] : {std::pair{1500., 0.001}, std::pair{5500., 0.013}}) {
    const double cold = simulated(new_ring(speed)).values.fmep, warm = simulated(heated(new_ring(speed))).values.fmep;
    EXPECT_NEAR(warm / cold - 1, change, 0.2 * change + 2e-4) << speed;
  }
}

TEST(ViscousHeating, OfTheFilmIsThatOfTheStepBefore) {
  const Case c = heated(new_ring(5500));
  const CycleResult result = simulated(c);
  for (std::size_t k = 1; k < result.samples.size(); ++k) {
    const Sample &s = result.samples[k], &before = result.samples[k - 1];
    const double rise = s.film_temperature - c.operating.oil_temperature;
    // Of the crank step before, made smaller by the viscosity of the new one.
    EXPECT_NEAR(rise, before.viscous_heating_rise, 0.1 * before.viscous_heating_rise + 1e-9) << s.crank_angle_deg;
  }
  EXPECT_GT(result.values.peak_viscous_heating_rise, 1);
  EXPECT_NEAR(at(result, std::round(result.values.peak_viscous_heating_rise_angle)).viscous_heating_rise,
              result.values.peak_viscous_heating_rise, 1e-3 * result.values.peak_viscous_heating_rise);
}

TEST(ViscousHeating, SettlesWhereOilIsStiff) {
  // Cold oil: the rise of the step before at unchanged viscosity would overshoot from step to step.
  Case c = heated(new_ring(3000));
  c.operating.oil_temperature = 258.15;
  const CycleResult result = simulated(c);
  EXPECT_GT(result.values.peak_viscous_heating_rise, 5);
  for (std::size_t k = 1; k + 1 < result.samples.size(); ++k) {
    const double bend = result.samples[k + 1].film_temperature - 2 * result.samples[k].film_temperature +
                        result.samples[k - 1].film_temperature;
    EXPECT_LT(std::abs(bend), 1) << result.samples[k].crank_angle_deg;
  }
}

TEST(ViscousHeating, HasANoteWhereItIsLargeAndIgnored) {
  const auto has_note = [](const CycleResult& result) {
    return std::any_of(result.notes.begin(), result.notes.end(),
                       [](const Note& note) { return note.topic == "viscous-heating-high"; });
  };
  Case c = new_ring(3000);
  EXPECT_FALSE(has_note(simulated(c)));
  c.operating.oil_temperature = 258.15;
  EXPECT_TRUE(has_note(simulated(c)));
  EXPECT_FALSE(has_note(simulated(heated(c))));
}

TEST(ViscousHeating, EndsWithTheOilTable) {
  Case c = heated(new_ring(5500));
  c.lubricant.table_file = "oil.csv";
  c.lubricant.table = OilTable{{383.15, 394.15}, {1e5, 2e7}, {7e-3, 9e-3, 5.6e-3, 7e-3}, {790, 798, 783, 791}};
  const CycleResult result = simulated(c);
  for (const Sample& s : result.samples) EXPECT_LE(s.film_temperature, 394.15) << s.crank_angle_deg;
  EXPECT_EQ(at(result, 70).film_temperature, 394.15);
  EXPECT_TRUE(std::any_of(result.notes.begin(), result.notes.end(),
                          [](const Note& note) { return note.topic == "viscous-heating-high"; }));
}

TEST(ViscousHeating, InABatchAgreesWithThatAlone) {
  std::vector<Case> cases(5, heated(new_ring(4000)));
  for (std::size_t i = 0; i < cases.size(); ++i) cases[i].operating.speed *= 1 + 0.1 * static_cast<double>(i);
  std::size_t given = 0, ended = 0;
  simulate_batch(
      [&]() -> std::optional<cycle::Setup> {
        if (given == cases.size()) return std::nullopt;
        return prepare(cases[given++]);
      },
      [&](const BatchOutcome& outcome) {
        ++ended;
        const CycleResult alone = simulated(cases[outcome.index]);
        // What the iteration may leave in film and pressure, solver.tolerance = 1e-8, along the cycle.
        EXPECT_NEAR(outcome.result.values.fmep / alone.values.fmep, 1, 1e-6);
        EXPECT_NEAR(outcome.result.values.peak_viscous_heating_rise / alone.values.peak_viscous_heating_rise, 1, 1e-6);
      });
  EXPECT_EQ(ended, cases.size());
}

TEST(ViscousHeating, FitsOfTheOilAgreeWithItsLaws) {
  Case c = heated(new_ring(5500));
  ASSERT_TRUE(prepare(c).ring.oil.range->has_fit());
  const CycleResult fitted = simulated(c);
  c.solver.properties = Properties::kExact;
  const CycleResult exact = simulated(c);
  EXPECT_NEAR(fitted.values.fmep / exact.values.fmep, 1, 1e-6);
  EXPECT_NEAR(fitted.values.peak_viscous_heating_rise / exact.values.peak_viscous_heating_rise, 1, 1e-6);
}

TEST(ViscousHeating, OfAnUnrolledFilmIsThatOfItsStripHalfway) {
  Case c = heated(new_ring(5500));
  c.solver.cells = 40;
  c.solver.cells_y = 8;
  c.solver.crank_step_deg = c.output.crank_angle_step_deg = 4;
  const CycleResult face = simulated(c);
  c.film.dimension = FilmDimension::kUnrolled;  // a closed ring: all strips are alike
  const CycleResult unrolled = simulated(c);
  EXPECT_NEAR(unrolled.values.peak_viscous_heating_rise / face.values.peak_viscous_heating_rise, 1, 1e-4);
  EXPECT_NEAR(unrolled.values.fmep / face.values.fmep, 1, 1e-4);
}

TEST(ViscousHeating, OfAnOwnOilIsReportedAlone) {
  const auto oil = models::oil_of_functions([](double) { return 5e-3; }, [](double) { return 800.0; });
  EXPECT_THROW(prepare(heated(new_ring(1500)), OwnOil{"mine", oil}), InputError);
  EXPECT_GT(simulate(prepare(new_ring(1500), OwnOil{"mine", oil})).values.peak_viscous_heating_rise, 0.1);
}

TEST(FlashTemperature, IsThatOfAnIndependentModel) {
  for (const auto& [speed, rise] : {std::pair{1500., 3.3}, std::pair{5500., 6.4}}) {
    EXPECT_NEAR(at(simulated(new_ring(speed)), 20).flash_temperature, rise, 0.1 * rise) << speed;
  }
}

TEST(GasHoldingMargin, IsBelowOneWhereGasBreaksThrough) {
  Case c = new_ring(1500);
  c.film.chamber_edge = c.film.crankcase_edge = EdgeFluid::kGas;
  const CycleResult result = simulated(c);
  int alike = 0, compared = 0;
  for (const Sample& s : result.samples) {
    if (std::isnan(s.gas_holding_margin)) {
      EXPECT_EQ(s.gas_breakthrough, 0) << s.crank_angle_deg;
      continue;
    }
    ++compared;
    alike += (s.gas_holding_margin < 1) == (s.gas_breakthrough > 0);
  }
  EXPECT_GT(compared, 100);
  EXPECT_GE(alike, compared - 10);  // the margin is that of steady flow
  EXPECT_LT(at(result, 15).gas_holding_margin, 1);
  EXPECT_GT(at(result, 75).gas_holding_margin, 1);
  EXPECT_TRUE(std::isnan(at(simulated(new_ring(1500)), 15).gas_holding_margin));  // edges of oil
}

}  // namespace
}  // namespace ringfilm::cycle::testing
