#pragma once
#include <functional>

#include "../film/lane_films.hpp"
#include "ringfilm/film/integrals/film2d_integrals.hpp"
#include "ringfilm/film/solver2d/film2d_solver.hpp"

/// Two-dimensional films whose strips are the films of the tests in one dimension.
namespace ringfilm::film::testing {

inline testing::BlockKind kind(Cavitation cavitation, LaneLaws laws = LaneLaws::kFitted) {
  return {&kernels(), cavitation, laws};
}

inline Film2dProblem film2d_of(const FilmProblem& strip, CircumferentialGrid around) {
  Film2dProblem problem;
  problem.strip = strip;
  problem.around = std::move(around);
  problem.gap = gap_of_strips(strip.grid, problem.around);
  return problem;
}

/// Ends at the mean of the edges, as a ring's gap has them.
inline Film2dInputs inputs_of(const FilmInputs& strip) {
  Film2dInputs inputs;
  inputs.strip = strip;
  inputs.p_low = inputs.p_high = 0.5 * (strip.left.pressure + strip.right.pressure);
  return inputs;
}

/// A two-dimensional film on its way through the steps of a film, from every strip like the film's first state.
class Passage {
 public:
  Passage(const testing::LaneFilm& film, Film2dProblem problem)
      : film_(film), problem_(std::move(problem)), workspace_(problem_), state(of_strips(problem_, film.first)) {
    complete_state(problem_, inputs_of(film.steps[0]), state);
    before = state;
  }
  FilmReport step(const Film2dInputs& inputs) {
    FilmState next = state;
    const FilmReport report = solve_film2d(problem_, inputs, state, next, workspace_);
    before = std::move(state);
    state = std::move(next);
    integrals = film2d_integrals(problem_, inputs, before, state);
    return report;
  }
  const Film2dProblem& problem() const { return problem_; }
  double p(int i, int j) const { return state.p[static_cast<std::size_t>(j) * problem_.n_across() + i]; }

 private:
  const testing::LaneFilm& film_;
  Film2dProblem problem_;
  Film2dWorkspace workspace_;

 public:
  FilmState state, before;
  Film2dIntegrals integrals;
};

}  // namespace ringfilm::film::testing
