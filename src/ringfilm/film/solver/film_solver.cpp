#include "ringfilm/film/solver/film_solver.hpp"

#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/film/solver/separation_search.hpp"

namespace ringfilm::film {

/// The solve of one step over the workspace.
class FilmSolve {
 public:
  FilmSolve(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
            FilmWorkspace& workspace)
      : problem_(problem), inputs_(inputs), previous_(previous), state_(state), newton_(workspace.newton_) {
    newton_.bind(0, problem);
  }

  /// From the state; true if it converged.
  bool solve(Unknowns unknowns, LaneLaws laws, FilmReport& report) {
    newton_.start(0, inputs_, previous_, state_, state_.h_m, unknowns, laws);
    return finish(report);
  }

  /// Solves one of the films of a search, with the laws themselves; true if it converged.
  bool solve_for_search(Patience patience, FilmReport& report) {
    newton_.start(0, inputs_, previous_, state_, state_.h_m, Unknowns::kFilmAlone, LaneLaws::kGiven);
    if (patience == Patience::kLittle) newton_.limit_search_effort(0);
    return finish(report);
  }

  bool finish(FilmReport& report) {
    while (newton_.phase(0) == LaneNewton::Phase::kRunning) newton_.iterate();
    newton_.read(0, state_);
    report.iterations += newton_.iterations(0);
    report.last_step = newton_.last_step(0);
    return newton_.phase(0) == LaneNewton::Phase::kSolved;
  }

  /// With the fits, and where they do not reach with the laws.
  bool solve(Unknowns unknowns, FilmReport& report) {
    const LaneLaws laws = best_laws(inputs_);
    bool solved = solve(unknowns, laws, report);
    if (solved && laws == LaneLaws::kFitted && newton_.peak_pressure(0) > inputs_.oil->fit()->high) {
      report.exact_laws = true;
      solved = solve(unknowns, LaneLaws::kGiven, report);
    }
    if (solved) complete_state(problem_, inputs_, report.exact_laws ? LaneLaws::kGiven : laws, state_);
    return solved;
  }

  /// The fallback, with the laws themselves.
  bool solve_by_search(const FilmState& guess, FilmReport& report) {
    const SearchLimits limits{thickest(problem_), inputs_.load, problem_.tolerance};
    bool found = false;
    if (least_hydrodynamic_load(problem_, inputs_) >= inputs_.load) {
      report.failure = Failure::kLiftedOff;
      return false;
    }
    // Most films that are not found soon do not exist; only where that explains nothing is every one sought to the end.
    for (const Patience patience : {Patience::kLittle, Patience::kMuch}) {
      Sought sought(*this, guess, patience, report);
      report.failure = Failure::kNotConverged;
      found = search_separation(sought, guess.h_m, limits, report);
      if (!found) explain_failure(*inputs_.oil, inputs_.p_cavitation, sought.solved(), patience, report);
      if (found || report.failure != Failure::kNotConverged) break;
    }
    if (found) complete_state(problem_, inputs_, LaneLaws::kGiven, state_);
    return found;
  }

 private:
  class Sought : public FilmAtSeparation {
   public:
    Sought(FilmSolve& solve, const FilmState& guess, Patience patience, FilmReport& report)
        : solve_(solve), solved_(guess), patience_(patience), report_(report) {}
    bool solve_at(double h_m) override {
      solve_.state_ = solved_;
      solve_.state_.h_m = h_m;
      const bool solved = solve_.solve_for_search(patience_, report_);
      if (solved) solved_ = solve_.state_;
      return solved;
    }
    const FilmState& solved() const { return solved_; }
    double excess() const override {
      const FilmState& state = solve_.state_;
      return hydrodynamic_load(solve_.problem_, solve_.inputs_, state) + asperity_load(solve_.problem_, state.h_m) -
             solve_.inputs_.load;
    }

   private:
    FilmSolve& solve_;
    FilmState solved_;  ///< the last film that was found
    Patience patience_;
    FilmReport& report_;
  };

  const FilmProblem& problem_;
  const FilmInputs& inputs_;
  const FilmState& previous_;
  FilmState& state_;
  LaneNewton& newton_;
};

FilmReport solve_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
                      FilmWorkspace& workspace) {
  FilmReport report;
  const FilmState guess = state;
  FilmSolve film(problem, inputs, previous, state, workspace);
  const bool found = film.solve(Unknowns::kFilmAndSeparation, report) ||
                     (inputs.fallback == Fallback::kSearch && film.solve_by_search(guess, report));
  if (found) accept(*inputs.oil, inputs.p_cavitation, state, report);
  return report;
}

FilmReport solve_film_at_separation(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                    FilmState& state, FilmWorkspace& workspace) {
  FilmReport report;
  FilmSolve film(problem, inputs, previous, state, workspace);
  report.converged = film.solve(Unknowns::kFilmAlone, report);
  if (report.converged) report.failure = Failure::kNone;
  return report;
}

}  // namespace ringfilm::film
