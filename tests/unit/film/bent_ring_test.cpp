#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "film2d_cases.hpp"
#include "ringfilm/film/solver2d/bent_ring_guess.hpp"
#include "ringfilm/models/conformity/beam_elements.hpp"

namespace ringfilm::film::testing {
namespace bent_ring {
namespace {

constexpr double kLength = 0.02;  // [m]

/// A small ring in a bore of the order 2, its load varying by a fifth from strip to strip.
struct Piece {
  LaneFilm film;
  Film2dProblem problem;
  Film2dInputs inputs;

  /// @param softness 1: the bore of order 2 bends it by about the film; 0: it does not bend
  Piece(LaneFilm of, CircumferentialGrid around, double softness, double deviation) : film(std::move(of)) {
    film.problem.tolerance = 1e-12;
    problem = film2d_of(film.problem, std::move(around));
    inputs = inputs_of(film.steps[0]);
    const CircumferentialGrid& strips = problem.around;
    double mean = 0;
    for (int j = 0; j < strips.n_strips(); ++j) {
      const double wave = std::cos(2 * std::numbers::pi * strips.y[j] / kLength + 0.4);
      inputs.strip_loads.push_back(inputs.strip.load * (1 + 0.2 * wave));
      mean += strips.share[j] / strips.length * inputs.strip_loads.back();
    }
    for (double& load : inputs.strip_loads) load *= inputs.strip.load / mean;
    if (softness > 0) bend(softness, deviation);
  }

