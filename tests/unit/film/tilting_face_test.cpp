#include "ringfilm/film/tilting_face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

/// A face that turns with its section.
namespace ringfilm::film::testing {
namespace {

constexpr double kFaceWidth = 1.2e-3;

FilmProblem problem_of_parabola() {
  FilmProblem problem;
  problem.grid = uniform_grid(200, kFaceWidth, [](double x) { return 10e-6 * std::pow(2 * x / kFaceWidth - 1, 2); });
  problem.tolerance = 1e-8;
  return problem;
}

/// A film that is always found, and the ring that asks for a tilt after its own.
struct Turned {
  FilmState state;
  FilmReport report;
  int films = 0;
};
Turned turned(const std::function<double(double)>& asked, double begin = 0) {
  FilmProblem problem = problem_of_parabola();
  const TiltingFace face(problem.grid);
  Turned result;
  result.state.tilt = begin;
  const auto film = [&](FilmState& state) {
    ++result.films;
    state.h_m = 1e-6;
    FilmReport report;
    report.converged = true;
    report.failure = Failure::kNone;
    return report;
  };
  result.report = face.solve(problem, result.state, film, [&](const FilmState& state) { return asked(state.tilt); });
  return result;
}

TEST(TiltingFace, PositiveTiltTakesTheChamberEdgeAwayAndKeepsTheLowestPlace) {
  FilmProblem problem = problem_of_parabola();
  const TiltingFace face(problem.grid);
  const FilmGrid level = problem.grid;
  constexpr double kTilt = 2e-3;
  face.lay(kTilt, problem.grid);
  const auto& height = problem.grid.node_height;
  EXPECT_NEAR(*std::min_element(height.begin(), height.end()), 0, 1e-18);
  EXPECT_NEAR(height.front() - height.back(), kTilt * kFaceWidth, 1e-15);
  // The parabola with its radius b^2/(8 c) has its lowest place a tilt times that radius farther down.
  const auto lowest = std::min_element(height.begin(), height.end()) - height.begin();
  const double radius = kFaceWidth * kFaceWidth / (8 * 10e-6);
  EXPECT_NEAR(problem.grid.x[lowest] - kFaceWidth / 2, kTilt * radius, kFaceWidth / 200);
  face.lay(0, problem.grid);
  EXPECT_EQ(problem.grid.node_height, level.node_height);
  EXPECT_EQ(problem.grid.face_height, level.face_height);
}

TEST(TiltingFace, FilmAndSectionAgreeOnTheTilt) {
  for (const double gain : {0.0, 0.5, 2.0, 10.0}) {
    const Turned found = turned([gain](double tilt) { return 2e-3 - gain * tilt; });
    EXPECT_TRUE(found.report.converged);
    EXPECT_NEAR(found.state.tilt, 2e-3 / (1 + gain), 1e-8) << gain;
    EXPECT_LE(found.films, 8) << gain;
  }
  const Turned bent = turned([](double tilt) { return 1e-3 * std::exp(-2e3 * tilt); }, 3e-3);
  EXPECT_NEAR(bent.state.tilt, 1e-3 * std::exp(-2e3 * bent.state.tilt), 1e-7);
}

TEST(TiltingFace, ARingThatAFlankHoldsStaysFlat) {
  const Turned found = turned([](double) { return 0.0; }, 1e-3);
  EXPECT_NEAR(found.state.tilt, 0, 1e-8);
  EXPECT_LE(found.films, 4);
  EXPECT_EQ(turned([](double) { return 0.0; }).films, 1);
}

TEST(TiltingFace, WithoutAnAgreementTheTiltOfTheStepBeforeIsKept) {
  const Turned found = turned([](double tilt) { return tilt + (tilt > 1e-3 ? -1e-3 : 1e-3); }, 5e-4);  // jumps
  EXPECT_TRUE(found.report.converged);
  EXPECT_EQ(found.state.tilt, 5e-4);
}

}  // namespace
}  // namespace ringfilm::film::testing
