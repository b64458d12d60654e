#include "ringfilm/film/solver2d/film2d_factors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "film2d_cases.hpp"
#include "film_cases.hpp"
#include "ringfilm/film/factors/factor_iteration.hpp"

/// Flow factors of films in two dimensions.
namespace ringfilm::film::testing {
namespace {

constexpr double kWidth = 1e-3, kEta = 0.005, kSpeed = 5, kThickness = 1e-6;

SmoothFilm parabola(Terms terms) {
  SmoothFilm film(
      60, kWidth, [](double x) { return 20e-6 * std::pow(2 * x / kWidth - 1, 2); }, kEta, Cavitation::kMassConserving);
  film.problem.terms = terms;
  return film;
}

FilmInputs acting_on(const SmoothFilm& film) {
  FilmInputs inputs = film.inputs();
  inputs.U = kSpeed;
  inputs.left.pressure = 8e5;
  inputs.right.pressure = 3e5;
  inputs.p_cavitation = 1e5;
  inputs.load = 1e6 * kWidth;
  inputs.time_step = 1e-4;
  return inputs;
}

struct Solved2d {
  FilmState state;
  Film2dIntegrals integrals;
};

Solved2d solved(const Film2dProblem& problem, const Film2dInputs& inputs) {
  Solved2d of;
  FilmInputs of_strip = inputs.strip;  // whose source and factors are those of all strips
  of_strip.source.clear();
  of_strip.factors = nullptr;
  const FilmState before = of_strips(problem, first_guess(problem.strip, of_strip));
  of.state = before;
  of.state.h_m = kThickness;
  Film2dWorkspace workspace(problem);
  const FilmReport report = solve_film2d_at_separation(problem, inputs, before, of.state, workspace);
  EXPECT_TRUE(report.converged);
  of.integrals = film2d_integrals(problem, inputs, before, of.state);
  return of;
}

// phi_x p_xx + phi_y p_yy: with phi_y = 4 the film of twice the length has the pressures of the smooth one, and twice
// its flow through the ends.
TEST(Film2dFactors, AFactorAcrossTheMotionStretchesTheFilm) {
  constexpr double kLength = 2e-3, kSource = 0.2;  // [kg/(m2 s)]
  const SmoothFilm smooth = parabola(Terms::kPlain), rough = parabola(Terms::kAll);
  for (const Ends ends : {Ends::kOpen, Ends::kJoined}) {
    Film2dInputs inputs = inputs_of(acting_on(smooth)), of_rough = inputs_of(acting_on(rough));
    // What comes in at a few strips has to leave around them.
    const Film2dProblem problem = film2d_of(smooth.problem, uniform_around(14, kLength, ends));
    const Film2dProblem longer = film2d_of(rough.problem, uniform_around(14, 2 * kLength, ends));
    for (Film2dInputs* of : {&inputs, &of_rough}) {
      of->strip.source.assign(problem.n_nodes(), 0.0);
      for (std::size_t i = 20; i < 40; ++i) of->strip.source[5 * problem.n_across() + i] = kSource;
    }
    const auto factors = std::make_shared<FlowFactors>();
    factors->mobility_across.assign(longer.n_nodes(), 4.0);
    of_rough.strip.factors = factors;
    const Solved2d one = solved(problem, inputs), other = solved(longer, of_rough);
    double highest = 0, farthest = 0, unlike = 0;
    for (std::size_t node = 0; node < one.state.p.size(); ++node) {
      highest = std::max(highest, one.state.p[node]);
      farthest = std::max(farthest, std::abs(other.state.p[node] - one.state.p[node]));
      unlike = std::max(unlike, std::abs(one.state.p[node] - one.state.p[node % problem.n_across()]));
    }
    EXPECT_GT(unlike, 0.05 * highest);
    EXPECT_LT(farthest, 1e-8 * highest);  // both may leave 1e-10 of the step
    EXPECT_NEAR(other.integrals.flow_low, 2 * one.integrals.flow_low, 1e-7 * std::abs(one.integrals.flow_low));
    EXPECT_NEAR(other.integrals.flow_high, 2 * one.integrals.flow_high, 1e-7 * std::abs(one.integrals.flow_high));
    const double supplied = kSource * 20 * kWidth / 60 / 14;  // 20 nodes of one strip, over the length
    EXPECT_NEAR(other.integrals.mean.mass_defect, supplied, 1e-7 * std::abs(one.integrals.mean.flow_middle));
  }
}

/// Roughness across the motion: phi_y > 1 > phi_x.
FactorLaws rough_across() {
  FactorLaws laws;
  laws.pressure_flow = laws.shear_flow = laws.stress = models::PatirCheng(1.0 / 6);
  laws.cross_flow = models::PatirCheng(6);
  laws.average_gap = AverageGap::kTruncated;
  laws.sigma = 4e-7;
  laws.share_difference = -0.4;
  return laws;
}

TEST(Film2dFactors, StripsOfAJoinedFilmAreTheFilmAcross) {
  const SmoothFilm film = parabola(Terms::kAll);
  const FactorLaws laws = rough_across();
  const FilmInputs inputs = acting_on(film);
  const FilmState before = first_guess(film.problem, inputs);
  FilmState across = before;
  across.h_m = kThickness;
  FilmWorkspace workspace(film.problem);
  ASSERT_TRUE(FactorIteration(film.problem, laws)
                  .solve(inputs, across,
                         [&](const FilmInputs& held, FilmState& found) {
                           return solve_film(film.problem, held, before, found, workspace);
                         })
                  .converged);
  const FilmIntegrals face = film_integrals(film.problem, inputs, before, across);

  const Film2dProblem problem = film2d_of(film.problem, uniform_around(7, 0.01, Ends::kJoined));
  const Film2dInputs of_strips_all = inputs_of(inputs);
  const FilmState strips_before = of_strips(problem, before);
  FilmState strips = strips_before;
  strips.h_m = kThickness;
  Film2dWorkspace of_film2d(problem);
  ASSERT_TRUE(solve_with_factors(laws, problem, of_strips_all, strips, [&](const Film2dInputs& held, FilmState& found) {
                return solve_film2d(problem, held, strips_before, found, of_film2d);
              }).converged);
  const FilmIntegrals mean = film2d_integrals(problem, of_strips_all, strips_before, strips).mean;
  EXPECT_NEAR(strips.h_m / across.h_m, 1, 1e-8);
  EXPECT_NEAR(mean.hydrodynamic_load / face.hydrodynamic_load, 1, 1e-8);
  EXPECT_NEAR(mean.shear_couette / face.shear_couette, 1, 1e-8);
  EXPECT_NEAR(mean.shear_poiseuille / face.shear_poiseuille, 1, 1e-8);
  EXPECT_NEAR(mean.flow_middle / face.flow_middle, 1, 1e-8);
  EXPECT_LT(std::abs(mean.mass_defect), 1e-8 * std::abs(face.flow_middle));
  for (std::size_t node = 0; node < strips.mass_per_area.size(); ++node) {
    EXPECT_NEAR(strips.mass_per_area[node] / across.mass_per_area[node % across.mass_per_area.size()], 1, 1e-8);
  }
}

TEST(Film2dFactors, AcrossTheMotionAreThoseOfTheRoughnessTurned) {
  const SmoothFilm film = parabola(Terms::kAll);
  const Film2dProblem problem = film2d_of(film.problem, uniform_around(4, 0.01, Ends::kClosed));
  const Film2dInputs inputs = inputs_of(acting_on(film));
  const FilmState state = of_strips(problem, first_guess(film.problem, inputs.strip));
  const FactorLaws laws = rough_across();
  const auto factors = film2d_factors(laws, problem, inputs, state, kThickness);
  ASSERT_EQ(factors->mobility_across.size(), problem.n_nodes());
  const std::size_t middle = 2 * problem.n_across() + 30;
  const double H = (kThickness + problem.gap.node[middle]) / laws.sigma;
  EXPECT_DOUBLE_EQ(factors->mobility[middle], models::PatirCheng(1.0 / 6).pressure_flow(H));
  EXPECT_DOUBLE_EQ(factors->mobility_across[middle], models::PatirCheng(6).pressure_flow(H));
  EXPECT_GT(factors->mobility_across[middle], 1);
}

}  // namespace
}  // namespace ringfilm::film::testing
