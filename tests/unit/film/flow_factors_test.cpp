#include <gtest/gtest.h>

#include <cmath>

#include "film_cases.hpp"
#include "ringfilm/film/factors/factor_iteration.hpp"

/// Films of oils that thin and between rough walls.
namespace ringfilm::film::testing {
namespace {

constexpr double kWidth = 1e-3, kEta = 0.005, kSpeed = 5;

SmoothFilm film_of(const std::function<double(double)>& height) {
  SmoothFilm film(200, kWidth, height, kEta, Cavitation::kMassConserving);
  film.problem.terms = Terms::kAll;
  return film;
}

FilmInputs inputs_of(const SmoothFilm& film) {
  FilmInputs inputs = film.inputs();
  inputs.U = kSpeed;
  inputs.left.pressure = inputs.right.pressure = 2e5;
  inputs.p_cavitation = 1e5;
  inputs.load = 1e6 * kWidth;
  return inputs;
}

Solved solved_at(const SmoothFilm& film, const FactorLaws& laws, const FilmInputs& inputs, double h_m) {
  FilmWorkspace workspace(film.problem);
  const FilmState previous = first_guess(film.problem, inputs);
  Solved solved;
  solved.state = previous;
  solved.state.h_m = h_m;
  solved.report =
      FactorIteration(film.problem, laws).solve(inputs, solved.state, [&](const FilmInputs& held, FilmState& state) {
        return solve_film_at_separation(film.problem, held, previous, state, workspace);
      });
  solved.integrals = film_integrals(film.problem, inputs, previous, solved.state);
  return solved;
}

ThinningOil cross(double R, double critical_rate) {
  return {{models::ShearThinningLaw::kCross, R, 1}, critical_rate * kEta, 0};
}

double slope(double x) { return 2e-6 * (1 - x / kWidth); }

TEST(FlowFactors, CouetteFilmOfACrossOilMatchesClosedForm) {
  const SmoothFilm film = film_of([](double) { return 0.0; });
  FactorLaws laws;
  laws.thinning = cross(0.6, 2e6);
  const double h = 1e-6;
  const Solved solved = solved_at(film, laws, inputs_of(film), h);
  ASSERT_TRUE(solved.report.converged);
  const double rate = kSpeed / h, eta = kEta * (0.6 + 0.4 / (1 + rate / 2e6));
  EXPECT_NEAR(solved.integrals.shear_couette, eta * rate * kWidth, 1e-9 * eta * rate * kWidth);
  EXPECT_NEAR(solved.integrals.shear_poiseuille, 0, 1e-9);
  EXPECT_NEAR(solved.integrals.peak_shear_rate, rate, 1e-9 * rate);
}

TEST(FlowFactors, ThinningWithARatioOfOneIsTheNewtonianFilm) {
  const SmoothFilm film = film_of(slope);
  const FilmInputs inputs = inputs_of(film);
  FactorLaws laws;
  laws.thinning = cross(1, 2e6);
  const Solved plain = solved_at(film, {}, inputs, 1e-6), thinned = solved_at(film, laws, inputs, 1e-6);
  ASSERT_TRUE(plain.report.converged && thinned.report.converged);
  EXPECT_EQ(plain.state.p, thinned.state.p);
  EXPECT_NEAR(thinned.integrals.shear_couette, plain.integrals.shear_couette, 1e-12 * plain.integrals.shear_couette);
  EXPECT_NEAR(thinned.integrals.shear_poiseuille, plain.integrals.shear_poiseuille,
              1e-12 * plain.integrals.shear_couette);
}

TEST(FlowFactors, AnOilAtItsSecondNewtonianViscosityIsAThinnerOil) {
  const SmoothFilm film = film_of(slope);
  const SmoothFilm thinner(200, kWidth, slope, 0.6 * kEta, Cavitation::kMassConserving);
  FactorLaws laws;
  laws.thinning = cross(0.6, 1e-3);
  const FilmInputs inputs = inputs_of(film);
  FilmInputs of_thinner = inputs;
  of_thinner.oil = thinner.oil;
  const Solved thinned = solved_at(film, laws, inputs, 1e-6);
  const Solved expected = steady_at(thinner.problem, of_thinner, 1e-6);
  const double load = expected.integrals.hydrodynamic_load;
  EXPECT_NEAR(thinned.integrals.hydrodynamic_load, load, 1e-6 * load);
  EXPECT_NEAR(thinned.integrals.shear_couette, expected.integrals.shear_couette,
              1e-6 * expected.integrals.shear_couette);
}

FactorLaws rough(double sigma, double gamma) {
  FactorLaws laws;
  const models::PatirCheng factors(gamma);
  laws.pressure_flow = laws.shear_flow = laws.stress = factors;
  laws.average_gap = AverageGap::kTruncated;
  laws.sigma = sigma;
  laws.share_difference = -0.4;
  return laws;
}

TEST(FlowFactors, ThickFilmsAreThoseOfSmoothWalls) {
  const SmoothFilm film = film_of(slope);
  const FilmInputs inputs = inputs_of(film);
  const Solved smooth = solved_at(film, {}, inputs, 1e-6), solved = solved_at(film, rough(5e-8, 1), inputs, 1e-6);
  EXPECT_NEAR(solved.integrals.hydrodynamic_load, smooth.integrals.hydrodynamic_load,
              3e-3 * smooth.integrals.hydrodynamic_load);
  EXPECT_NEAR(solved.integrals.shear_couette, smooth.integrals.shear_couette, 5e-3 * smooth.integrals.shear_couette);
}

TEST(FlowFactors, KeepTheMassOfTheFilm) {
  const SmoothFilm film = film_of([](double x) { return 20e-6 * std::pow(2 * x / kWidth - 1, 2); });
  FilmInputs inputs = inputs_of(film);
  inputs.time_step = 1e-4;
  FactorLaws laws = rough(4e-7, 1.0 / 3);
  laws.thinning = cross(0.6, 2e6);
  const FactorIteration iteration(film.problem, laws);
  FilmWorkspace workspace(film.problem);
  FilmState previous = solved_at(film, laws, inputs_of(film), 1e-6).state, state = previous;
  state.h_m = 0.9e-6;
  const FilmReport report = iteration.solve(inputs, state, [&](const FilmInputs& held, FilmState& found) {
    return solve_film_at_separation(film.problem, held, previous, found, workspace);
  });
  ASSERT_TRUE(report.converged);
  const FilmIntegrals sums = film_integrals(film.problem, inputs, previous, state);
  EXPECT_GT(sums.cavitated_fraction, 0);
  EXPECT_LT(std::abs(sums.mass_defect), 1e-9 * std::abs(sums.flow_middle));
}

TEST(FlowFactors, ShearFlowIsWhatTheRougherWallCarries) {
  const SmoothFilm film = film_of([](double) { return 0.0; });
  const FilmInputs inputs = inputs_of(film);
  FactorLaws laws;
  laws.shear_flow = models::PatirCheng(1);
  laws.sigma = 5e-7;
  laws.share_difference = 1;  // the moving wall alone is rough
  const double h = 1e-6, carried = h + laws.sigma * laws.shear_flow->shear_flow(h / laws.sigma);
  EXPECT_NEAR(solved_at(film, laws, inputs, h).integrals.flow_middle, 0.5 * kSpeed * carried, 1e-12);
}

TEST(FlowFactors, UnderALoadTheFilmIsThatOfItsOwnFactors) {
  const SmoothFilm film = film_of(slope);
  const FilmInputs inputs = inputs_of(film);
  const FactorLaws laws = rough(4e-7, 1);
  FilmWorkspace workspace(film.problem);
  const FilmState previous = first_guess(film.problem, inputs);
  FilmState state = previous;
  state.h_m = 3e-6;
  int passes = 0;
  const FilmReport report =
      FactorIteration(film.problem, laws).solve(inputs, state, [&](const FilmInputs& held, FilmState& found) {
        ++passes;
        return solve_film(film.problem, held, previous, found, workspace);
      });
  ASSERT_TRUE(report.converged);
  EXPECT_LE(passes, 8);
  const auto own = flow_factors(laws, film.problem, inputs, state, state.h_m);
  EXPECT_LT(difference(*state.factors, *own, film.problem.grid, state.h_m), 1e-8);
  EXPECT_NEAR(film_integrals(film.problem, inputs, previous, state).hydrodynamic_load, inputs.load, 1e-8 * inputs.load);
}

}  // namespace
}  // namespace ringfilm::film::testing
