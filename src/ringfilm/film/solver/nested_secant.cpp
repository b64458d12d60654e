#include "ringfilm/film/solver/nested_secant.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

constexpr int kMostOuterIterations = 60;
constexpr double kFirstDamping = 0.2;  // d ln h_m over the relative excess of load, before a slope is known
constexpr double kLargestMove = 0.5;   // of ln h_m

}  // namespace

class NestedSecant {
 public:
  NestedSecant(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
               SecantWorkspace& workspace)
      : problem_(problem),
        inputs_(inputs),
        previous_(previous),
        state_(state),
        newton_(workspace.newton_),
        laws_(best_laws(inputs)) {
    newton_.bind(0, problem);
  }

  bool solve(FilmReport& report) {
    Point here{std::log(state_.h_m), 0};
    std::optional<Point> before;    // the point of the last iteration but one
    std::optional<Point> opposite;  // of the other sign: the load is met between it and `here`
    for (report.outer_iterations = 1; report.outer_iterations <= kMostOuterIterations; ++report.outer_iterations) {
      state_.h_m = std::exp(here.ln_h);
      if (!solve_film_alone(report)) return false;
      here.excess = (hydrodynamic_load(problem_, state_) + asperity_load(problem_, state_.h_m)) / inputs_.load - 1;
      if (!std::isfinite(here.excess)) return false;
      if (std::abs(here.excess) <= problem_.tolerance) {
        if (laws_ == LaneLaws::kFitted && newton_.peak_pressure(0) > inputs_.oil->fit()->high) {
          laws_ = LaneLaws::kGiven;
          report.exact_laws = true;
          before.reset();
          opposite.reset();
          continue;
        }
        complete_state(problem_, inputs_, laws_, state_);
        return true;
      }
      if (before && before->excess * here.excess < 0) {
        opposite = before;
      } else if (opposite) {
        opposite->excess *= 0.5;  // Illinois: `here` came from the same side twice
      }
      const double next = next_ln_h(here, opposite ? opposite : before);
      before = here;
      here.ln_h = next;
    }
    return false;
  }

 private:
  struct Point {
    double ln_h;
    double excess;  ///< (W_h + W_a)/W - 1 [-]
  };

  static double next_ln_h(const Point& here, const std::optional<Point>& other) {
    double move = kFirstDamping * here.excess;
    if (other && other->ln_h != here.ln_h) {
      const double slope = (here.excess - other->excess) / (here.ln_h - other->ln_h);
      // The load falls with h_m; a slope with the other sign is not used.
      move = slope < 0 ? -here.excess / slope : std::copysign(kLargestMove, here.excess);
    }
    return here.ln_h + std::clamp(move, -kLargestMove, kLargestMove);
  }

  bool solve_film_alone(FilmReport& report) {
    newton_.start(0, inputs_, previous_, state_, state_.h_m, Unknowns::kFilmAlone, laws_);
    while (newton_.phase(0) == LaneNewton::Phase::kRunning) newton_.iterate();
    newton_.read(0, state_);
    report.iterations += newton_.iterations(0);
    report.last_step = newton_.last_step(0);
    return newton_.phase(0) == LaneNewton::Phase::kSolved;
  }

  const FilmProblem& problem_;
  const FilmInputs& inputs_;
  const FilmState& previous_;
  FilmState& state_;
  LaneNewton& newton_;
  LaneLaws laws_;
};

FilmReport solve_by_nested_secant(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                                  FilmState& state, SecantWorkspace& workspace) {
  FilmReport report;
  NestedSecant secant(problem, inputs, previous, state, workspace);
  report.converged = secant.solve(report);
  if (report.converged) report.failure = Failure::kNone;
  return report;
}

}  // namespace ringfilm::film
