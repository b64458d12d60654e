#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "film_cases.hpp"
#include "gas_edge_cases.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"

namespace ringfilm::film::testing {
namespace {

/// Error of h_m under the load of the quadrature, and of the place where the film ends, in cells.
struct Errors {
  double h_m, exit;
};
Errors errors_of(const GasFilm& form, int n_cells) {
  const SmoothFilm film = film_of(form, n_cells);
  const Solved solved = steady_under_load(film.problem, inputs_of(form, film), 1.3 * form.h_m);
  EXPECT_TRUE(solved.report.converged);
  EXPECT_EQ(solved.report.route, Route::kNewton);
  return {solved.state.h_m / form.h_m - 1, (solved.integrals.wetted_end - form.end) * n_cells / form.width};
}

TEST(GasEdge, AFloodedFilmHoldsTwentyBarAtItsExit) {
  // Seen: 2e-5 at 240 cells.
  const Errors errors = errors_of(flooded(), 240);
  EXPECT_LT(std::abs(errors.h_m), 1e-4);
  EXPECT_LT(std::abs(errors.exit), 1);
}

TEST(GasEdge, AStarvedFilmHoldsTwentyBarAtItsExit) {
  for (const double supply : {0.55e-6, 0.56e-6, 0.58e-6}) {
    const Errors coarse = errors_of(starved(supply), 240), fine = errors_of(starved(supply), 960);
    EXPECT_LT(std::abs(coarse.h_m), 1e-3) << supply;
    EXPECT_LT(std::abs(fine.h_m), 1e-4) << supply;
    EXPECT_LT(std::abs(fine.exit), 1) << supply;
  }
}

// The lowest place is at a node, between two nodes, and next to one.
TEST(GasEdge, ABrokenFilmConvergesToSecondOrder) {
  for (const double apex : {0.5, 0.5 + 1. / 120, 0.437}) {
    const GasFilm form = broken(apex);
    for (const int n_cells : {60, 120, 240, 480}) {
      const SmoothFilm film = film_of(form, n_cells);
      const Solved solved = steady_under_load(film.problem, inputs_of(form, film), 1.2 * form.h_m);
      ASSERT_TRUE(solved.report.converged) << apex << ", " << n_cells;
      EXPECT_TRUE(solved.integrals.is_broken_through);
      const double film_off = std::abs(solved.state.h_m / form.h_m - 1),
                   flow_off = std::abs(2 * solved.integrals.flow_right / (form.U * form.h_star) - 1);
      const double off = std::max(film_off, flow_off);
      // Seen: 8 to 30 over the square of the cells.
      EXPECT_LT(off, 40. / (n_cells * n_cells)) << apex << ", " << n_cells << ": " << film_off << ", " << flow_off;
    }
  }
}

TEST(GasEdge, WhatPassesABrokenFilmSolvesItsEquation) {
  using One = base::Pack<1, base::InstructionSet::kBaseline>;
  const double full = 1e-6, reach = 5e-4, held = 2e6;
  for (const double slope : {0., 1e11, 1e12, 1e13}) {
    const auto gap = [&](double of_full, double of_held, double of_slope) {
      return passed_gap<One>(of_full, of_held, of_slope, reach).gap.v;
    };
    const PassedGap<One> passed = passed_gap<One>(full, held, slope, reach);
    const double at_throat = held - slope * (full - passed.gap.v);
    EXPECT_NEAR(passed.gap.v * std::sqrt(at_throat) / reach, 1, 1e-9) << slope;
    const double share = 1e-5;
    const auto rise = [&](double a, double b, double c) {
      return (gap(full * (1 + a), held * (1 + b), slope * (1 + c)) -
              gap(full * (1 - a), held * (1 - b), slope * (1 - c))) /
             (2 * share);
    };
    const double tolerance = 1e-6 * full;
    EXPECT_NEAR(passed.by_full.v * full, rise(share, 0, 0), tolerance) << slope;
    EXPECT_NEAR(passed.by_held.v * held, rise(0, share, 0), tolerance) << slope;
    EXPECT_NEAR(passed.by_slope.v * slope, rise(0, 0, share), tolerance) << slope;
  }
  // Released: half of a full gap passes.
  EXPECT_EQ((passed_gap<One>(full, 1e5, 0, reach).gap.v), full);
}

TEST(GasEdge, EntryAndExitMayBeExchanged) {
  const GasFilm form = starved(0.58e-6);
  const SmoothFilm film = film_of(form, 240);
  const FilmInputs inputs = inputs_of(form, film);
  const Solved there = steady_under_load(film.problem, inputs, 1.3e-6);
  const Solved back = steady_under_load(film.problem, mirrored(inputs), 1.3e-6);
  ASSERT_TRUE(there.report.converged && back.report.converged);
  EXPECT_NEAR(back.state.h_m / there.state.h_m, 1, 1e-9);
}

TEST(GasEdge, OilThatEntersLeavesAgain) {
  const GasFilm form = starved(0.58e-6);
  const SmoothFilm film = film_of(form, 240);
  const FilmInputs inputs = inputs_of(form, film);
  const Solved solved = steady_under_load(film.problem, inputs, 1.3e-6);
  ASSERT_TRUE(solved.report.converged);
  const double entering = form.U * inputs.left.supply;
  EXPECT_NEAR(solved.integrals.flow_left / entering, 1, 1e-10);
  EXPECT_NEAR(solved.integrals.flow_right / entering, 1, 1e-7);
}

// A lane beside others, as cycles side by side have them.
TEST(GasEdge, ALaneFindsWhatTheFilmAloneFinds) {
  const GasFilm form = starved(0.58e-6);
  const SmoothFilm film = film_of(form, 120);
  const FilmInputs inputs = inputs_of(form, film);
  const Solved alone = steady_under_load(film.problem, inputs, 1.3e-6);
  ASSERT_TRUE(alone.report.converged);
  const int width = film.problem.kernels->width;
  LaneNewton lanes(*film.problem.kernels, width, 120);
  FilmInputs other = inputs;
  other.load *= 1.1;
  const FilmState previous = first_guess(film.problem, inputs);
  for (int lane = 0; lane < width; ++lane) {
    lanes.bind(lane, film.problem);
    lanes.start(lane, lane == 1 ? inputs : other, previous, previous, 1.3e-6, Unknowns::kFilmAndSeparation,
                LaneLaws::kGiven);
  }
  while (lanes.phase(1) == LaneNewton::Phase::kRunning) lanes.iterate();
  ASSERT_EQ(lanes.phase(1), LaneNewton::Phase::kSolved);
  FilmState state;
  lanes.read(1, state);
  EXPECT_NEAR(state.h_m / alone.state.h_m, 1, 1e-9);
}

TEST(GasEdge, GasAtCavitationPressureIsTheCavity) {
  GasFilm form = starved(0.58e-6);
  const SmoothFilm own = film_of(form, 120);
  SmoothFilm one = film_of(form, 120);
  one.problem.terms = Terms::kPlain;
  FilmInputs gas = inputs_of(form, own);
  gas.left = {form.p_in, EdgeFluid::kGas};
  gas.right = gas.left;
  FilmInputs oil = gas;
  oil.left.fluid = oil.right.fluid = EdgeFluid::kOil;
  const Solved a = steady_under_load(own.problem, gas, 1.3e-6), b = steady_under_load(one.problem, oil, 1.3e-6);
  ASSERT_TRUE(a.report.converged && b.report.converged);
  EXPECT_NEAR(a.state.h_m / b.state.h_m, 1, 1e-9);
}

TEST(GasEdge, AProblemBetweenEdgesOfOilTakesNoGas) {
  const GasFilm form = flooded();
  SmoothFilm film = film_of(form, 60);
  film.problem.terms = Terms::kPlain;
  EXPECT_THROW(steady_under_load(film.problem, inputs_of(form, film), 1e-6), std::invalid_argument);
}

/// Bounds of pressure of a film of 1 um between gas of 1 and 5 bar.
std::vector<double> bounds(int n_cells, const std::function<double(double)>& height) {
  const FilmGrid grid = uniform_grid(n_cells, 1e-3, height);
  FilmInputs inputs;
  inputs.left = {1e5, EdgeFluid::kGas};
  inputs.right = {5e5, EdgeFluid::kGas};
  inputs.h_m_before = 1e-6;
  const GasReach reach(grid, inputs);
  std::vector<double> bound;
  for (int i = 0; i <= n_cells; ++i) bound.push_back(reach.pressure_bound(i));
  return bound;
}

/// A land of 0.4 mm between two slopes, one end of which is higher by `tilt` [m].
double land(double x, double tilt) {
  const double beyond = std::max({0.3e-3 - x, x - 0.7e-3, 0.0});
  return 0.05 * beyond + std::abs(tilt) * std::clamp((tilt > 0 ? x - 0.3e-3 : 0.7e-3 - x) / 0.4e-3, 0.0, 1.0);
}

TEST(GasReach, GasesMeetAtTheLowestNodeOfACrown) {
  const std::vector<double> bound = bounds(100, [](double x) { return 100 * (x - 0.5e-3) * (x - 0.5e-3); });
  // 0.2 % of the film of 1 um are the height 4 um beside the lowest node, less than a cell.
  for (int i = 0; i < 49; ++i) EXPECT_EQ(bound[i], 1e5) << i;
  EXPECT_GE(bound[50], bound[49]);
  for (int i = 52; i <= 100; ++i) EXPECT_EQ(bound[i], 5e5) << i;
}

TEST(GasReach, PressureFallsAlongAFlatLandAsOfAFlowThroughIt) {
  const std::vector<double> bound = bounds(1000, [](double x) { return land(x, 0); });
  for (int i = 0; i <= 1000; ++i) {
    const double share = std::clamp((1e-6 * i - 0.3e-3) / 0.4e-3, 0.0, 1.0);
    EXPECT_NEAR(bound[i], 1e5 + 4e5 * share, 4e5 / 400) << i;  // of one cell
  }
}

// Ten picometres are a tenth of an atom; the stretch is as high as 0.2 % of the film.
TEST(GasReach, ATiltOfPicometresMovesNoGas) {
  const std::vector<double> flat = bounds(200, [](double x) { return land(x, 0); });
  for (const double tilt : {1e-11, -1e-11}) {
    const std::vector<double> tilted = bounds(200, [tilt](double x) { return land(x, tilt); });
    for (int i = 0; i <= 200; ++i) EXPECT_NEAR(tilted[i], flat[i], 4e5 * 1e-3) << i;
  }
}

TEST(GasReach, EqualThroatsShareTheFallOfPressure) {
  const std::vector<double> bound =
      bounds(100, [](double x) { return 1e-5 * std::pow(std::sin(x * 2 * std::numbers::pi / 1e-3), 2); });
  // Lowest at both edges and in the middle; an edge node is half as long.
  EXPECT_NEAR(bound[20], 2e5, 1);
  EXPECT_NEAR(bound[80], 4e5, 1);
}

}  // namespace
}  // namespace ringfilm::film::testing
