#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "film2d_cases.hpp"

namespace ringfilm::film::testing {
namespace ring_shapes {
namespace {

constexpr double kLength = 0.02;  // [m]

/// Cosines and sines with 1, 2, ... waves around, alternately.
std::vector<std::vector<double>> waves(const CircumferentialGrid& around, int count) {
  std::vector<std::vector<double>> shapes;
  for (int k = 0; k < count; ++k) {
    const double number = 2 * std::numbers::pi * (k / 2 + 1) / around.length;
    std::vector<double> shape;
    for (const double y : around.y) shape.push_back(k % 2 == 0 ? std::cos(number * y) : std::sin(number * y));
    shapes.push_back(shape);
  }
  return shapes;
}

/// A piece of a ring whose load varies from strip to strip.
struct Piece {
  LaneFilm film;
  Film2dProblem problem;
  Film2dInputs inputs;

  Piece(LaneFilm of, CircumferentialGrid around, double variation) : film(std::move(of)) {
    film.problem.tolerance = 1e-12;
    problem = film2d_of(film.problem, std::move(around));
    inputs = inputs_of(film.steps[0]);
    double mean = 0;
    const CircumferentialGrid& strips = problem.around;
    for (int j = 0; j < strips.n_strips(); ++j) {
      const double wave = std::cos(2 * std::numbers::pi * strips.y[j] / kLength + 0.4);
      inputs.strip_loads.push_back(inputs.strip.load * (1 + variation * wave));
      mean += strips.share[j] / strips.length * inputs.strip_loads.back();
    }
    for (double& load : inputs.strip_loads) load *= inputs.strip.load / mean;
  }
  void set_shapes(int count, double stiffness) {
    problem.shapes.shape = waves(problem.around, count);
    problem.shapes.stiffness.assign(static_cast<std::size_t>(count) * count, 0.0);
    for (int k = 0; k < count; ++k) problem.shapes.stiffness[static_cast<std::size_t>(k) * (count + 1)] = stiffness;
  }
};

struct Bent {
  FilmReport report;
  FilmState state, before;
};

Bent solved(const Piece& piece) {
  Bent bent;
  bent.state = of_strips(piece.problem, piece.film.first);
  complete_state(piece.problem, piece.inputs, bent.state);
  bent.before = bent.state;
  Film2dWorkspace workspace(piece.problem);
  bent.report = solve_film2d(piece.problem, piece.inputs, bent.before, bent.state, workspace);
  return bent;
}

/// What film and asperities carry beyond the load in all, and in each shape beyond that and its stiffness, over the
/// load.
std::vector<double> imbalance(const Piece& piece, const Film2dInputs& inputs, const FilmState& before,
                              const FilmState& state, const std::vector<double>& amplitudes) {
  const Film2dIntegrals sums = film2d_integrals(piece.problem, inputs, before, state);
  const CircumferentialGrid& around = piece.problem.around;
  const RingShapes& shapes = piece.problem.shapes;
  std::vector<double> left(1 + shapes.count(), 0.0);
  for (int k = 0; k <= shapes.count(); ++k) {
    for (int j = 0; j < around.n_strips(); ++j) {
      const double excess = sums.strips[j].hydrodynamic_load + sums.strips[j].asperity_load - inputs.strip_loads[j];
      left[k] += around.share[j] / around.length * (k == 0 ? 1 : shapes.shape[k - 1][j]) * excess / inputs.strip.load;
    }
    for (int l = 1; k > 0 && l <= shapes.count(); ++l) {
      left[k] -= shapes.stiffness[(k - 1) * shapes.count() + l - 1] * amplitudes[l - 1] / inputs.strip.load;
    }
  }
  return left;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// Newton's method on h_m and the amplitudes around films of a given separation, with numerical slopes; shares no step
/// with the border's. @returns h_m and the amplitudes
std::vector<double> by_outer_iteration(const Piece& piece, const FilmState& before) {
  Piece rigid = piece;
  rigid.problem.shapes = {};
  Film2dWorkspace workspace(rigid.problem);
  FilmState state = before;
  state.amplitudes.clear();
  const auto left_at = [&](const std::vector<double>& u) {
    Film2dInputs inputs = piece.inputs;
    inputs.rise = rise_of_strips(piece.problem, piece.inputs, {u.begin() + 1, u.end()});
    state.h_m = u[0];
    EXPECT_TRUE(solve_film2d_at_separation(rigid.problem, inputs, before, state, workspace).converged);
    Piece seen = piece;
    return imbalance(seen, inputs, before, state, {u.begin() + 1, u.end()});
  };
  std::vector<double> u(1 + piece.problem.shapes.count(), 0.0);
  u[0] = before.h_m;
  const std::size_t n = u.size();
  for (int iteration = 0; iteration < 25; ++iteration) {
    const std::vector<double> here = left_at(u);
    if (largest(here) < 1e-10) break;
    std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1));
    const double step = 1e-5 * u[0];
    for (std::size_t l = 0; l < n; ++l) {
      std::vector<double> aside = u;
      aside[l] += step;
      const std::vector<double> there = left_at(aside);
      for (std::size_t k = 0; k < n; ++k) rows[k][l] = (there[k] - here[k]) / step * u[0];
    }
    for (std::size_t k = 0; k < n; ++k) rows[k][n] = -here[k];
    for (std::size_t k = 0; k < n; ++k) {  // Gauss and Jordan
      for (std::size_t i = 0; i < n; ++i) {
        const double factor = rows[i][k] / rows[k][k];
        for (std::size_t l = k; l <= n && i != k; ++l) rows[i][l] -= factor * rows[k][l];
      }
    }
    double most = 0;
    for (std::size_t k = 0; k < n; ++k) most = std::max(most, std::abs(rows[k][n] / rows[k][k]));
    for (std::size_t k = 0; k < n; ++k) u[k] += std::min(1.0, 0.3 / most) * rows[k][n] / rows[k][k] * u[0];
  }
  return u;
}

std::vector<CircumferentialGrid> grids() {
  return {refined_around(16, kLength, 0.2e-3), uniform_around(16, kLength, Ends::kJoined),
          uniform_around(16, kLength, Ends::kClosed)};
}

LaneFilm first_film(Cavitation cavitation) { return lane_films(kind(cavitation)).front(); }

class RingShapesOf : public ::testing::TestWithParam<Cavitation> {};
INSTANTIATE_TEST_SUITE_P(Cavitation, RingShapesOf,
                         ::testing::Values(Cavitation::kMassConserving, Cavitation::kReynoldsExit));

TEST_P(RingShapesOf, AStiffRingIsRigid) {
  for (const CircumferentialGrid& around : grids()) {
    Piece piece(first_film(GetParam()), around, 0.2);
    const Bent rigid = solved(piece);
    piece.set_shapes(5, 1e20);
    const Bent stiff = solved(piece);
    ASSERT_TRUE(rigid.report.converged && stiff.report.converged);
    EXPECT_NEAR(stiff.state.h_m / rigid.state.h_m, 1, 1e-10);
    EXPECT_LT(largest(stiff.state.amplitudes), 1e-8 * rigid.state.h_m);
    EXPECT_LE(stiff.report.iterations, rigid.report.iterations + 1);
  }
}

TEST_P(RingShapesOf, ALimpRingBalancesTheLoadInEachShape) {
  for (const CircumferentialGrid& around : grids()) {
    for (const int count : {1, 4}) {
      Piece piece(first_film(GetParam()), around, 0.2);
      const Bent rigid = solved(piece);
      piece.set_shapes(count, 0);
      const Bent bent = solved(piece);
      ASSERT_TRUE(bent.report.converged);
      EXPECT_EQ(bent.report.route, Route::kNewton);
      EXPECT_LT(largest(imbalance(piece, piece.inputs, bent.before, bent.state, bent.state.amplitudes)), 1e-9);
      EXPECT_GT(largest(bent.state.amplitudes), 0.01 * bent.state.h_m);
      EXPECT_LE(bent.report.iterations, rigid.report.iterations + 3);
      const Film2dIntegrals sums = film2d_integrals(piece.problem, piece.inputs, bent.before, bent.state);
      if (GetParam() == Cavitation::kMassConserving) {
        EXPECT_LT(std::abs(sums.mean.mass_defect), 1e-8 * std::abs(sums.mean.flow_middle));
      }
    }
  }
}

TEST_P(RingShapesOf, FiveUnknownsAreThoseOfAnOuterIteration) {
  for (const CircumferentialGrid& around : grids()) {
    Piece piece(first_film(GetParam()), around, 0.2);
    const double load_over_film = piece.inputs.strip.load / piece.film.first.h_m;
    piece.set_shapes(4, 0.2 * load_over_film);
    piece.problem.shapes.stiffness[1] = piece.problem.shapes.stiffness[4] = 0.05 * load_over_film;
    const Bent bent = solved(piece);
    ASSERT_TRUE(bent.report.converged);
    const std::vector<double> outer = by_outer_iteration(piece, bent.before);
    EXPECT_NEAR(bent.state.h_m / outer[0], 1, 1e-8);
    for (std::size_t k = 1; k < outer.size(); ++k) {
      EXPECT_NEAR(bent.state.amplitudes[k - 1] / bent.state.h_m, outer[k] / outer[0], 1e-8) << k;
    }
  }
}

// Films deep in contact and far out of it, with nine unknowns of the whole ring.
TEST(RingShapes, NewtonsMethodTakesHardlyMoreIterationsThanForARigidRing) {
  int rigid_iterations = 0, bent_iterations = 0;
  for (const LaneFilm& film : lane_films(kind(Cavitation::kMassConserving))) {
    Piece piece(film, uniform_around(16, kLength, Ends::kJoined), 0.2);
    const Bent rigid = solved(piece);
    piece.set_shapes(8, 0.1 * piece.inputs.strip.load / piece.film.first.h_m);
    const Bent bent = solved(piece);
    ASSERT_TRUE(rigid.report.converged && bent.report.converged);
    EXPECT_EQ(bent.report.route, Route::kNewton);
    EXPECT_LT(largest(imbalance(piece, piece.inputs, bent.before, bent.state, bent.state.amplitudes)), 1e-9);
    rigid_iterations += rigid.report.iterations;
    bent_iterations += bent.report.iterations;
  }
  EXPECT_LE(bent_iterations, 1.5 * rigid_iterations);  // seen without any stiffness: 51 against 39
}

TEST(RingShapes, AFilmAtASeparationKeepsItsShape) {
  Piece piece(first_film(Cavitation::kMassConserving), uniform_around(16, kLength, Ends::kJoined), 0.2);
  piece.set_shapes(2, 0);
  const Bent bent = solved(piece);
  ASSERT_TRUE(bent.report.converged);
  FilmState again = of_strips(piece.problem, piece.film.first);
  again.h_m = bent.state.h_m;
  again.amplitudes = bent.state.amplitudes;
  Film2dWorkspace workspace(piece.problem);
  ASSERT_TRUE(solve_film2d_at_separation(piece.problem, piece.inputs, bent.before, again, workspace).converged);
  EXPECT_EQ(again.amplitudes, bent.state.amplitudes);
  EXPECT_LT(largest(imbalance(piece, piece.inputs, bent.before, again, again.amplitudes)), 1e-9);
}

}  // namespace
}  // namespace ring_shapes
}  // namespace ringfilm::film::testing
