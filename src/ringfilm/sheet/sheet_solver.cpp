#include "ringfilm/sheet/sheet_solver.hpp"

#include <algorithm>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/film/separation_search.hpp"
#include "ringfilm/sheet/sheet_newton.hpp"

namespace ringfilm::sheet {

struct SheetWorkspace::Memory {
  SheetNewton newton;
};

SheetWorkspace::SheetWorkspace(const SheetProblem& problem) : memory_(new Memory{SheetNewton(problem)}) {}
SheetWorkspace::SheetWorkspace(SheetWorkspace&&) noexcept = default;
SheetWorkspace& SheetWorkspace::operator=(SheetWorkspace&&) noexcept = default;
SheetWorkspace::~SheetWorkspace() = default;

/// The solve of one step over the workspace.
class SheetSolve : public film::SoughtFilm {
 public:
  SheetSolve(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& previous,
             film::FilmState& state, SheetWorkspace& workspace)
      : problem_(problem),
        inputs_(inputs),
        previous_(previous),
        state_(state),
        guess_(state),
        newton_(workspace.memory_->newton) {}

  /// With the fits, and where they do not reach with the laws.
  bool solve(film::Unknowns unknowns) {
    const film::LaneLaws laws = film::best_laws(problem_.strip);
    bool solved = solve(unknowns, laws);
    if (solved && laws == film::LaneLaws::kFitted && peak_pressure_ > problem_.strip.oil->fit()->high) {
      report_.exact_laws = true;
      solved = solve(unknowns, film::LaneLaws::kGiven);
    }
    if (solved) finish(report_.exact_laws ? film::LaneLaws::kGiven : laws);
    return solved;
  }

  bool solve_by_search() {
    solved_ = guess_;
    const film::SearchLimits limits{film::thickest(problem_.strip), inputs_.strip.load, problem_.strip.tolerance};
    const bool found = film::search_separation(*this, guess_.h_m, limits, report_);
    if (!found)
      film::explain_failure(*problem_.strip.oil, inputs_.strip.p_cavitation, solved_, film::Patience::kMuch, report_);
    if (found) finish(film::LaneLaws::kGiven);
    return found;
  }

  film::FilmReport at_separation() {
    report_.converged = solve(film::Unknowns::kFilmAlone);
    if (report_.converged) report_.failure = film::Failure::kNone;
    return report_;
  }
  film::FilmReport balanced() {
    if (solve(film::Unknowns::kFilmAndSeparation) || solve_by_search()) {
      film::accept(*problem_.strip.oil, inputs_.strip.p_cavitation, state_, report_);
    }
    return report_;
  }

  bool solve_at(double h_m) override {
    state_ = solved_;
    state_.h_m = h_m;
    const bool solved = solve(film::Unknowns::kFilmAlone, film::LaneLaws::kGiven);
    if (solved) solved_ = state_;
    return solved;
  }
  double excess() const override { return mean_load(problem_, inputs_, state_) - inputs_.strip.load; }

 private:
  bool solve(film::Unknowns unknowns, film::LaneLaws laws) {
    const SheetNewton::Outcome outcome = newton_.solve(problem_, inputs_, previous_, unknowns, laws, state_);
    report_.iterations += outcome.iterations;
    report_.last_step = outcome.last_step;
    peak_pressure_ = outcome.peak_pressure;
    return outcome.solved;
  }

  void finish(film::LaneLaws laws) {
    state_.laws = laws;
    complete_state(problem_, inputs_, state_);
  }

  const SheetProblem& problem_;
  const SheetInputs& inputs_;
  const film::FilmState& previous_;
  film::FilmState& state_;
  const film::FilmState guess_;
  film::FilmState solved_;  ///< of the search: the last film that was found
  SheetNewton& newton_;
  film::FilmReport report_;
  double peak_pressure_ = 0;
};

film::FilmReport solve_sheet(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& previous,
                             film::FilmState& state, SheetWorkspace& workspace) {
  SheetSolve sheet(problem, inputs, previous, state, workspace);
  return sheet.balanced();
}

film::FilmReport solve_sheet_at_separation(const SheetProblem& problem, const SheetInputs& inputs,
                                           const film::FilmState& previous, film::FilmState& state,
                                           SheetWorkspace& workspace) {
  SheetSolve sheet(problem, inputs, previous, state, workspace);
  return sheet.at_separation();
}

film::FilmState of_strips(const SheetProblem& problem, const film::FilmState& strip) {
  film::FilmState sheet;
  sheet.h_m = strip.h_m;
  sheet.laws = strip.laws;
  const auto repeat = [&](const std::vector<double>& along) {
    std::vector<double> all;
    all.reserve(problem.n_nodes());
    for (int j = 0; j < problem.around.n_strips(); ++j) all.insert(all.end(), along.begin(), along.end());
    return all;
  };
  sheet.p = repeat(strip.p);
  sheet.deficit = repeat(strip.deficit);
  sheet.content = repeat(strip.content);
  return sheet;
}

void complete_state(const SheetProblem& problem, const SheetInputs& inputs, film::FilmState& state) {
  const int n_across = problem.n_across();
  const models::OilAtTemperature& oil = *problem.strip.oil;
  const bool fitted = state.laws == film::LaneLaws::kFitted;
  state.content.resize(problem.n_nodes());
  for (int j = 0; j < problem.around.n_strips(); ++j) {
    const double h_m = state.h_m + (inputs.rise.empty() ? 0.0 : inputs.rise[j]);
    for (int i = 0; i < n_across; ++i) {
      const auto node = static_cast<std::size_t>(j) * n_across + i;
      const double p = state.p[node];
      const double rho = fitted ? oil.fit()->at(p).rho : oil.density(p);
      state.content[node] =
          rho * film::fill(problem.strip.cavitation, state.deficit[node]) * (h_m + problem.gap.node[node]);
    }
  }
}

double mean_load(const SheetProblem& problem, const SheetInputs& inputs, const film::FilmState& state) {
  const Around& around = problem.around;
  const film::FilmGrid& grid = problem.strip.grid;
  const bool bent = !inputs.rise.empty();
  double load = bent ? 0 : film::asperity_load(problem.strip, state.h_m);
  for (int j = 0; j < around.n_strips(); ++j) {
    const double share = around.share[j] / around.length;
    const auto first = static_cast<std::size_t>(j) * problem.n_across();
    for (int i = 0; i < problem.n_across(); ++i) load += share * grid.share[i] * state.p[first + i];
    if (bent) load += share * film::asperity_load(problem.strip, state.h_m + inputs.rise[j]);
  }
  return load;
}

}  // namespace ringfilm::sheet
