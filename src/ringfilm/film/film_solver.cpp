#include "ringfilm/film/film_solver.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

constexpr double kRunaway = 1e6;       // multiple of the load beyond which only the sign counts
const double kStride = std::log(1.5);  // of the search, in ln h_m
const double kThicker = std::log(2.5);

}  // namespace

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
    while (newton_.phase(0) == LaneNewton::Phase::kRunning) newton_.iterate();
    newton_.read(0, state_);
    report.iterations += newton_.iterations(0);
    report.last_step = newton_.last_step(0);
    return newton_.phase(0) == LaneNewton::Phase::kSolved;
  }

  /// With the fits, and where they do not reach with the laws.
  bool solve(Unknowns unknowns, FilmReport& report) {
    const LaneLaws laws = best_laws(problem_);
    bool solved = solve(unknowns, laws, report);
    if (solved && laws == LaneLaws::kFitted && newton_.peak_pressure(0) > problem_.oil->fit()->high) {
      report.exact_laws = true;
      solved = solve(unknowns, LaneLaws::kGiven, report);
    }
    if (solved) complete_state(problem_, report.exact_laws ? LaneLaws::kGiven : laws, state_);
    return solved;
  }

  /// The fallback: the load carried falls with h_m, so that a bracket can be closed on it.
  bool solve_by_search(const FilmState& guess, FilmReport& report) {
    report.route = Route::kSecant;
    report.exact_laws = true;
    bool solved = true;
    const auto excess_at = [&](double ln_h) {
      state_.h_m = std::exp(ln_h);
      double excess = 0;
      if (solve_alone(report)) {
        excess = load_excess();
      } else {
        const double unfinished = load_excess();
        state_ = guess;
        state_.h_m = std::exp(ln_h);
        if (solve_alone(report)) {
          excess = load_excess();
        } else {
          // Pressures that run away tell enough for a bracket: the film is too thin. If one of the two films is no
          // number, the other one tells.
          excess = std::fmax(unfinished, load_excess());
          solved = solved && excess > inputs_.load;
        }
      }
      solved = solved && !std::isnan(excess);
      return solved ? std::min(excess, kRunaway * inputs_.load) : 0.0;
    };
    state_ = guess;
    double a = std::log(guess.h_m);
    double excess_a = excess_at(a);
    // A film that is far too thin for the load may itself be beyond Newton's method; a thicker one never is.
    while (!solved && a < std::log(thickest(problem_.grid))) {
      solved = true;
      a += kThicker;
      excess_a = excess_at(a);
    }
    const double stride = std::copysign(kStride, excess_a);
    double b = a;
    double excess_b = excess_a;
    while (solved && excess_a * excess_b > 0) {
      if (b < std::log(kThinnest)) report.failure = Failure::kOverloaded;
      if (b > std::log(thickest(problem_.grid))) report.failure = Failure::kLiftedOff;
      if (b < std::log(kThinnest) || b > std::log(thickest(problem_.grid))) return false;
      a = b;
      excess_a = excess_b;
      b = a + stride;
      excess_b = excess_at(b);
    }
    if (!solved) return false;
    if (excess_b == 0) return finish();
    if (a > b) {
      std::swap(a, b);
      std::swap(excess_a, excess_b);
    }
    boost::uintmax_t evaluations = 60;
    const auto close_enough = [&](double low, double high) { return high - low < 0.1 * problem_.tolerance; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess_at, a, b, excess_a, excess_b, close_enough, evaluations);
    if (!solved) return false;
    const double rest = excess_at(0.5 * (low + high));
    report.last_step = high - low;
    return solved && close_enough(low, high) && std::abs(rest) < std::sqrt(problem_.tolerance) * inputs_.load &&
           finish();
  }

 private:
  bool solve_alone(FilmReport& report) { return solve(Unknowns::kFilmAlone, LaneLaws::kGiven, report); }

  bool finish() {
    complete_state(problem_, LaneLaws::kGiven, state_);
    return true;
  }

  /// W_h + W_a - W per length [N/m].
  double load_excess() const {
    return hydrodynamic_load(problem_, state_) + asperity_load(problem_, state_.h_m) - inputs_.load;
  }

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
  report.converged = film.solve(Unknowns::kFilmAndSeparation, report) || film.solve_by_search(guess, report);
  if (report.converged) report.failure = Failure::kNone;
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
