#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "../sample_between_pressures.hpp"
#include "../styles_case.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/cycle_values.hpp"

/// Gas at the trailing edge of a ring, the inlet flooded.
namespace ringfilm::cycle::testing {
namespace {

Case with_gas(Case c, double speed_rpm) {
  c.film.cavitation = Cavitation::kMassConserving;
  c.film.chamber_edge = c.film.crankcase_edge = EdgeFluid::kGas;
  c.operating.speed = speed_rpm * std::numbers::pi / 30;
  return c;
}

const Sample& at(const CycleResult& result, double angle_deg) {
  for (const Sample& s : result.samples) {
    if (s.crank_angle_deg == angle_deg) return s;
  }
  throw std::out_of_range("no sample at that angle");
}

/// An independent implementation on 240 nodes with steps of one degree, whose figures have three to four digits.
constexpr double kPrototype = 0.01;

TEST(GasEdge, CyclesAreThoseOfAnIndependentModel) {
  struct Expected {
    Case input;
    double speed_rpm, fmep;
  };
  for (const Expected& of :
       {Expected{styles_new_ring(), 1500, 13.29e3}, Expected{styles_new_ring(), 5500, 6.30e3},
        Expected{styles_embedded_ring(), 1500, 3.97e3}, Expected{styles_embedded_ring(), 5500, 3.12e3}}) {
    const CycleResult result = simulated(with_gas(of.input, of.speed_rpm));
    EXPECT_NEAR(result.values.fmep, of.fmep, kPrototype * of.fmep) << of.input.title << " " << of.speed_rpm;
    // Gas takes the place of oil at the chamber edge at firing TDC.
    EXPECT_LE(result.effort.fallback_sub_step, 4) << of.input.title << " " << of.speed_rpm;
  }
}

TEST(GasEdge, FilmsAreThoseOfAnIndependentModel) {
  const CycleResult result = simulated(with_gas(styles_new_ring(), 1500));
  const double angle[] = {20, 75, 285, 435}, film[] = {0.651e-6, 1.056e-6, 2.398e-6, 2.422e-6};
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(at(result, angle[k]).min_film_thickness, film[k], kPrototype * film[k]) << angle[k];
  }
  EXPECT_NEAR(at(result, 20).friction_coefficient, 0.150, 0.002);
}

TEST(GasEdge, GasStandsOnTheFaceWhereTheFilmLeaves) {
  const Case c = with_gas(styles_new_ring(), 5500);
  const CycleResult result = simulated(c);
  const Sample &power = at(result, 75), &compression = at(result, 285);
  EXPECT_GT(power.wetted_begin, 0.1 * c.ring.face_width);  // on the downstroke the film leaves through the chamber edge
  EXPECT_EQ(power.wetted_end, c.ring.face_width);
  EXPECT_EQ(compression.wetted_begin, 0);
  EXPECT_EQ(power.gas_breakthrough, 0);
  EXPECT_LT(compression.wetted_end, 0.9 * c.ring.face_width);
}

TEST(GasEdge, TheFilmDoesNotHoldTheGasNearPeakPressure) {
  const Case c = with_gas(styles_new_ring(), 1500);
  const CycleResult result = simulated(c);
  // An independent model loses the film from about 10 to 28 degree.
  for (const double angle : {12., 20., 26.}) EXPECT_EQ(at(result, angle).gas_breakthrough, 1) << angle;
  for (const double angle : {35., 75., 285., 435.}) EXPECT_EQ(at(result, angle).gas_breakthrough, 0) << angle;
  for (const Sample& s : result.samples) {
    EXPECT_GE(s.wetted_begin, 0);
    EXPECT_LE(s.wetted_begin, s.wetted_end) << s.crank_angle_deg;
    EXPECT_LE(s.wetted_end, c.ring.face_width);
  }
}

TEST(GasEdge, TheNoteOnBreakthroughLeavesAsideTheLongestStretchWithoutIt) {
  const CycleResult result = simulated(with_gas(styles_new_ring(), 1500));
  const auto note = std::find_if(result.notes.begin(), result.notes.end(),
                                 [](const Note& one) { return one.topic == "gas-breaks-through"; });
  ASSERT_NE(note, result.notes.end());
  double first = 0, last = 0;
  const std::string place = note->message.substr(note->message.find("first at"));
  ASSERT_EQ(std::sscanf(place.c_str(), "first at %lf and last at %lf", &first, &last), 2);
  EXPECT_EQ(at(result, first).gas_breakthrough, 1);
  EXPECT_EQ(at(result, last).gas_breakthrough, 1);
  double without = 0, longest = 0;  // twice around, so that it may lie across firing TDC
  for (int turn = 0; turn < 2; ++turn) {
    for (const Sample& s : result.samples)
      longest = std::max(longest, without = s.gas_breakthrough > 0 ? 0 : without + 1);
  }
  EXPECT_EQ(std::fmod(first - last + 720, 720), longest + 1);  // samples are a degree apart
  const std::string mass = text_in(result.values.gas_through_film_forward, kMilligram, 3);
  EXPECT_THAT(note->message, ::testing::HasSubstr(mass + " of gas per cycle blow through towards the crankcase"));
}

/// eq-channel-flow through a gap over the face, all around the bore, at that temperature [K].
double laminar_flow(const Case& c, double h, double above, double below, double temperature) {
  return (above * above - below * below) * h * h * h * std::numbers::pi * c.engine.bore /
         (24 * c.gas_path.viscosity * c.gas_path.gas_constant * temperature * c.ring.face_width);
}

TEST(GasThroughFilm, IsThatOfAChannelLimitedByItsMouth) {
  Case c = with_gas(styles_new_ring(), 1500);
  const CycleResult result = simulated(c);
  const Sample& broken = at(result, 20);
  ASSERT_EQ(broken.gas_breakthrough, 1);
  const double h = broken.min_film_thickness, above = broken.gas_pressure;
  const double laminar = laminar_flow(c, h, above, broken.crankcase_pressure, 600);
  // The mouth would let some 85 times as much through: it takes 1/2/85^2 of the flow.
  EXPECT_NEAR(broken.gas_flow_through_film, laminar, 1e-3 * laminar);

  c.gas_path.viscosity = 1e-12;  // so that the mouth alone limits the flow: choked, the closed form of its maximum
  const CycleResult thin = simulated(c);
  const double g = c.gas_path.heat_capacity_ratio;
  const double psi = std::sqrt(g) * std::pow(2 / (g + 1), (g + 1) / (2 * (g - 1)));
  const double choked = std::numbers::pi * c.engine.bore * h * above / std::sqrt(c.gas_path.gas_constant * 600) * psi;
  EXPECT_EQ(at(thin, 20).min_film_thickness, h);
  EXPECT_NEAR(at(thin, 20).gas_flow_through_film, choked, 1e-9 * choked);
}

TEST(GasThroughFilm, OfACycleIsTheTrapezoidOverItsSteps) {
  const Case c = with_gas(styles_new_ring(), 1500);
  const CycleResult result = simulated(c);
  double forward = 0, back = 0;
  for (std::size_t k = 0; k < result.samples.size(); ++k) {
    const Sample &here = result.samples[k], &next = result.samples[(k + 1) % result.samples.size()];
    if (here.gas_breakthrough == 0) {
      EXPECT_EQ(here.gas_flow_through_film, 0) << here.crank_angle_deg;
    }
    const double half_a_degree = 0.5 / 360 / 25;  // at 25 turns a second [s]
    for (const double flow : {here.gas_flow_through_film, next.gas_flow_through_film}) {
      (flow > 0 ? forward : back) += half_a_degree * std::abs(flow);
    }
  }
  EXPECT_GT(forward, 0);
  const CycleValues of_samples = cycle_values(prepare(c), result.samples);
  EXPECT_NEAR(of_samples.gas_through_film_forward, forward, 1e-9 * forward);
  EXPECT_NEAR(of_samples.gas_through_film_back, back, 1e-9 * forward);
  // Some steps are shorter than a degree; of those at the begin or end of a break less than one degree of 18 counts.
  EXPECT_NEAR(result.values.gas_through_film_forward, forward, forward / 18);
}

TEST(GasThroughFilm, IsZeroBetweenEdgesOfOil) {
  const CycleResult result = simulated(styles_new_ring());
  for (const Sample& s : result.samples) EXPECT_EQ(s.gas_flow_through_film, 0) << s.crank_angle_deg;
  EXPECT_EQ(result.values.gas_through_film_forward, 0);
  EXPECT_EQ(result.values.gas_through_film_back, 0);
}

/// Gas through a film of that thickness, taken to be broken, between two pressures [kg/s].
double flow_through(const Case& c, double h, double above, double below) {
  film::FilmIntegrals integrals;
  integrals.is_broken_through = true;
  return sample_between_pressures(c, h, above, below, integrals).gas_flow_through_film;
}

TEST(GasThroughFilm, HasTheTemperatureOfTheSideThatItComesFrom) {
  Case c = with_gas(styles_new_ring(), 1500);
  const double h = 1e-6, high = 3e5, low = 1e5;
  const auto expect = [&](double above, double below, double temperature) {
    const double laminar = laminar_flow(c, h, above, below, temperature);
    EXPECT_NEAR(flow_through(c, h, above, below), laminar, 1e-5 * std::abs(laminar));  // the mouth: 1e-6
  };
  expect(high, low, 600);
  expect(low, high, 360);  // negative: towards the chamber
  c.ring.gas_path.computed_temperature_above = 450;
  c.ring.gas_path.computed_temperature_below = 400;
  expect(high, low, 450);
  expect(low, high, 400);
  EXPECT_EQ(flow_through(c, h, high, high), 0);
}

TEST(GasEdge, DoesNotDependOnHowTheFaceIsTurned) {
  Case c = with_gas(styles_new_ring(), 1500);
  c.ring.face = {};
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 10e-6;
  const CycleResult chamber = simulated(c);
  c.ring.face.orientation = Orientation::kLeadingEdge;  // a symmetric face looks the same
  const CycleResult leading = simulated(c);
  EXPECT_NEAR(leading.values.fmep, chamber.values.fmep, 1e-6 * chamber.values.fmep);
  EXPECT_EQ(leading.effort.crank_steps, chamber.effort.crank_steps);
}

TEST(GasEdge, DoesNotReachTheLowestPlaceFromTheEdgeThatIsIt) {
  Case c = with_gas(styles_new_ring(), 1500);
  c.ring.face = {};
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 10e-6;
  c.ring.face.apex = 0;  // at the chamber edge
  c.film.crankcase_edge = EdgeFluid::kOil;
  for (const Sample& s : simulated(c).samples) EXPECT_EQ(s.gas_breakthrough, 0) << s.crank_angle_deg;
}

/// A flat of 0.9 mm between two steep slopes, whose ends are higher by as much [m].
Case with_land(double left, double right) {
  Case c = with_gas(styles_new_ring(), 1500);
  c.ring.face = {};
  c.ring.face.form = FaceForm::kPoints;
  c.ring.face.x = {0, 0.15e-3, 1.05e-3, 1.2e-3};
  c.ring.face.height = {20e-6, left, right, 20e-6};
  c.film.supply = OilSupply::kGiven;
  c.supply.film = {{0, 2e-6}};
  return c;
}

// 10 pm made a factor of 2.2 of FMEP when the first of equally low nodes parted the gases.
TEST(GasEdge, ATiltOfPicometresOnALandChangesNothing) {
  const double flat = simulated(with_land(0, 0)).values.fmep;
  EXPECT_NEAR(simulated(with_land(1e-11, 0)).values.fmep, flat, 0.001 * flat);
  EXPECT_NEAR(simulated(with_land(0, 1e-11)).values.fmep, flat, 0.001 * flat);
}

// With 8 bar below it the ring is off the liner but around firing, and comes down again.
TEST(GasEdge, HoldsARingOffTheLinerWhereItPressesHarder) {
  for (const StepControl control : {StepControl::kAdaptive, StepControl::kFixed}) {
    Case c = with_gas(styles_new_ring(), 1500);
    c.ring.pressure_below.constant = 8e5;
    c.film.supply = OilSupply::kFilmOnLiner;
    c.supply.film = {{0, 2e-6}};
    c.supply.reach = 10e-3;
    c.solver.crank_step_control = control;
    const CycleResult result = simulated(c);
    ASSERT_TRUE(result.complete);
    const models::RadialCollapse ring = prepare(c).ring.collapse;
    long off = 0;
    for (const Sample& s : result.samples) {
      const double p_e = elastic_pressure(c), excess = ring.excess(s.gas_pressure, 8e5, p_e + s.gas_pressure);
      if (std::abs(excess) < 0.02e5) continue;  // asperities and the face's cells
      EXPECT_EQ(s.distance_off_liner > 0, excess > 0) << s.crank_angle_deg;
      if (s.distance_off_liner == 0) continue;
      ++off;
      EXPECT_GE(s.min_film_thickness, ring.distance(excess)) << s.crank_angle_deg;
      EXPECT_LT(s.asperity_load, 1e-9) << s.crank_angle_deg;
      EXPECT_EQ(s.gas_breakthrough, 1) << s.crank_angle_deg;
    }
    EXPECT_GT(off, 100);
    EXPECT_NEAR(result.values.off_liner_share, static_cast<double>(off) / 720, 0.01);
    EXPECT_LT(result.effort.max_mass_residual, 1e-5);
    EXPECT_EQ(std::ranges::count(result.notes, "radial-collapse", &Note::topic), 1);
    EXPECT_EQ(at(result, 15).distance_off_liner, 0);
  }
}

TEST(GasEdge, RequiresTheBalanceOfMassAndNewtonsMethod) {
  Case c = with_gas(styles_new_ring(), 1500);
  EXPECT_TRUE(broken_rules(c).empty());
  c.film.cavitation = Cavitation::kReynoldsExit;
  c.solver.method = Method::kPointRelaxation;
  EXPECT_EQ(broken_rules(c).size(), 2u);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
