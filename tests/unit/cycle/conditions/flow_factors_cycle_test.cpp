#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../styles_case.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"

/// Cycles with an oil that thins and between rough walls.
namespace ringfilm::cycle::testing {
namespace {

Case mass_conserving(double speed_rpm = 1500) {
  Case c = styles_new_ring();
  c.film.cavitation = Cavitation::kMassConserving;
  c.operating.speed = speed_rpm * std::numbers::pi / 30;
  return c;
}

Case thinning(double R, double critical_rate, double speed_rpm = 1500) {
  Case c = mass_conserving(speed_rpm);
  c.lubricant.shear_thinning = ShearThinning::kCross;
  c.lubricant.second_newtonian_ratio = R;
  c.lubricant.critical_shear_rate = critical_rate;
  c.lubricant.critical_shear_rate_temperature = 393.15;
  return c;
}

Case rough(double gamma) {
  Case c = mass_conserving();
  c.film.flow_factors = c.film.stress_factors = Roughness::kPatirCheng;
  c.film.orientation = gamma;
  return c;
}

/// Figures of an independent implementation with steps of one degree, which have three digits.
constexpr double kPrototype = 0.015;

void expect_fmep(const Case& c, double fmep) {
  const CycleResult result = simulated(c);
  EXPECT_NEAR(result.values.fmep, fmep, kPrototype * fmep);
  EXPECT_LT(result.effort.max_mass_residual, 1e-5);
  EXPECT_EQ(result.effort.fallback_sub_step, 0);
}

TEST(FlowFactorCycle, ThinningOilsAreThoseOfAnIndependentModel) {
  expect_fmep(thinning(0.7, 2.4e6), 20.3e3);
  expect_fmep(thinning(0.7, 2.4e6, 5500), 11.8e3);
  expect_fmep(thinning(0.5, 4.5e6), 20.5e3);
  expect_fmep(thinning(0.6, 5e5), 21.7e3);
}

// Conduction alone would make the rise follow friction times film, the oil's flow alone friction over film: 0.81 and
// 1.00 of the Newtonian rise here. With the Newtonian viscosity in the heat it would be 1.00, too.
TEST(FlowFactorCycle, AFilmOfThinningOilIsHeatedByItsOwnFriction) {
  const CycleResult newtonian = simulated(mass_conserving(5500)), thinned = simulated(thinning(0.7, 2.4e6, 5500));
  int compared = 0;
  for (std::size_t k = 0; k < newtonian.samples.size(); ++k) {
    const Sample &a = newtonian.samples[k], &b = thinned.samples[k];
    if (a.crank_angle_deg != 285 && a.crank_angle_deg != 435) continue;
    ++compared;
    ASSERT_EQ(a.crank_angle_deg, b.crank_angle_deg);
    const double friction = b.viscous_friction / a.viscous_friction, film = b.min_film_thickness / a.min_film_thickness;
    const double rise = b.viscous_heating_rise / a.viscous_heating_rise;
    EXPECT_GT(rise, friction * film) << a.crank_angle_deg;
    EXPECT_LT(rise, 0.95 * friction / film) << a.crank_angle_deg;
  }
  EXPECT_EQ(compared, 2);
}

TEST(FlowFactorCycle, RoughWallsAreThoseOfAnIndependentModel) {
  expect_fmep(rough(1), 18.6e3);
  expect_fmep(rough(1.0 / 3), 17.4e3);
  expect_fmep(rough(9), 20.1e3);
  Case pressure_alone = rough(1);
  pressure_alone.film.stress_factors = Roughness::kNone;
  expect_fmep(pressure_alone, 18.40e3);
}

TEST(FlowFactorCycle, WithoutInfluenceTheResultIsThatOfThePlainFilm) {
  const CycleResult plain = simulated(mass_conserving());
  const CycleResult one = simulated(thinning(1, 2.4e6));
  EXPECT_EQ(one.values.fmep, plain.values.fmep);
  for (std::size_t k = 0; k < plain.samples.size(); ++k) {
    EXPECT_EQ(one.samples[k].min_film_thickness, plain.samples[k].min_film_thickness);
  }
}

TEST(FlowFactorCycle, BatchesHaveTheBitsOfSingleRuns) {
  const std::vector<Case> cases = {thinning(0.7, 2.4e6), rough(1)};
  std::vector<double> fmep(cases.size());
  std::vector<cycle::Setup> setups;
  for (const Case& c : cases) setups.push_back(prepare(c));
  for (std::size_t k = 0; k < cases.size(); ++k) fmep[k] = simulate(setups[k]).values.fmep;
  std::vector<double> in_batch(cases.size());
  auto next = setups.begin();
  const SetupSource source = [&]() {
    return next == setups.end() ? std::nullopt : std::optional<cycle::Setup>(*next++);
  };
  simulate_batch(source, [&](const BatchOutcome& of) { in_batch[of.index] = of.result.values.fmep; });
  EXPECT_EQ(in_batch, fmep);
}

Case unrolled(double gamma) {
  Case c = rough(gamma);
  c.film.dimension = FilmDimension::kUnrolled;
  c.ring.end_gap = 0.3e-3;
  c.solver.cells = 40;
  c.solver.cells_y = 12;
  c.solver.crank_step_deg = 4;
  c.output.crank_angle_step_deg = 4;
  return c;
}

TEST(FlowFactorCycle, AClosedRingIsTheFilmAcrossTheFace) {
  Case ring = unrolled(1.0 / 6);
  ring.film.average_gap = AverageGap::kTruncated;
  ring.ring.end_gap.reset();
  Case face = ring;
  face.film.dimension = FilmDimension::kFace;
  const CycleResult one = simulated(ring), other = simulated(face);
  // Factors may be left at ten times solver.tolerance, 1e-8.
  for (std::size_t k = 0; k < other.samples.size(); ++k) {
    EXPECT_NEAR(one.samples[k].min_film_thickness / other.samples[k].min_film_thickness, 1, 1e-6);
  }
  EXPECT_NEAR(one.values.fmep / other.values.fmep, 1, 1e-6);
  EXPECT_LT(one.effort.max_mass_residual, 1e-5);
}

TEST(FlowFactorCycle, CriticalShearRateFollowsFromHths) {
  Case c = thinning(0.7, 0);
  c.lubricant.critical_shear_rate = c.lubricant.critical_shear_rate_temperature = std::nullopt;
  c.lubricant.hths_viscosity = 2.9e-3;
  const cycle::Setup setup = prepare(c);
  ASSERT_TRUE(setup.ring.oil.hths_viscosity);
  EXPECT_NEAR(*setup.ring.oil.hths_viscosity, 2.9e-3, 1e-12);
  constexpr double kWithoutShear = 3.076e-3;  // ASTM D341 through the values of the oil, by hand
  const double share = (2.9e-3 / kWithoutShear - 0.7) / 0.3, critical_rate = 1e6 * share / (1 - share);
  EXPECT_NEAR(setup.ring.oil.thinning->critical_stress, critical_rate * kWithoutShear,
              0.01 * critical_rate * kWithoutShear);
  EXPECT_NEAR(simulate(setup).derived.at("hths_viscosity"), 2.9e-3, 1e-12);
}

TEST(FlowFactorCycle, RefusesAnHthsThatTheOilCannotHave) {
  Case c = thinning(0.7, 0);
  c.lubricant.critical_shear_rate = c.lubricant.critical_shear_rate_temperature = std::nullopt;
  const auto message = [&](double hths) {
    c.lubricant.hths_viscosity = hths;
    const auto breaches = broken_rules(c);
    return breaches.empty() ? "accepted" : breaches.front().message;
  };
  EXPECT_EQ(message(2.9e-3), "accepted");
  EXPECT_THAT(message(3.5e-3),
              ::testing::AllOf(::testing::HasSubstr("3.5 mPa s is not below"), ::testing::HasSubstr("150 degC, 3.0")));
  EXPECT_THAT(message(2.0e-3), ::testing::HasSubstr("second_newtonian_ratio"));
}

bool breaks_rule(const Case& c, const std::string& key) {
  const auto breaches = broken_rules(c);
  return std::any_of(breaches.begin(), breaches.end(), [&](const RuleBreach& b) { return b.key == key; });
}

TEST(FlowFactorCycle, RefusesWhatItCannotSolve) {
  Case twice = thinning(0.7, 2.4e6);
  twice.lubricant.hths_viscosity = 2.9e-3;  // of an oil file; a case that states both has a key that is not used
  EXPECT_FALSE(is_active(*find_field("lubricant.hths_viscosity"), twice));
  EXPECT_TRUE(broken_rules(twice).empty());
  Case neither = thinning(0.7, 2.4e6);
  neither.lubricant.critical_shear_rate = std::nullopt;
  EXPECT_TRUE(breaks_rule(neither, "lubricant.shear_thinning"));
  Case carreau = thinning(0.7, 2.4e6);
  carreau.lubricant.shear_thinning = ShearThinning::kCarreau;
  EXPECT_FALSE(breaks_rule(carreau, "lubricant.shear_exponent"));
  carreau.lubricant.shear_exponent = 1;
  EXPECT_TRUE(breaks_rule(carreau, "lubricant.shear_exponent"));
  Case unrolled = rough(1);
  unrolled.film.dimension = FilmDimension::kUnrolled;
  EXPECT_FALSE(breaks_rule(unrolled, "film.flow_factors"));
  unrolled.lubricant = carreau.lubricant;
  EXPECT_TRUE(breaks_rule(unrolled, "lubricant.shear_thinning"));
  Case relaxation = rough(1);
  relaxation.solver.method = Method::kPointRelaxation;
  EXPECT_TRUE(breaks_rule(relaxation, "film.flow_factors"));
}

TEST(FlowFactorCycle, ShearRateIsThatOfSlidingAndPressure) {
  const CycleResult result = simulated(mass_conserving());
  for (const Sample& s : result.samples) {
    const double slide = std::abs(s.piston_velocity) / s.min_film_thickness;
    EXPECT_GE(s.peak_shear_rate, slide * (1 - 1e-3)) << s.crank_angle_deg;  // the lowest node is above h_m
    EXPECT_LT(s.peak_shear_rate, 3 * slide + 1e6) << s.crank_angle_deg;
  }
}

}  // namespace
}  // namespace ringfilm::cycle::testing
