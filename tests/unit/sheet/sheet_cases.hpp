#pragma once
#include <functional>

#include "../film/lane_films.hpp"
#include "ringfilm/sheet/sheet_integrals.hpp"
#include "ringfilm/sheet/sheet_solver.hpp"

/// Sheets whose strips are the films of the tests in one dimension.
namespace ringfilm::sheet::testing {

inline film::testing::BlockKind kind(film::Cavitation cavitation, film::LaneLaws laws = film::LaneLaws::kFitted) {
  return {&film::kernels(), cavitation, laws};
}

inline SheetProblem sheet_of(const film::FilmProblem& strip, Around around) {
  SheetProblem problem;
  problem.strip = strip;
  problem.around = std::move(around);
  problem.gap = gap_of_strips(strip.grid, problem.around);
  return problem;
}

/// Ends at the mean of the edges, as a ring's gap has them.
inline SheetInputs inputs_of(const film::FilmInputs& strip) {
  SheetInputs inputs;
  inputs.strip = strip;
  inputs.p_low = inputs.p_high = 0.5 * (strip.left.pressure + strip.right.pressure);
  return inputs;
}

/// A sheet on its way through the steps of a film, from every strip like the film's first state.
class Passage {
 public:
  Passage(const film::testing::LaneFilm& film, SheetProblem problem)
      : film_(film), problem_(std::move(problem)), workspace_(problem_), state(of_strips(problem_, film.first)) {
    complete_state(problem_, inputs_of(film.steps[0]), state);
    before = state;
  }
  film::FilmReport step(const SheetInputs& inputs) {
    film::FilmState next = state;
    const film::FilmReport report = solve_sheet(problem_, inputs, state, next, workspace_);
    before = std::move(state);
    state = std::move(next);
    integrals = sheet_integrals(problem_, inputs, before, state);
    return report;
  }
  const SheetProblem& problem() const { return problem_; }
  double p(int i, int j) const { return state.p[static_cast<std::size_t>(j) * problem_.n_across() + i]; }

 private:
  const film::testing::LaneFilm& film_;
  SheetProblem problem_;
  SheetWorkspace workspace_;

 public:
  film::FilmState state, before;
  SheetIntegrals integrals;
};

}  // namespace ringfilm::sheet::testing
