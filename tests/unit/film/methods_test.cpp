#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "film_cases.hpp"
#include "ringfilm/film/solver/method.hpp"

namespace ringfilm::film::testing {
namespace methods {
namespace {

constexpr double kWidth = 0.01;     // [m]
constexpr double kRise = 30e-6;     // over the width [m]
constexpr double kViscosity = 0.1;  // [Pa s]
constexpr double kSpeed = 1;        // [m/s]
constexpr double kLoad = 2e4;       // [N/m]

SmoothFilm inclined_slider(int n_cells) {
  return {n_cells, kWidth, [](double x) { return kRise * (1 - x / kWidth); }, kViscosity, Cavitation::kMassConserving};
}

FilmInputs sliding(const SmoothFilm& slider) {
  FilmInputs inputs = slider.inputs();
  inputs.U = kSpeed;
  inputs.load = kLoad;
  return inputs;
}

/// Load of the infinitely wide inclined slider [N/m] (rayleigh1918).
double closed_form_load(double h_0) {
  const double K = kRise / h_0;
  const double W = 6 * (std::log1p(K) / (K * K) - 2 / (K * (2 + K)));
  return W * kViscosity * kSpeed * kWidth * kWidth / (h_0 * h_0);
}

/// A workspace of each method.
std::vector<MethodWorkspace> workspaces(const FilmProblem& problem) {
  std::vector<MethodWorkspace> each;
  each.emplace_back(FilmWorkspace(problem));
  each.emplace_back(RelaxationWorkspace());
  return each;
}

TEST(Methods, EveryOneFindsTheFilmOfTheInclinedSlider) {
  const SmoothFilm slider = inclined_slider(128);
  const FilmState previous = first_guess(slider.problem, sliding(slider));
  for (MethodWorkspace& workspace : workspaces(slider.problem)) {
    FilmState state = previous;
    state.h_m *= 1.5;
    state.p.assign(state.p.size(), 0.0);
    const FilmReport report = solve_film(slider.problem, sliding(slider), previous, state, workspace);
    ASSERT_TRUE(report.converged);
    EXPECT_EQ(report.failure, Failure::kNone);
    // Second order: a few times the square of a cell. Seen 7 times.
    EXPECT_NEAR(closed_form_load(state.h_m) / kLoad, 1, 10.0 / (128 * 128));
  }
}

TEST(Methods, ARelaxationThatDoesNotConvergeReportsItInBoundedTime) {
  const SmoothFilm slider = inclined_slider(64);
  const FilmState previous = first_guess(slider.problem, sliding(slider));
  FilmState state = previous;
  state.h_m *= 1.5;
  RelaxationWorkspace crawling({0.001});
  const FilmReport report = solve_by_point_relaxation(slider.problem, sliding(slider), previous, state, crawling);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.failure, Failure::kNotConverged);
  EXPECT_LE(report.sweeps, 1000 + 100 * 64);
}

// Scratch memory carries nothing from one solve to the next: the same film, to the last bit, whatever came before.
TEST(Methods, AUsedWorkspaceGivesTheSameBits) {
  const SmoothFilm slider = inclined_slider(64);
  const FilmState previous = first_guess(slider.problem, sliding(slider));
  for (MethodWorkspace& workspace : workspaces(slider.problem)) {
    const auto solved = [&] {
      FilmState state = previous;
      state.h_m *= 1.5;
      EXPECT_TRUE(solve_film(slider.problem, sliding(slider), previous, state, workspace).converged);
      return state;
    };
    const FilmState first = solved();
    const FilmState second = solved();
    EXPECT_EQ(first.h_m, second.h_m);
    EXPECT_EQ(first.p, second.p);
  }
}

TEST(Methods, TheChosenFactorIsCloseToTheBest) {
  const SmoothFilm slider = inclined_slider(64);
  const FilmState previous = first_guess(slider.problem, sliding(slider));
  const auto sweeps = [&](RelaxationFactor factor) {
    RelaxationWorkspace workspace(factor);
    FilmState state = previous;
    state.h_m *= 1.5;
    const FilmReport report = solve_by_point_relaxation(slider.problem, sliding(slider), previous, state, workspace);
    EXPECT_TRUE(report.converged);
    return report.sweeps;
  };
  const long chosen = sweeps({});
  long fewest = chosen;
  for (double factor = 1.5; factor < 1.99; factor += 0.02) fewest = std::min(fewest, sweeps({factor}));
  // Young's best factor is of the long run; a short one may do better.
  EXPECT_LT(static_cast<double>(chosen), 1.5 * static_cast<double>(fewest));
}

}  // namespace
}  // namespace methods
}  // namespace ringfilm::film::testing
