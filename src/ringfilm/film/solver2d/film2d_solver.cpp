#include "ringfilm/film/solver2d/film2d_solver.hpp"

#include <algorithm>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/film/solver/separation_search.hpp"
#include "ringfilm/film/solver2d/film2d_newton.hpp"

namespace ringfilm::film {

struct Film2dWorkspace::Memory {
  Film2dNewton newton;
  FilmState guess, solved;
};

Film2dWorkspace::Film2dWorkspace(const Film2dProblem& problem) : memory_(new Memory{Film2dNewton(problem), {}, {}}) {}
Film2dWorkspace::Film2dWorkspace(Film2dWorkspace&&) noexcept = default;
Film2dWorkspace& Film2dWorkspace::operator=(Film2dWorkspace&&) noexcept = default;
Film2dWorkspace::~Film2dWorkspace() = default;

/// The solve of one step over the workspace.
class Film2dSearch : public FilmAtSeparation {
 public:
  Film2dSearch(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous, FilmState& state,
               Film2dWorkspace& workspace)
      : problem_(problem),
        inputs_(inputs),
        previous_(previous),
        state_(state),
        guess_(workspace.memory_->guess),
        solved_(workspace.memory_->solved),
        newton_(workspace.memory_->newton) {
    guess_ = state;
  }

  /// With the fits, and where they do not reach with the laws: from the film that the fits have, or if they have none,
  /// from the first guess.
  bool solve(Unknowns unknowns) {
    const LaneLaws laws = best_laws(inputs_.strip);
    bool solved = solve(unknowns, laws);
    if (laws == LaneLaws::kFitted && !(peak_pressure_ <= inputs_.strip.oil->fit()->high)) {
      report_.exact_laws = true;
      if (!solved) state_ = guess_;
      solved = solve(unknowns, LaneLaws::kGiven);
    }
    if (solved) finish(report_.exact_laws ? LaneLaws::kGiven : laws);
    return solved;
  }

  bool solve_by_search() {
    solved_ = guess_;
    const SearchLimits limits{thickest(problem_.strip), inputs_.strip.load, problem_.strip.tolerance};
    const bool found = search_separation(*this, guess_.h_m, limits, report_);
    if (!found) explain_failure(*inputs_.strip.oil, inputs_.strip.p_cavitation, solved_, Patience::kMuch, report_);
    if (found) finish(LaneLaws::kGiven);
    return found;
  }

  FilmReport at_separation() {
    report_.converged = solve(Unknowns::kFilmAlone);
    if (report_.converged) report_.failure = Failure::kNone;
    return report_;
  }
  FilmReport balanced() {
    if (solve(Unknowns::kFilmAndSeparation) || (!problem_.ring.bends() && solve_by_search())) {
      accept(*inputs_.strip.oil, inputs_.strip.p_cavitation, state_, report_);
    }
    return report_;
  }

  bool solve_at(double h_m) override {
    state_ = solved_;
    state_.h_m = h_m;
    const bool solved = solve(Unknowns::kFilmAlone, LaneLaws::kGiven);
    if (solved) solved_ = state_;
    return solved;
  }
  double excess() const override { return mean_load(problem_, inputs_, state_) - inputs_.strip.load; }

 private:
  bool solve(Unknowns unknowns, LaneLaws laws) {
    const Film2dNewton::Outcome outcome = newton_.solve(problem_, inputs_, previous_, unknowns, laws, state_);
    report_.iterations += outcome.iterations;
    report_.last_step = outcome.last_step;
    peak_pressure_ = outcome.peak_pressure;
    return outcome.solved;
  }

  void finish(LaneLaws laws) {
    state_.laws = laws;
    complete_state(problem_, inputs_, state_);
  }

  const Film2dProblem& problem_;
  const Film2dInputs& inputs_;
  const FilmState& previous_;
  FilmState& state_;
  FilmState& guess_;
  FilmState& solved_;  ///< last film that the search found
  Film2dNewton& newton_;
  FilmReport report_;
  double peak_pressure_ = 0;
};

film::FilmReport solve_film2d(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous,
                              FilmState& state, Film2dWorkspace& workspace) {
  Film2dSearch film2d(problem, inputs, previous, state, workspace);
  return film2d.balanced();
}

film::FilmReport solve_film2d_at_separation(const Film2dProblem& problem, const Film2dInputs& inputs,
                                            const FilmState& previous, FilmState& state, Film2dWorkspace& workspace) {
  Film2dSearch film2d(problem, inputs, previous, state, workspace);
  return film2d.at_separation();
}

film::FilmState of_strips(const Film2dProblem& problem, const FilmState& strip) {
  FilmState film2d;
  film2d.h_m = strip.h_m;
  film2d.laws = strip.laws;
  film2d.ring.assign(problem.ring.n_unknowns(), 0.0);
  const auto repeat = [&](const std::vector<double>& along) {
    std::vector<double> all;
    all.reserve(problem.n_nodes());
    for (int j = 0; j < problem.around.n_strips(); ++j) all.insert(all.end(), along.begin(), along.end());
    return all;
  };
  film2d.p = repeat(strip.p);
  film2d.deficit = repeat(strip.deficit);
  film2d.mass_per_area = repeat(strip.mass_per_area);
  return film2d;
}

void complete_state(const Film2dProblem& problem, const Film2dInputs& inputs, FilmState& state) {
  const int n_across = problem.n_across();
  const models::OilAtTemperature& oil = *inputs.strip.oil;
  const std::vector<double> rise = rise_of_strips(problem, inputs, state.ring);
  state.mass_per_area.resize(problem.n_nodes());
  state.factors = inputs.strip.factors;
  const auto stored = [&](std::size_t node) {
    return state.factors && !state.factors->stored.empty() ? state.factors->stored[node] : 0;
  };
  for (int j = 0; j < problem.around.n_strips(); ++j) {
    const double h_m = state.h_m + (rise.empty() ? 0.0 : rise[j]);
    for (int i = 0; i < n_across; ++i) {
      const auto node = static_cast<std::size_t>(j) * n_across + i;
      const double rho = density_at(oil, state.laws, state.p[node]);
      const double gap = h_m + problem.gap.node[node] + stored(node);
      state.mass_per_area[node] = rho * film_content(problem.strip.cavitation, state.deficit[node]) * gap;
    }
  }
}

double mean_load(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& state) {
  const CircumferentialGrid& around = problem.around;
  const FilmGrid& grid = problem.strip.grid;
  const std::vector<double> rise = rise_of_strips(problem, inputs, state.ring);
  const bool bent = !rise.empty();
  const auto by_walls = [&](double h_m) {
    return asperity_load(problem.strip, h_m) + land_load(problem.strip, inputs.strip, h_m);
  };
  double load = bent ? 0 : by_walls(state.h_m);
  for (int j = 0; j < around.n_strips(); ++j) {
    const double share = around.share[j] / around.length;
    const auto first = static_cast<std::size_t>(j) * problem.n_across();
    for (int i = 0; i < problem.n_across(); ++i) load += share * grid.share[i] * state.p[first + i];
    if (bent) load += share * by_walls(state.h_m + rise[j]);
  }
  return load;
}

}  // namespace ringfilm::film
