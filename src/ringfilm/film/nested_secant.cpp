#include "ringfilm/film/nested_secant.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {
namespace {

constexpr int kMostOuterIterations = 60;
constexpr int kMostInnerIterations = 40;  // and one more per cell: a front may have to cross the face
constexpr double kFirstDamping = 0.2;     // d ln h_m over the relative excess of load, before a slope is known
constexpr double kLargestMove = 0.5;      // of ln h_m

}  // namespace

class NestedSecant {
 public:
  NestedSecant(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, FilmState& state,
               SecantWorkspace& workspace)
      : problem_(problem),
        inputs_(inputs),
        previous_(previous),
        state_(state),
        work_(workspace),
        scale_(inputs.mean_pressure(problem.grid)) {
    state_.p.front() = inputs.p_left;
    state_.p.back() = inputs.p_right;
    state_.deficit.front() = state_.deficit.back() = 0;
    z_from_state(state_, inputs_.p_cavitation, scale_, work_.z_);
    work_.oil_.update(*problem_.oil, state_.p);
    cavity_multiplier(problem_, state_, work_.oil_, work_.multiplier_);
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
        work_.oil_.update(*problem_.oil, state_.p);
        complete_state(problem_, work_.oil_, state_);
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
    if (other) {
      const double slope = (here.excess - other->excess) / (here.ln_h - other->ln_h);
      // The load falls with h_m; what says otherwise is not believed.
      move = slope < 0 ? -here.excess / slope : std::copysign(kLargestMove, here.excess);
    }
    return here.ln_h + std::clamp(move, -kLargestMove, kLargestMove);
  }

  bool solve_film_alone(FilmReport& report) {
    work_.update_.start();
    auto& system = work_.system_;
    for (int inner = 0; inner < kMostInnerIterations + problem_.grid.n_cells(); ++inner) {
      work_.oil_.update(*problem_.oil, state_.p);
      assemble_balance(problem_, inputs_, previous_, state_, work_.oil_, scale_, work_.multiplier_, system);
      std::fill(system.row.begin(), system.row.end(), 0.0);  // no load row: h_m is given
      if (!system.eliminate()) return false;
      system.back_substitute(0);
      const auto outcome = work_.update_.apply(work_.z_, system.rhs, scale_);
      state_from_z(work_.z_, inputs_.p_cavitation, scale_, state_);
      ++report.iterations;
      report.last_step = outcome.largest;
      if (!std::isfinite(outcome.largest)) return false;
      if (outcome.to_film + outcome.to_cavity == 0 && outcome.largest <= std::sqrt(problem_.tolerance)) return true;
    }
    return false;
  }

  const FilmProblem& problem_;
  const FilmInputs& inputs_;
  const FilmState& previous_;
  FilmState& state_;
  SecantWorkspace& work_;
  double scale_;
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
