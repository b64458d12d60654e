#include "ringfilm/film/elastic_face.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "film_cases.hpp"

/// Face and liner that give way to the pressure between them.
namespace ringfilm::film::testing {
namespace {

constexpr double kWidth = 1e-3, kModulus = 200e9;

FilmState pressed(const FilmGrid& grid, const std::function<double(double)>& pressure) {
  FilmState state;
  state.h_m = 1e-6;
  for (const double x : grid.x) state.p.push_back(pressure(x));
  return state;
}

/// Hertz: p = p_0 sqrt(1 - x^2/a^2) flattens a parabola of the radius R = a E'/(4 p_0) over 2 a.
TEST(ElasticFace, APressureOfHertzFlattensAParabola) {
  SmoothFilm film(
      2000, kWidth, [](double) { return 0.0; }, 0.01, Cavitation::kReynoldsExit);
  const double a = 0.2 * kWidth, p_0 = 5e6, R = a * kModulus / (4 * p_0);
  const auto hertz = [&](double x) {
    const double at = (x - 0.5 * kWidth) / a;
    return std::abs(at) < 1 ? p_0 * std::sqrt(1 - at * at) : 0;
  };
  const ElasticFace face(film.problem.grid, kModulus);
  const FilmState state = pressed(film.problem.grid, hertz);
  const std::vector<double> u = face.displacement(film.problem, film.inputs(), state);
  const std::size_t middle = u.size() / 2;
  EXPECT_NEAR(u.front() + u.back(), 0, 1e-15);
  for (const double share : {0.25, 0.5, 0.75}) {
    const auto i = middle + static_cast<std::size_t>(std::lround(share * 0.2 * 2000));
    EXPECT_NEAR((u[middle] - u[i]) / (share * share * a * a / (2 * R)), 1, 2e-3) << share;
  }
  // Beyond the contact (johnson1985, eq. 4.47): a^2/(2 R) (r sqrt(r^2 - 1) - ln(r + sqrt(r^2 - 1))) more than R.
  const double r = 0.5 * kWidth / a, root = std::sqrt(r * r - 1);
  const double outside = a * a / (2 * R) * (r * r - (r * root - std::log(r + root)));
  EXPECT_NEAR(u[middle] / outside, 1, 2e-3);
}

/// Pressures that act beyond the edges, too, do not shape the gap.
TEST(ElasticFace, TheStraightLineBetweenTheEdgesIsNotLocal) {
  SmoothFilm film(
      100, kWidth, [](double) { return 0.0; }, 0.01, Cavitation::kReynoldsExit);
  FilmInputs inputs = film.inputs();
  inputs.left.pressure = 6e6;
  inputs.right.pressure = 1e5;
  const FilmState state = pressed(film.problem.grid, [](double x) { return 6e6 - 5.9e6 * x / kWidth; });
  for (const double u : ElasticFace(film.problem.grid, kModulus).displacement(film.problem, inputs, state)) {
    EXPECT_NEAR(u, 0, 1e-15);
  }
}

/// The lowest place stays where h_m counts from.
TEST(ElasticFace, TheGapIsLaidWithItsLowestPlaceWhereItWas) {
  const auto crown = [](double x) { return 3 * (x - 0.4 * kWidth) * (x - 0.4 * kWidth); };
  SmoothFilm film(100, kWidth, crown, 0.01, Cavitation::kReynoldsExit);
  const ElasticFace face(film.problem.grid, kModulus);
  std::vector<double> u;
  for (const double x : film.problem.grid.x) u.push_back(1e-7 * std::exp(-std::pow((x - 0.4 * kWidth) / 1e-4, 2)));
  face.lay(u, film.problem.grid);
  const auto& heights = film.problem.grid.node_height;
  EXPECT_NEAR(*std::min_element(heights.begin(), heights.end()), 0, 1e-15);
  const auto lowest = [](const std::vector<double>& h) { return std::min_element(h.begin(), h.end()) - h.begin(); };
  EXPECT_NE(lowest(heights), lowest(face.unloaded().node_height));  // it was pressed away
  EXPECT_NEAR(heights[0] - heights[1], face.unloaded().node_height[0] - face.unloaded().node_height[1] + u[0] - u[1],
              1e-18);
  face.lay(std::vector<double>(u.size(), 0.0), film.problem.grid);
  EXPECT_EQ(heights, face.unloaded().node_height);
}

/// A slider under load: pressure and gap agree, and a hundred times stiffer faces are rigid ones.
TEST(ElasticFace, FilmAndDeformationAgree) {
  const auto crown = [](double x) { return 8 * (x - 0.5 * kWidth) * (x - 0.5 * kWidth); };
  double rigid = 0;
  for (const double modulus : {0.0, 100 * kModulus, kModulus}) {
    SmoothFilm film(200, kWidth, crown, 0.02, Cavitation::kMassConserving);
    FilmInputs inputs = film.inputs();
    inputs.U = 5;
    inputs.load = 2000;
    FilmWorkspace workspace(film.problem);
    FilmState state = first_guess(film.problem, inputs);
    const FilmState before = state;
    const auto solve = [&](FilmState& found) { return solve_film(film.problem, inputs, before, found, workspace); };
    if (modulus == 0) {
      ASSERT_TRUE(solve(state).converged);
      rigid = state.h_m;
      continue;
    }
    const ElasticFace face(film.problem.grid, modulus);
    ASSERT_TRUE(face.solve(film.problem, inputs, state, solve).converged);
    const std::vector<double> u = face.displacement(film.problem, inputs, state);
    for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(u[i], state.deformation[i], 1e-8 * state.h_m);
    if (modulus == kModulus) {
      EXPECT_GT(state.h_m / rigid, 1.005);  // a flatter gap carries more
    } else {
      EXPECT_NEAR(state.h_m / rigid, 1, 5e-4);
    }
  }
}

}  // namespace
}  // namespace ringfilm::film::testing
