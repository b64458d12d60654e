#include <gtest/gtest.h>

#include "film2d_cases.hpp"
#include "film_cases.hpp"
#include "gas_edge_cases.hpp"

namespace ringfilm::film::testing {
namespace {

// Strips of a ring without a gap are the film across the face.
TEST(GasEdge, StripsHoldTwentyBarAtTheExitOfAStarvedFilm) {
  const testing::GasFilm form = testing::starved(0.58e-6);
  testing::SmoothFilm film(
      240, form.width, [&](double x) { return form.height(x) - form.h_m; }, form.eta, Cavitation::kMassConserving);
  film.problem.terms = Terms::kAll;
  film.problem.tolerance = 1e-8;
  for (const Ends ends : {Ends::kClosed, Ends::kJoined}) {
    const Film2dProblem problem = film2d_of(film.problem, uniform_around(7, 0.01, ends));
    Film2dInputs inputs;
    inputs.strip = testing::inputs_of(form, film);
    const FilmState strip = first_guess(film.problem, inputs.strip);
    FilmState film2d = of_strips(problem, strip);
    const FilmState before = film2d;
    film2d.h_m = 1.3 * form.h_m;
    Film2dWorkspace workspace(problem);
    const FilmReport report = solve_film2d(problem, inputs, before, film2d, workspace);
    ASSERT_TRUE(report.converged);
    EXPECT_NEAR(film2d.h_m / form.h_m, 1, 1e-3);
    const testing::Solved across = testing::steady_under_load(film.problem, inputs.strip, 1.3 * form.h_m);
    EXPECT_NEAR(film2d.h_m / across.state.h_m, 1, 1e-7);
  }
}

}  // namespace
}  // namespace ringfilm::film::testing
