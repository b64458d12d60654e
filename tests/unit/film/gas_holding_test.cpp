#include "ringfilm/film/gas_holding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "film_cases.hpp"
#include "gas_edge_cases.hpp"

/// The largest pressure difference that a film holds against gas, against the closed form of a parabola and against
/// the solver.
namespace ringfilm::film::testing {
namespace {

/// A parabola of radius R over `reach` times sqrt(2 R h_0) to both sides.
FilmGrid long_parabola(double R, double h_0, double reach, int n_cells) {
  const double half = reach * std::sqrt(2 * R * h_0);
  return uniform_grid(n_cells, 2 * half, [=](double x) { return (x - half) * (x - half) / (2 * R); });
}

TEST(GasHolding, OfALongParabolaIsTheClosedForm) {
  // 12 eta u int (h - h_0)/h^3 dx up to the throat, with h = h_0/cos^2 g: sin^2 cos^2 over a quarter turn is pi/16.
  const double R = 0.02, h_0 = 1e-6;
  const double J = gas_holding_integral(long_parabola(R, h_0, 200, 100000), h_0, FilmEdge::kRight);
  const double constant = 12 * J * std::pow(h_0, 1.5) / std::sqrt(R);
  EXPECT_NEAR(constant, 0.75 * std::numbers::pi * std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(constant, 3.332162, 1e-5);
}

TEST(GasHolding, DoesNotDependOnTheSideOfTheGas) {
  const FilmGrid grid = uniform_grid(300, 1.2e-3, [](double x) { return 8e-6 * std::pow(x / 0.5e-3 - 1, 2); });
  const FilmGrid turned =
      uniform_grid(300, 1.2e-3, [](double x) { return 8e-6 * std::pow((1.2e-3 - x) / 0.5e-3 - 1, 2); });
  const double J = gas_holding_integral(grid, 1e-6, FilmEdge::kRight);
  EXPECT_GT(J, 0);
  EXPECT_NEAR(gas_holding_integral(turned, 1e-6, FilmEdge::kLeft) / J, 1, 1e-12);
}

TEST(GasHolding, IsNothingWhereTheGapOnlyOpens) {
  const FilmGrid opening = uniform_grid(100, 1e-3, [](double x) { return 0.01 * x; });
  EXPECT_EQ(gas_holding_integral(opening, 1e-6, FilmEdge::kRight), 0);
  EXPECT_GT(gas_holding_integral(opening, 1e-6, FilmEdge::kLeft), 0);
}

TEST(GasHolding, TakesTheBetterOfTwoLowPlaces) {
  // Behind the throat of 0 a second one, 0.01 um higher: the film in front of it holds gas, too. By brute force.
  const auto height = [](double x) { return 4e-6 * std::pow(std::sin(x * std::numbers::pi / 0.5e-3), 2) + 2e-5 * x; };
  const FilmGrid grid = uniform_grid(4000, 1.25e-3, height);
  double best = 0;
  for (int k = 0; k <= grid.n_cells(); k += 10) {
    const double h_exit = 0.5e-6 + height(grid.x[k]);
    const auto slope = [&](double x) {
      const double h = 0.5e-6 + height(x);
      return (h - h_exit) / (h * h * h);
    };
    if (k > 0) best = std::max(best, integral(slope, 0, grid.x[k]));
  }
  EXPECT_NEAR(gas_holding_integral(grid, 0.5e-6, FilmEdge::kRight) / best, 1, 1e-4);
}

TEST(GasHolding, IsWhereTheSolverLosesTheFilm) {
  const GasFilm form = flooded();
  SmoothFilm film(
      960, form.width, [&](double x) { return form.height(x) - form.h_m; }, form.eta, Cavitation::kMassConserving);
  film.problem.terms = Terms::kAll;
  FilmInputs inputs = inputs_of(form, film);
  const double h_m = 1.2e-6;
  const double held = 6 * inputs.U * gas_holding_integral(film.problem.grid, h_m, FilmEdge::kRight) *
                      mean_viscosity(*film.oil, inputs.left.pressure, inputs.right.pressure);
  for (const auto& [share, is_lost] : {std::pair{0.98, false}, std::pair{1.02, true}}) {
    inputs.right.pressure = inputs.left.pressure + share * held;
    const Solved solved = steady_at(film.problem, inputs, h_m);
    ASSERT_TRUE(solved.report.converged) << share;
    EXPECT_EQ(solved.integrals.is_broken_through, is_lost) << share;
  }
}

TEST(GasHolding, AFlatFaceThatIsDryThroughoutIsFullOfGas) {
  SmoothFilm film(
      60, 1.2e-3, [](double) { return 0.0; }, 5e-3, Cavitation::kMassConserving);
  film.problem.terms = Terms::kAll;
  FilmInputs inputs = inputs_of(flooded(), film);
  inputs.left = {5e5, EdgeFluid::kGas};
  inputs.right = {1e5, EdgeFluid::kGas};
  FilmState dry;
  dry.h_m = 1e-6;
  dry.p.assign(61, 1e5);
  dry.deficit.assign(61, 0.9);
  dry.mass_per_area.assign(61, 0.0);
  const FilmIntegrals integrals = film_integrals(film.problem, inputs, dry, dry);
  EXPECT_TRUE(integrals.is_broken_through);
  EXPECT_LT(integrals.cavitated_fraction, 1e-12);
  // A film that has left one node of its edge holds the gas in the rest.
  std::fill(dry.deficit.begin() + 2, dry.deficit.end(), 0.0);
  EXPECT_FALSE(film_integrals(film.problem, inputs, dry, dry).is_broken_through);
}

TEST(GasHolding, TakesTheViscosityUnderPressure) {
  // Barus: the mean of 1/eta between 0 and p is (1 - exp(-alpha p))/(alpha p eta_0).
  const double alpha = 2e-8, p = 60e5, eta_0 = 5e-3;
  const auto oil = models::closed_form_oil(eta_0, 1.0, 0.0, {0.0, 0.0});
  EXPECT_NEAR(mean_viscosity(*oil, 0, p) / eta_0, 1, 1e-12);
  struct Barus : models::OilAtTemperature {
    void properties(std::span<const double> at, models::OilProperties out) const override {
      for (std::size_t i = 0; i < at.size(); ++i) {
        out.eta[i] = 5e-3 * std::exp(2e-8 * at[i]);
        out.deta_dp[i] = 2e-8 * out.eta[i];
        out.rho[i] = 850;
        out.drho_dp[i] = 0;
      }
    }
  };
  EXPECT_NEAR(mean_viscosity(Barus{}, 0, p) / (eta_0 * alpha * p / (1 - std::exp(-alpha * p))), 1, 1e-7);
}

}  // namespace
}  // namespace ringfilm::film::testing
