#include <gtest/gtest.h>

#include "../film/film_cases.hpp"
#include "../film/gas_edge_cases.hpp"
#include "sheet_cases.hpp"

namespace ringfilm::sheet::testing {
namespace {

// Strips of a ring without a gap are the film across the face.
TEST(GasEdge, StripsHoldTwentyBarAtTheExitOfAStarvedFilm) {
  const film::testing::GasFilm form = film::testing::starved(0.58e-6);
  film::testing::SmoothFilm film(
      240, form.width, [&](double x) { return form.height(x) - form.h_m; }, form.eta,
      film::Cavitation::kMassConserving);
  film.problem.bounds = film::Bounds::kOwn;
  film.problem.tolerance = 1e-8;
  for (const Ends ends : {Ends::kClosed, Ends::kJoined}) {
    const SheetProblem problem = sheet_of(film.problem, uniform_around(7, 0.01, ends));
    SheetInputs inputs;
    inputs.strip = film::testing::inputs_of(form, film.problem.grid);
    const film::FilmState strip = film::first_guess(film.problem, inputs.strip);
    film::FilmState sheet = of_strips(problem, strip);
    const film::FilmState before = sheet;
    sheet.h_m = 1.3 * form.h_m;
    SheetWorkspace workspace(problem);
    const film::FilmReport report = solve_sheet(problem, inputs, before, sheet, workspace);
    ASSERT_TRUE(report.converged);
    EXPECT_NEAR(sheet.h_m / form.h_m, 1, 1e-3);
    const film::testing::Solved across = film::testing::steady_under_load(film.problem, inputs.strip, 1.3 * form.h_m);
    EXPECT_NEAR(sheet.h_m / across.state.h_m, 1, 1e-7);
  }
}

}  // namespace
}  // namespace ringfilm::sheet::testing
