#include <gtest/gtest.h>

#include "film_cases.hpp"
#include "gas_edge_cases.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"

namespace ringfilm::film::testing {
namespace {

SmoothFilm film_of(const GasFilm& form, int n_cells) {
  SmoothFilm film(
      n_cells, form.width, [&](double x) { return form.height(x) - form.h_m; }, form.eta, Cavitation::kMassConserving);
  film.problem.terms = Terms::kAll;
  return film;
}

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

}  // namespace
}  // namespace ringfilm::film::testing
