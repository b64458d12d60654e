#pragma once
#include <functional>
#include <string>

#include "ringfilm/cycle/kinematics.hpp"
#include "ringfilm/cycle/setup.hpp"
#include "ringfilm/film/film_solver.hpp"

namespace ringfilm::cycle {

/// Which way the film's own x points.
enum class Axis {
  kFromChamber,   ///< x = 0 at the chamber edge
  kFromCrankcase  ///< x = 0 at the crankcase edge (only with orientation = "leading-edge", moving down)
};

/// What was spent since the last base angle.
struct StepEffort {
  int steps = 0;
  int newton_iterations = 0;
  int fallbacks = 0;
};

/// A solved film at one crank angle with all that led to it.
struct Instant {
  double crank_angle_deg = 0;  ///< in [0, 720)
  Axis axis = Axis::kFromChamber;
  film::FilmInputs inputs;
  const film::FilmState* previous = nullptr;
  const film::FilmState* state = nullptr;
  StepEffort effort;
};

/// Advances the film from one base crank angle to the next, with shorter steps where the film asks for them.
class March {
 public:
  /// Called once per accepted step with its two angles, while the march still stands at the first.
  using Interval = std::function<void(double from_deg, double to_deg)>;

  explicit March(const Setup& setup);

  /// A steady film at the base angle k. Throws ConvergenceError.
  void start(int k);

  /// To the next base angle. Throws ConvergenceError with the state left at the last good angle.
  void advance(const Interval& before_commit);

  /// A film at `crank_angle_deg`, solved from where the march stands without moving it. Throws ConvergenceError.
  /// `to` receives the film; the Instant refers to it and to the march's own state.
  Instant side_step(double crank_angle_deg, film::FilmState& to);

  /// Where the march stands.
  const Instant& instant() const { return instant_; }
  const film::FilmState& state() const { return state_; }
  const film::FilmProblem& problem() const { return problem_; }

  /// Largest relative difference of film, pressure and fill from another state [-].
  double distance(const film::FilmState& other) const;

  struct Totals {
    long crank_steps = 0, newton_iterations = 0, sub_steps = 0;
    long fallback_secant = 0, fallback_sub_step = 0;
    double max_newton_step = 0;
  };
  const Totals& totals() const { return totals_; }

 private:
  struct Boundary {
    film::FilmInputs inputs;
    Axis axis;
  };
  Boundary boundary(double crank_angle_deg, double time_step) const;
  film::FilmReport step_to(double crank_angle_deg, double time_step, film::FilmState& to, Boundary& boundary);
  film::FilmState extrapolated(double time_step) const;
  double time_error(const film::FilmState& to, double time_step) const;
  void count(const film::FilmReport& report);

  const Setup& setup_;
  film::FilmProblem problem_;
  film::FilmWorkspace workspace_;
  film::FilmState state_, before_, candidate_;
  double time_step_before_ = 0;  ///< 0: no history
  int k_ = 0;                    ///< base angle where the march stands
  double angle_deg_ = 0;         ///< the same as an angle, within a base step too
  int level_ = 0;                ///< steps are 2^-level of the base step
  Instant instant_;
  StepEffort effort_;
  Totals totals_;
};

}  // namespace ringfilm::cycle
