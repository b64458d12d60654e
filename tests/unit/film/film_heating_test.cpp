#include "ringfilm/film/integrals/film_heating.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "film_cases.hpp"

/// The heat of a film against closed forms of flow between parallel plates.
namespace ringfilm::film::testing {
namespace {

constexpr double kLength = 1e-3, kGap = 1e-6, kEta = 5.06e-3;

SmoothFilm parallel_plates() {
  return {50, kLength, [](double) { return 0.0; }, kEta, Cavitation::kMassConserving};
}

FilmState film_between(const SmoothFilm& film, double p_left, double p_right) {
  FilmState state;
  state.h_m = kGap;
  for (const double x : film.problem.grid.x) state.p.push_back(p_left + (p_right - p_left) * x / kLength);
  state.deficit.assign(state.p.size(), 0);
  return state;
}

/// Mean of the temperature above that of both walls, of a film sheared at U/h: k T'' + eta (U/h)^2 = 0 on a fine grid.
double mean_rise_by_differences(double U, double conductivity) {
  constexpr int n = 2000;
  const double dy = kGap / n, source = kEta * std::pow(U / kGap, 2) * dy * dy / conductivity;
  std::vector<double> factor(n, 0.0), T(n + 1, 0.0);
  for (int i = 1; i < n; ++i) {  // the tridiagonal matrix (-1, 2, -1)
    factor[i] = 1 / (2 - factor[i - 1]);
    T[i] = (source + T[i - 1]) * factor[i];
  }
  double sum = 0;
  for (int i = n - 1; i > 0; --i) {
    T[i] += factor[i] * T[i + 1];
    sum += T[i];
  }
  return sum / n;
}

TEST(FilmHeating, IsThatOfCouetteFlowWithoutConvection) {
  const SmoothFilm film = parallel_plates();
  FilmInputs inputs = film.inputs();
  for (const auto& [U, expected] : {std::pair{6.5, 0.127}, std::pair{23.8, 1.71}}) {
    inputs.U = U;
    const double rise = film_heating(film.problem, inputs, film_between(film, 1e5, 1e5)).rise(0.14, 0);
    EXPECT_NEAR(rise, kEta * U * U / (12 * 0.14), 1e-12 * rise);
    EXPECT_NEAR(rise, expected, 0.005 * expected);
    EXPECT_NEAR(rise, mean_rise_by_differences(U, 0.14), 1e-6 * rise);
  }
}

TEST(FilmHeating, WithoutConductionWarmsTheOilByTheWorkDone) {
  // Pressure flow between plates at rest: each cubic metre loses p_left - p_right.
  const SmoothFilm film = parallel_plates();
  const FilmState state = film_between(film, 30e5, 1e5);
  const FilmHeating heating = film_heating(film.problem, film.inputs(), state);
  const double volume_flow = std::pow(kGap, 3) * 29e5 / (12 * kEta * kLength);
  EXPECT_NEAR(heating.dissipation, volume_flow * 29e5, 1e-12 * heating.dissipation);
  EXPECT_NEAR(heating.mass_flow, film.oil->density(0) * volume_flow, 1e-12 * heating.mass_flow);
  EXPECT_NEAR(heating.rise(0, 2100), 29e5 / (film.oil->density(0) * 2100), 1e-9);
}

TEST(FilmHeating, CountsTheFullFilmAlone) {
  const SmoothFilm film = parallel_plates();
  FilmInputs inputs = film.inputs();
  inputs.U = 6.5;
  inputs.p_cavitation = 1e5;
  FilmState state = film_between(film, 1e5, 1e5);
  const FilmHeating full = film_heating(film.problem, inputs, state);
  for (std::size_t i = 26; i < state.deficit.size(); ++i) state.deficit[i] = 0.5;  // 25 of 50 cells, and the next one
  const FilmHeating half = film_heating(film.problem, inputs, state);
  // A film of one pressure shows no front in the cell: all of it counts.
  EXPECT_NEAR(half.dissipation, 0.52 * full.dissipation, 1e-12 * full.dissipation);
  EXPECT_NEAR(half.conductance, 0.52 * full.conductance, 1e-12 * full.conductance);
  EXPECT_NEAR(half.mass_flow, full.mass_flow, 1e-12 * full.mass_flow);
  state.deficit.assign(state.p.size(), 0.5);
  EXPECT_EQ(film_heating(film.problem, inputs, state).rise(0.14, 2100), 0);
}

TEST(FilmHeating, TheEndOfAFilmBetweenNodesHasItsSlope) {
  const SmoothFilm film = parallel_plates();
  FilmInputs inputs = film.inputs();
  inputs.U = -6.5;  // the film forms again at its right end
  inputs.p_cavitation = 0;
  const double p_left = 1e6, length = 0.513 * kLength, slope = -p_left / length;
  FilmState state = film_between(film, p_left, p_left + slope * kLength);
  for (std::size_t i = 0; i < state.p.size(); ++i) {
    if (state.p[i] > 0) continue;
    state.p[i] = 0;
    state.deficit[i] = 0.5;
  }
  const double pressure_flow = std::pow(kGap, 3) * slope / (12 * kEta);
  const double flow = 0.5 * inputs.U * kGap - pressure_flow;
  const FilmHeating heating = film_heating(film.problem, inputs, state);
  EXPECT_NEAR(heating.conductance, length / kGap, 1e-9 * length / kGap);
  EXPECT_NEAR(heating.mass_flow, inputs.oil->density(0) * std::abs(flow), 1e-9 * heating.mass_flow);
  const double per_length = kEta * inputs.U * inputs.U / kGap + pressure_flow * slope;
  EXPECT_NEAR(heating.dissipation, length * per_length, 1e-9 * heating.dissipation);
}

/// Factors that are the same everywhere.
std::shared_ptr<const FlowFactors> uniform_factors(const FilmGrid& grid, double thinning, double pressure_flow) {
  auto factors = std::make_shared<FlowFactors>();
  factors->thinning.assign(grid.x.size(), thinning);
  factors->mobility.assign(grid.x.size(), pressure_flow / thinning);
  factors->carried.assign(grid.spacing.size(), 0.2 * kGap);
  factors->sliding_stress.assign(grid.spacing.size(), 1.5);
  return factors;
}

TEST(FilmHeating, OfAnOilThatThinsBetweenRoughWallsMatchesClosedForm) {
  const SmoothFilm film = parallel_plates();
  FilmInputs inputs = film.inputs();
  inputs.U = -6.5;
  inputs.p_cavitation = 0;
  const double thinning = 0.7, pressure_flow_factor = 0.6, eta = thinning * kEta;
  const auto expect = [&](const FilmState& state, double slope, double length) {
    const double pressure_flow = pressure_flow_factor * std::pow(kGap, 3) * slope / (12 * eta);
    const double per_length = 1.5 * eta * inputs.U * inputs.U / kGap + pressure_flow * slope;
    const double flow = film.oil->density(0) * std::abs(0.5 * inputs.U * 1.2 * kGap - pressure_flow);
    const FilmHeating heating = film_heating(film.problem, inputs, state);
    EXPECT_NEAR(heating.dissipation, length * per_length, 1e-9 * heating.dissipation);
    EXPECT_NEAR(heating.conductance, 1.5 * length / kGap, 1e-9 * heating.conductance);
    EXPECT_NEAR(heating.mass_flow, flow, 1e-9 * flow);
  };
  FilmState state = film_between(film, 30e5, 1e5);
  state.factors = uniform_factors(film.problem.grid, thinning, pressure_flow_factor);
  expect(state, -29e5 / kLength, kLength);
  // A film that begins between two nodes.
  const double length = 0.513 * kLength, slope = -1e6 / length;
  FilmState part = film_between(film, 1e6, 1e6 + slope * kLength);
  part.factors = state.factors;
  for (std::size_t i = 0; i < part.p.size(); ++i) {
    if (part.p[i] > 0) continue;
    part.p[i] = 0;
    part.deficit[i] = 0.5;
  }
  expect(part, slope, length);
  // Without flow of oil the rise is that of the thinned viscosity: both walls take the heat of the rough gap.
  const FilmState even = [&] {
    FilmState of = film_between(film, 1e5, 1e5);
    of.factors = state.factors;
    return of;
  }();
  const double rise = film_heating(film.problem, inputs, even).rise(0.14, 0);
  EXPECT_NEAR(rise, eta * inputs.U * inputs.U / (12 * 0.14), 1e-9 * rise);
}

TEST(FilmHeating, OfAStripHasTheFactorsOfThatStrip) {
  const SmoothFilm film = parallel_plates();
  const FilmGrid& grid = film.problem.grid;
  FilmInputs inputs = film.inputs();
  inputs.U = 6.5;
  FilmState alone = film_between(film, 1e5, 20e5), strips = alone;
  strips.p.insert(strips.p.end(), alone.p.begin(), alone.p.end());
  strips.deficit.resize(strips.p.size(), 0.0);
  alone.factors = uniform_factors(grid, 0.7, 0.6);
  auto of_both = std::make_shared<FlowFactors>(*uniform_factors(grid, 0.9, 0.8));
  for (const auto list : kFactorLists) {
    const std::vector<double>& second = (*alone.factors).*list;
    ((*of_both).*list).insert(((*of_both).*list).end(), second.begin(), second.end());
  }
  strips.factors = of_both;
  const FilmHeating expected = film_heating(film.problem, inputs, alone);
  const FilmHeating second = film_heating(film.problem, inputs, strips, 1);
  EXPECT_EQ(second.dissipation, expected.dissipation);
  EXPECT_EQ(second.conductance, expected.conductance);
  EXPECT_EQ(second.mass_flow, expected.mass_flow);
}

TEST(FilmHeating, OfAStripIsThatOfAFilmAcrossTheFace) {
  const SmoothFilm film = parallel_plates();
  FilmInputs inputs = film.inputs();
  inputs.U = -6.5;
  const FilmState alone = film_between(film, 1e5, 20e5);
  FilmState strips = film_between(film, 1e5, 1e5);
  for (const double p : alone.p) strips.p.push_back(p);
  strips.deficit.resize(strips.p.size(), 0.0);
  const FilmHeating expected = film_heating(film.problem, inputs, alone);
  const FilmHeating second = film_heating(film.problem, inputs, strips, 1);
  EXPECT_EQ(second.dissipation, expected.dissipation);
  EXPECT_EQ(second.mass_flow, expected.mass_flow);
}

}  // namespace
}  // namespace ringfilm::film::testing