  void bend(double softness, double deviation) {
    const CircumferentialGrid& strips = problem.around;
    const bool has_ends = strips.ends != Ends::kJoined;
    const double bore = kLength / std::numbers::pi, gap = 1e-4 * bore;
    models::RingBeamSize size{bore, 1e-3, 0.04 * bore, 1e9, 1, gap};
    const double load_over_film = inputs.strip.load / film.first.h_m;  // [N/m2]
    const models::RingBeam unit(size, {});
    size.youngs_modulus *= load_over_film * kLength / (9 * unit.stiffness() / unit.centroid_radius()) / softness;
    const models::RingBeam beam(size, {});
    const double first = beam.half_gap(), turn = 2 * (std::numbers::pi - first);
    std::vector<double> phi;
    if (!has_ends) phi.push_back(first);
    const double offset = has_ends ? 0 : 0.5 * strips.spacing[0];
    for (const double y : strips.y) phi.push_back(first + turn * (y + offset) / strips.length);
    if (!has_ends) phi.push_back(2 * std::numbers::pi - first);
    const models::BeamElements elements(beam, phi);
    problem.ring = {has_ends ? 0 : 1, elements.stiffness()};
    inputs.bore_force = elements.force_of_shape(models::FourierSeries({{2, deviation, 0.3}}));
  }
};

struct Solved {
  FilmReport report;
  FilmState state, before;
  Film2dIntegrals sums;
};

Solved solved(const Piece& piece) {
  Solved found;
  found.state = piece.problem.ring.bends() ? guess_of_bent_ring(piece.problem, piece.inputs, piece.film.first)
                                           : of_strips(piece.problem, piece.film.first);
  complete_state(piece.problem, piece.inputs, found.state);
  found.before = found.state;
  Film2dWorkspace workspace(piece.problem);
  found.report = solve_film2d(piece.problem, piece.inputs, found.before, found.state, workspace);
  if (found.report.converged) {
    found.sums = film2d_integrals(piece.problem, piece.inputs, found.before, found.state);
  }
  return found;
}

/// Of all unknowns of the ring, over its load.
double largest_imbalance(const Piece& piece, const Solved& of) {
  std::vector<double> force = bending_force(piece.problem.ring, piece.inputs, of.state.ring);
  for (int j = 0; j < piece.problem.around.n_strips(); ++j) {
    const StripIntegrals& strip = of.sums.strips[j];
    force[piece.problem.ring.of_strip(j)] +=
        piece.problem.around.share[j] * (strip.hydrodynamic_load + strip.asperity_load - piece.inputs.load_of(j));
  }
  double most = 0;
  for (const double one : force) most = std::max(most, std::abs(one));
  return most / (piece.inputs.strip.load * kLength);
}

double range_of_separations(const Piece& piece, const FilmState& state) {
  const std::vector<double> h = separations(piece.problem, state);
  return *std::max_element(h.begin(), h.end()) / *std::min_element(h.begin(), h.end()) - 1;
}

std::vector<CircumferentialGrid> grids() {
  return {refined_around(16, kLength, 0.2e-3), uniform_around(16, kLength, Ends::kJoined),
          uniform_around(16, kLength, Ends::kClosed)};
}

LaneFilm first_film(Cavitation cavitation) { return lane_films(kind(cavitation)).front(); }

class BentRingOf : public ::testing::TestWithParam<Cavitation> {};
INSTANTIATE_TEST_SUITE_P(Cavitation, BentRingOf,
                         ::testing::Values(Cavitation::kMassConserving, Cavitation::kReynoldsExit));

TEST_P(BentRingOf, FilmContactAndBendingBalanceAtEveryStrip) {
  for (const CircumferentialGrid& around : grids()) {
    for (const double deviation : {0.0, 0.4e-6}) {
      const Piece piece(first_film(GetParam()), around, 1, deviation);
      const Solved bent = solved(piece);
      ASSERT_TRUE(bent.report.converged);
      EXPECT_EQ(bent.report.route, Route::kNewton);
      EXPECT_LT(largest_imbalance(piece, bent), 1e-9);
      EXPECT_GT(range_of_separations(piece, bent.state), 0.02);
      if (GetParam() == Cavitation::kMassConserving) {
        EXPECT_LT(std::abs(bent.sums.mean.mass_defect), 1e-8 * std::abs(bent.sums.mean.flow_middle));
      }
    }
  }
}

TEST_P(BentRingOf, TheFilmIsThatOfItsSeparations) {
  for (const CircumferentialGrid& around : grids()) {
    const Piece piece(first_film(GetParam()), around, 1, 0.4e-6);
    const Solved bent = solved(piece);
    ASSERT_TRUE(bent.report.converged);
    // A film whose separations are given has no beam.
    Film2dProblem given = piece.problem;
    given.ring = {};
    Film2dInputs inputs = piece.inputs;
    inputs.rise = rise_of_strips(piece.problem, piece.inputs, bent.state.ring);
    FilmState state = of_strips(given, piece.film.first);
    state.h_m = bent.state.h_m;
    Film2dWorkspace workspace(given);
    ASSERT_TRUE(solve_film2d_at_separation(given, inputs, bent.before, state, workspace).converged);
    const Film2dIntegrals sums = film2d_integrals(given, inputs, bent.before, state);
    for (int j = 0; j < around.n_strips(); ++j) {
      EXPECT_NEAR(sums.strips[j].hydrodynamic_load / bent.sums.strips[j].hydrodynamic_load, 1, 1e-7) << j;
      EXPECT_NEAR(sums.strips[j].asperity_load, bent.sums.strips[j].asperity_load, 1e-7 * inputs.strip.load) << j;
    }
  }
}

// Films deep in contact and far out of it.
TEST(BentRing, NewtonsMethodTakesHardlyMoreIterationsThanForARigidRing) {
  int rigid_iterations = 0, bent_iterations = 0;
  for (const LaneFilm& film : lane_films(kind(Cavitation::kMassConserving))) {
    const CircumferentialGrid around = uniform_around(16, kLength, Ends::kJoined);
    const Solved rigid = solved(Piece(film, around, 0, 0));
    const Piece piece(film, around, 1, 0.5 * film.first.h_m);
    const Solved bent = solved(piece);
    ASSERT_TRUE(rigid.report.converged && bent.report.converged);
    EXPECT_LT(largest_imbalance(piece, bent), 1e-9);
    rigid_iterations += rigid.report.iterations;
    bent_iterations += bent.report.iterations;
  }
  EXPECT_LE(bent_iterations, 2 * rigid_iterations);
}

/// What each strip carries beyond its share [N/m].
std::vector<double> carried(const Piece& piece, const Solved& of) {
  std::vector<double> all;
  for (int j = 0; j < piece.problem.around.n_strips(); ++j) {
    const StripIntegrals& strip = of.sums.strips[j];
    all.push_back(strip.hydrodynamic_load + strip.asperity_load - piece.inputs.load_of(j));
  }
  return all;
}

double range(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end()) - *std::min_element(values.begin(), values.end());
}

// (14.10) by hand: where a strip presses, the ring gets further out by kappa of what it carries.
TEST(BentRing, FlatteningSurfacesLetTheRingFurtherOutWhereTheyPress) {
  int n_open = 0;  // films that are not closed anywhere
  for (const LaneFilm& film : lane_films(kind(Cavitation::kMassConserving))) {
    Piece piece(film, uniform_around(16, kLength, Ends::kJoined), 1, 0.5 * film.first.h_m);
    const Solved rigid = solved(piece);
    ASSERT_TRUE(rigid.report.converged);
    piece.problem.ring.flattening = 0.3 * film.first.h_m / range(carried(piece, rigid));
    const std::vector<double> h = separations(piece.problem, rigid.state);
    if (*std::min_element(h.begin(), h.end()) < 2.5 * closed_film(piece.problem)) continue;
    ++n_open;
    const Solved flat = solved(piece);
    ASSERT_TRUE(flat.report.converged);
    const std::vector<double> more = carried(piece, flat);
    EXPECT_LT(range(more), 0.95 * range(carried(piece, rigid)));
    Film2dProblem bending = piece.problem;
    std::vector<double> outwards = flat.state.ring;
    for (int j = 0; j < bending.around.n_strips(); ++j) {
      outwards[bending.ring.of_strip(j)] -= piece.problem.ring.flattening * more[j];
    }
    const std::vector<double> force = bending_force(bending.ring, piece.inputs, outwards);
    for (int j = 0; j < bending.around.n_strips(); ++j) {
      EXPECT_NEAR(force[bending.ring.of_strip(j)], -bending.around.share[j] * more[j],
                  1e-6 * piece.inputs.strip.load * kLength);
    }
  }
  EXPECT_GT(n_open, 0);
}

TEST(BentRing, AClosedFilmPartsFromItsSeparationWithoutAKink) {
  constexpr double kClosed = 2e-8, kStep = 1e-14;
  double slope = 0;
  EXPECT_DOUBLE_EQ(closed_separation(2 * kClosed, kClosed, &slope), 2 * kClosed);
  EXPECT_DOUBLE_EQ(slope, 1);
  EXPECT_NEAR(closed_separation(1.5 * kClosed, kClosed, &slope) / kClosed, 1, 1e-12);
  for (const double h : {1.05 * kClosed, 1.3 * kClosed, 1.99 * kClosed}) {
    closed_separation(h, kClosed, &slope);
    const double rise = closed_separation(h + kStep, kClosed) - closed_separation(h - kStep, kClosed);
    EXPECT_NEAR(slope / (rise / (2 * kStep)), 1, 1e-5);
  }
  EXPECT_DOUBLE_EQ(closed_separation(1e-12, 0), 1e-12);  // a film that may close
}

}  // namespace
}  // namespace bent_ring
}  // namespace ringfilm::film::testing
