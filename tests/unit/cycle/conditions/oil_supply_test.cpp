#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../no_observer.hpp"
#include "../styles_case.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"

/// Oil that lies on the liner ahead of a ring between edges of gas.
namespace ringfilm::cycle::testing {
namespace {

Case supplied(Case c, double speed_rpm, OilSupply supply, double film) {
  c.film.cavitation = Cavitation::kMassConserving;
  c.film.chamber_edge = c.film.crankcase_edge = EdgeFluid::kGas;
  c.film.supply = supply;
  c.supply.film = {{0, film}};
  if (supply == OilSupply::kFilmOnLiner) c.supply.reach = 10e-3;
  c.operating.speed = speed_rpm * std::numbers::pi / 30;
  return c;
}

const Sample& at(const CycleResult& result, double angle_deg) { return result.samples.at(std::lround(angle_deg)); }

TEST(LinerFilm, ACellThatAnEdgeDividesHoldsItsOpenPart) {
  LinerFilm film(4.0, 1.0);  // cells of 1 mm
  EXPECT_NEAR(film.mass(0.5003, 1.25), 0.7497, 1e-12);
  // An edge that moves down sets 0.5003 to 0.5009 free: above it the cell is open from 0.5 on.
  film.lay(0.5003, 0.5009, 0.0012, false);
  EXPECT_NEAR(film.mass(0.5, 0.5009), 0.0003 + 0.0012, 1e-12);
  // One that moves up sets free what is below: the open part of its first cell lies there.
  film.lay(2.0004, 2.0018, 0.0007, true);
  EXPECT_NEAR(film.mass(2.0004, 2.002), 0.0007 + 0.0002, 1e-12);
}

double under_the_ring(const TimeIntegration& integration) {
  const film::FilmGrid& grid = integration.problem().grid;
  double sum = 0;
  for (int i = 1; i < grid.n_cells(); ++i) sum += grid.share[i] * integration.state().mass_per_area[i];
  return sum;
}

/// Largest change of all oil that the account does not explain, per oil that the ring takes up in a cycle.
double unexplained(const Case& c, int cycles) {
  const Setup setup = prepare(c);
  TimeIntegration integration(setup);
  NoObserver observer;
  integration.start(270);
  const LinerOil& oil = *integration.liner_oil();
  const auto all = [&](double angle) {
    const LinerOil::Account& account = oil.account();
    return oil.on_liner(angle) + under_the_ring(integration) + oil.bead() + account.scraped_up + account.scraped_down -
           account.replenished;
  };
  const double before = all(270);
  double largest = 0;
  for (int step = 1; step <= 720 * cycles; ++step) {
    integration.advance(observer);
    largest = std::max(largest, std::abs(all(270 + step) - before));
  }
  return largest * cycles / oil.account().taken;
}

// Gas breaks through after firing TDC, upstrokes begin with a bead, 0.3 um leave the ring dry.
TEST(OilSupply, NoOilIsLostOrCreated) {
  for (const double film : {2e-6, 0.3e-6}) {
    Case c = supplied(styles_new_ring(), 1500, OilSupply::kFilmOnLiner, film);
    c.solver.cells = 120;
    c.solver.tolerance = 1e-13;
    EXPECT_LT(unexplained(c, 2), 1e-10) << film;
    c.supply.scraped = Scraped::kDiscarded;
    EXPECT_LT(unexplained(c, 2), 1e-10) << film;
  }
}

/// A parabola whose lowest place is at an edge or next to it, so that the gases of both edges are neighbours.
Case lowest_at(double apex) {
  Case c = styles_new_ring();
  set_conditions(Conditions::kEngine, c);
  c.supply.film = {{0, 5e-6}};
  c.gas = {};
  c.gas.model = GasModel::kWiebe;
  c.gas.peak_pressure = 120e5;
  c.gas.intake_pressure = Gas::kWiebeIntakePressure;
  c.gas.exhaust_pressure = Gas::kWiebeExhaustPressure;
  c.ring.face = {};
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 10e-6;
  c.ring.face.apex = apex;
  c.solver.cells = 120;
  c.solver.crank_step_control = StepControl::kAdaptive;
  return c;
}

// The gas of the edge once pressed oil in that was not there, and no film balanced before firing TDC.
TEST(OilSupply, AnEdgeThatIsTheLowestPlaceTakesWhatLiesThere) {
  for (const double apex : {0., 0.001, 1.}) {
    Case c = lowest_at(apex);
    EXPECT_TRUE(simulated(c).complete) << apex;
    c.solver.tolerance = 1e-13;
    EXPECT_LT(unexplained(c, 1), 1e-10) << apex;
  }
}

// Another program on 240 nodes with steps of one degree; docs/theory/oil-supply.md.
TEST(OilSupply, CyclesWithMemoryAreThoseOfAnIndependentModel) {
  struct Expected {
    double film, fmep, film_435;
  };
  for (const Expected& of : {Expected{10e-6, 16.03e3, 2.422e-6}, Expected{1e-6, 16.18e3, 1.686e-6}}) {
    const CycleResult result = simulated(supplied(styles_new_ring(), 1500, OilSupply::kFilmOnLiner, of.film));
    EXPECT_NEAR(result.values.fmep, of.fmep, 0.01 * of.fmep) << of.film;
    EXPECT_NEAR(at(result, 435).min_film_thickness, of.film_435, 0.002 * of.film_435) << of.film;
    EXPECT_NEAR(at(result, 285).min_film_thickness, 1.130e-6, 0.01 * 1.130e-6) << of.film;
  }
}

// SUPPLY by quadrature of the steady film on the real face, and what a starved ring leaves is what it found.
TEST(OilSupply, AStarvedStrokeIsThatOfTheSteadyFilmAndLeavesWhatItFinds) {
  const CycleResult slow = simulated(supplied(styles_new_ring(), 1500, OilSupply::kGiven, 1e-6));
  EXPECT_NEAR(at(slow, 435).min_film_thickness, 1.68383e-6, 0.003 * 1.68383e-6);
  const CycleResult fast = simulated(supplied(styles_new_ring(), 5500, OilSupply::kGiven, 2e-6));
  EXPECT_NEAR(at(fast, 435).min_film_thickness, 3.48453e-6, 0.003 * 3.48453e-6);
  EXPECT_NEAR(at(fast, 435).film_ahead, 2e-6, 1e-12);
  EXPECT_NEAR(at(fast, 435).film_left_behind, 2.001e-6, 0.01e-6);
}

// The load of the asperities alone, film 1.0624 um at 435 degree; the dry ring passes the film on.
TEST(OilSupply, WithTooLittleOilTheAsperitiesCarry) {
  const CycleResult result = simulated(supplied(styles_new_ring(), 1500, OilSupply::kGiven, 0.3e-6));
  const Sample& dry = at(result, 435);
  EXPECT_NEAR(dry.min_film_thickness, 1.0624e-6, 0.003 * 1.0624e-6);
  EXPECT_LT(dry.viscous_friction, 2e-3 * dry.boundary_friction);
  EXPECT_NEAR(dry.film_left_behind, 0.3e-6, 0.005e-6);
}

TEST(OilSupply, AFilmAlongTheStrokeIsMetWhereItLies) {
  Case c = supplied(styles_new_ring(), 1500, OilSupply::kGiven, 2e-6);
  const CycleResult constant = simulated(c);
  c.supply.film = {{0, 2e-6}, {30e-3, 2e-6}};
  EXPECT_EQ(simulated(c).values.fmep, constant.values.fmep);
  c.supply.film = {{10e-3, 0.5e-6}, {50e-3, 2e-6}};
  const CycleResult given = simulated(c);
  const auto at_leading_edge = [&](double angle, double width) {
    const double place = prepare(c).engine.crank.position(angle * std::numbers::pi / 180) + width;
    return 0.5e-6 + 1.5e-6 * std::clamp((place - 10e-3) / 40e-3, 0.0, 1.0);
  };
  const double width = c.ring.face_width;  // the crankcase edge leads on the downstroke
  for (const double angle : {10.0, 45.0, 60.0, 120.0}) {
    EXPECT_NEAR(at(given, angle).film_ahead, at_leading_edge(angle, width), 1e-12) << angle;
    EXPECT_NEAR(at(given, 360 - angle).film_ahead, at_leading_edge(360 - angle, 0), 1e-12) << angle;
  }
  // With the liner followed, the oil ring leaves it on the downstroke.
  c.film.supply = OilSupply::kFilmOnLiner;
  c.supply.reach = 0;
  const CycleResult followed = simulated(c);
  for (const double angle : {45.0, 60.0, 420.0}) {
    EXPECT_NEAR(at(followed, angle).film_ahead, at_leading_edge(angle, width), 0.02e-6) << angle;
  }
}

TEST(OilSupply, MuchOilFloodsTheInlet) {
  const CycleResult given = simulated(supplied(styles_new_ring(), 1500, OilSupply::kGiven, 100e-6));
  const CycleResult flooded = simulated(supplied(styles_new_ring(), 1500, OilSupply::kFlooded, 0));
  // They differ in the fluid of cavities next to the inlet, gas and not p_c, and in how full a gap presses behind a
  // broken film.
  EXPECT_NEAR(given.values.fmep / flooded.values.fmep, 1, 5e-3);
}

TEST(OilSupply, EdgesOfOilFloodTheInletWhateverTheConditionsSupply) {
  const Case flooded = supplied(styles_new_ring(), 1500, OilSupply::kFlooded, 0);
  Case c = supplied(styles_new_ring(), 1500, OilSupply::kFilmOnLiner, 2e-6);
  const double with_gas = simulated(c).values.fmep;
  Case oil_at_edges = flooded;
  for (Case* one : {&c, &oil_at_edges}) one->film.chamber_edge = one->film.crankcase_edge = EdgeFluid::kOil;
  EXPECT_EQ(c.film.supply_at_inlet(), OilSupply::kFlooded);
  EXPECT_EQ(simulated(c).values.fmep, simulated(oil_at_edges).values.fmep);
  EXPECT_NE(simulated(c).values.fmep, with_gas);
}

/// Film left behind, mean of the angles up to so many degrees after both kinds of dead centre [m].
double left_behind(const CycleResult& result, int up_to) {
  double sum = 0;
  for (int k = 1; k <= up_to; ++k) {
    for (const int dead_centre : {0, 180, 360, 540}) sum += at(result, dead_centre + k).film_left_behind;
  }
  return sum / (4 * up_to);
}

TEST(OilSupply, AnOutletLeavesLessNearDeadCentresByTheCapillaryNumber) {
  Case c = supplied(styles_new_ring(), 1500, OilSupply::kFilmOnLiner, 2e-6);
  c.solver.cells = 120;
  const CycleResult half = simulated(c);
  c.lubricant.surface_tension = 0.02;  // not in use
  EXPECT_EQ(simulated(c).values.fmep, half.values.fmep);
  c.lubricant.surface_tension = 0.03;
  c.film.outlet = Outlet::kCapillary;
  ASSERT_TRUE(broken_rules(c).empty());
  const CycleResult capillary = simulated(c);
  EXPECT_TRUE(capillary.complete);
  EXPECT_LT(left_behind(capillary, 5), 0.8 * left_behind(half, 5));
  EXPECT_NEAR(capillary.values.fmep / half.values.fmep, 1, 0.1);
  c.solver.tolerance = 1e-13;
  EXPECT_LT(unexplained(c, 1), 1e-10);
}

TEST(OilSupply, BadSuppliesAreRefused) {
  const auto refused = [](const Case& c) {
    const std::vector<RuleBreach> breaches = broken_rules(c);
    return breaches.size() == 1 ? breaches.front().message : std::to_string(breaches.size()) + " breaches";
  };
  Case c = supplied(styles_new_ring(), 1500, OilSupply::kFilmOnLiner, 2e-6);
  EXPECT_TRUE(broken_rules(c).empty());
  c.supply.reach = 0.2;
  EXPECT_EQ(refused(c), "supply.reach = 200 mm is not within the stroke of 79.5 mm");
  c.supply.reach = 10e-3;
  c.solver.crank_step_deg = 1.6;
  EXPECT_EQ(refused(c).rfind("solver.crank_step = 1.6 degree does not end at the dead centres", 0), 0U) << refused(c);
}

}  // namespace
}  // namespace ringfilm::cycle::testing
