#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "ringfilm/film/integrals/film2d_integrals.hpp"
#include "ringfilm/film/solver2d/film2d_solver.hpp"
#include "ringfilm/models/oil/lubricant.hpp"

namespace ringfilm::film {
namespace ends_of_films2d {
namespace {

// What the ends of a long two-dimensional film do to a film at rest of a plain oil: Laplace's equation, whose layer at
// an end is known in closed form.
constexpr double kWidth = 1e-3, kLength = 40e-3, kHeight = 5e-6;  // [m]
constexpr double kEta = 0.01, kRho = 800;                         // [Pa s], [kg/m3]

struct Pressures {
  double left, right, ends;  // [Pa]
};

Film2dIntegrals at_rest(int n_across, const std::function<double(double)>& heights, const Pressures& pressures) {
  const auto oil = models::closed_form_oil(kEta, kRho, 0.0, {0.0, 0.0});
  Film2dProblem problem;
  problem.strip.grid = uniform_grid(n_across, kWidth, heights);
  problem.strip.cavitation = Cavitation::kMassConserving;
  problem.strip.tolerance = 1e-10;
  problem.around = refined_around(200, kLength, kWidth / n_across);
  problem.gap = gap_of_strips(problem.strip.grid, problem.around);
  Film2dInputs inputs;
  inputs.strip.oil = oil;
  inputs.strip.left.pressure = pressures.left;
  inputs.strip.right.pressure = pressures.right;
  inputs.p_low = inputs.p_high = pressures.ends;
  inputs.strip.load = 1e6 * kWidth;
  FilmState state;
  state.h_m = kHeight;
  state.p.assign(problem.n_nodes(), pressures.ends);
  state.deficit.assign(problem.n_nodes(), 0.0);
  complete_state(problem, inputs, state);
  const FilmState previous = state;
  Film2dWorkspace workspace(problem);
  EXPECT_TRUE(solve_film2d_at_separation(problem, inputs, previous, state, workspace).converged);
  return film2d_integrals(problem, inputs, previous, state);
}

double even(double) { return 0; }

// At an end that is above the edges by d, p = sum of 4 d/(n pi) sin(n pi x/b) exp(-n pi y/b) over odd n, of which
// the integral is 8 d b^2/pi^3 sum 1/n^3.
TEST(Ends, CarryTheLoadOfTheirLayer) {
  const double above = 1e6, sum_of_odd = 1.0517997902646;
  const Film2dIntegrals film = at_rest(100, even, {1e6, 1e6, 1e6 + above});
  const double extra = film.mean.hydrodynamic_load * kLength - 1e6 * kWidth * kLength;
  const double layer =
      8 * above * kWidth * kWidth / (std::numbers::pi * std::numbers::pi * std::numbers::pi) * sum_of_odd;
  EXPECT_NEAR(extra / (2 * layer), 1, 0.003);  // 100 cells across, and corners in which pressure jumps
}

// With the mean pressure at the ends what flows in beside one edge of an even film flows out beside the other.
TEST(Ends, LeakNothingFromAnEvenFilmAtTheMeanOfItsEdges) {
  const Film2dIntegrals film = at_rest(50, even, {2e6, 1e6, 1.5e6});
  const double through_film = kRho * std::pow(kHeight, 3) / (12 * kEta) * 1e6;
  EXPECT_NEAR(film.flow_low / through_film, 0, 1e-8);
  EXPECT_NEAR(film.flow_high / through_film, 0, 1e-8);
}

// In a corner the pressure jumps from the edge's to the end's, so that the flow grows without bound, as the logarithm
// of the cell: docs/theory/two-dimensional-film.md reports so. Half of the difference of the edges jumps in each
// corner, and of the flows through both corners the difference of the cubes is left.
TEST(Ends, LeakByTheLogarithmOfTheCellWhereCornersDiffer) {
  const double rise = 3e-6;
  const auto wedge = [rise](double x) { return rise * (1 - x / kWidth); };
  const double cubes = std::pow(kHeight + rise, 3) - std::pow(kHeight, 3);
  const double each_halving = kRho / (12 * kEta) * cubes * 1e6 / std::numbers::pi * std::log(2.0);
  double before = at_rest(50, wedge, {2e6, 1e6, 1.5e6}).flow_low;
  for (const int n : {100, 200}) {
    const double leak = at_rest(n, wedge, {2e6, 1e6, 1.5e6}).flow_low;
    EXPECT_NEAR((leak - before) / each_halving, 1, 0.05) << n;
    before = leak;
  }
}

}  // namespace
}  // namespace ends_of_films2d
}  // namespace ringfilm::film
