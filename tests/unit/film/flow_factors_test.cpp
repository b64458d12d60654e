#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
  const FilmHeating &heat = thinned.integrals.heating, &heat_of_thinner = expected.integrals.heating;
  EXPECT_NEAR(heat.dissipation, heat_of_thinner.dissipation, 1e-6 * heat_of_thinner.dissipation);
  EXPECT_NEAR(heat.conductance, heat_of_thinner.conductance, 1e-6 * heat_of_thinner.conductance);
  EXPECT_NEAR(heat.mass_flow, heat_of_thinner.mass_flow, 1e-6 * heat_of_thinner.mass_flow);
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
  EXPECT_LT(difference(*state.factors, *own, film_heights(film.problem.grid, state.h_m)), 1e-8);
  EXPECT_NEAR(film_integrals(film.problem, inputs, previous, state).hydrodynamic_load, inputs.load, 1e-8 * inputs.load);
}

/// The factors of waves of this amplitude across the motion, on the wall at rest, by their closed forms: those of a
/// "measured" gap.
models::FlowTable waves_across(double amplitude) {
  models::FlowTable table;
  table.sigma = amplitude / std::numbers::sqrt2;
  for (int k = 0; k <= 160; ++k) table.gap.push_back(1e-8 * std::pow(10, k / 40.0));
  for (int row = 0; row < 40; ++row) {
    const double h = (0.8 + 0.075 * row) * 1e-6, e = amplitude / h, across = 1 + e * e / 2, rest = 1 - e * e;
    table.h.push_back(h);
    table.pressure_flow_x.push_back(std::pow(rest, 2.5) / across);
    table.pressure_flow_y.push_back(1 + 1.5 * e * e);
    table.shear_flow.push_back(h * (1 - rest / across) / table.sigma);
    table.pressure_stress.push_back(rest / across);
    table.mean_gap.push_back(h);
    auto& share = table.gap_share.emplace_back(table.gap.size(), 0.0);
    constexpr int kPhases = 2000;
    for (int i = 0; i < kPhases; ++i) {
      const double H = h + amplitude * std::cos(2 * std::numbers::pi * (i + 0.5) / kPhases);
      const auto k = static_cast<std::size_t>(std::max(0.0, 40 * std::log10(H / 1e-8)));
      const double upper = std::max(0.0, (H - table.gap[k]) / (table.gap[k + 1] - table.gap[k]));
      share[k] += (1 - upper) / kPhases;
      share[k + 1] += upper / kPhases;
    }
  }
  return table;
}

TEST(FlowFactors, OfAMeasuredGapGiveTheFilmThatResolvesItsWaves) {
  // The same wavy slider twice: each wave on the grid between smooth walls, and their averages.
  constexpr double kAmplitude = 0.5e-6, kWaves = 60, h_m = 1e-6;
  SmoothFilm resolved(
      3600, kWidth,
      [](double x) { return slope(x) + kAmplitude * (1 + std::cos(2 * std::numbers::pi * kWaves * x / kWidth)); }, kEta,
      Cavitation::kMassConserving);
  const SmoothFilm film = film_of(slope);
  FilmInputs inputs = inputs_of(film);
  inputs.left.pressure = inputs.right.pressure = 2e7;  // no cavity
  FilmInputs of_resolved = inputs;
  of_resolved.oil = resolved.oil;
  const Solved exact = steady_at(resolved.problem, of_resolved, h_m - kAmplitude);
  FactorLaws laws;
  const auto flow = std::make_shared<const models::MeasuredFlow>(waves_across(kAmplitude));
  laws.measured = {flow, flow, flow, flow, 1e12};
  const Solved averaged = solved_at(film, laws, inputs, h_m), smooth = solved_at(film, {}, inputs, h_m);
  ASSERT_TRUE(exact.report.converged && averaged.report.converged);
  const auto load = [](const Solved& of) { return of.integrals.hydrodynamic_load - 2e7 * kWidth; };
  EXPECT_NEAR(load(averaged) / load(exact), 1, 0.02);
  EXPECT_GT(std::abs(load(smooth) / load(exact) - 1), 0.2);
  EXPECT_NEAR(averaged.integrals.flow_middle / exact.integrals.flow_middle, 1, 0.01);
  EXPECT_NEAR(averaged.integrals.shear_couette / exact.integrals.shear_couette, 1, 0.01);
  // What the pressures of single waves make of the stress, 3 eta U <H dw/dx>, is not part of the averages: here it is
  // known.
  double of_waves = 0;
  for (std::size_t i = 0; i < film.problem.grid.face_height.size(); ++i) {
    const double h = h_m + film.problem.grid.face_height[i], e = kAmplitude / h;
    of_waves +=
        film.problem.grid.spacing[i] * kEta * kSpeed / h * 1.5 * e * e / (std::sqrt(1 - e * e) * (1 + e * e / 2));
  }
  EXPECT_NEAR((averaged.integrals.shear_poiseuille + of_waves) / exact.integrals.shear_poiseuille, 1, 0.02);
}

TEST(FlowFactors, OfAMeasuredGapLimitTheStressByThatOfTheOil) {
  const SmoothFilm film = film_of([](double) { return 0.0; });
  const FilmInputs inputs = inputs_of(film);
  FactorLaws laws;
  const auto flow = std::make_shared<const models::MeasuredFlow>(waves_across(0.799e-6));
  laws.measured = {nullptr, nullptr, flow, nullptr, 1e12};
  const double h = 0.8e-6, newtonian = solved_at(film, laws, inputs, h).integrals.shear_couette;
  laws.measured.eyring_stress = 1e4;
  const double limited = solved_at(film, laws, inputs, h).integrals.shear_couette;
  EXPECT_LT(limited, 0.7 * newtonian);
  // Between the largest and the smallest gap the stress rises with the logarithm of their ratio only.
  EXPECT_LT(limited, kWidth * 1e4 * std::asinh(kEta * kSpeed / 1e-9 / 1e4));
  EXPECT_GT(limited, kWidth * 1e4 * std::asinh(kEta * kSpeed / 1.6e-6 / 1e4));
}

}  // namespace
}  // namespace ringfilm::film::testing
