#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "ringfilm/cycle/integration/liner_oil.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/time_scheme.hpp"

namespace ringfilm::cycle {

/// What was spent since the last base angle.
struct StepEffort {
  int steps = 0;
  int newton_iterations = 0;
  int fallbacks = 0;
};

/// A solved film at one crank angle with all that led to it.
struct Instant {
  double crank_angle_deg = 0;  ///< in [0, 720)
  RingConditions at;           ///< what acts on the ring there
  const film::FilmState* previous = nullptr;
  const film::FilmState* state = nullptr;
  StepEffort effort;
  double bead = 0;  ///< scraped oil ahead of the ring, per length of circumference [kg/m]
};

/// Nothing balances the load at a crank angle.
class NoBalance : public ConvergenceError {
 public:
  NoBalance(const std::string& message, double crank_angle_deg, film::Failure why)
      : ConvergenceError(message, crank_angle_deg), failure(why) {}
  film::Failure failure;  ///< what physics or the iteration has no answer to
};

/// A step that could not be cut further, with an error in time that counts.
struct UncontrolledStep {
  double crank_angle_deg = 0;  ///< at its end, in [0, 720) [degree]
  double error = 0;            ///< relative, as that of eq-time-error [-]
};

class TimeIntegration;

/// Called after every accepted step.
class StepObserver {
 public:
  virtual ~StepObserver() = default;
  /// The integration is at `from_deg` and will step to `to_deg`.
  virtual void before_step(TimeIntegration& integration, double from_deg, double to_deg) = 0;
  /// The integration is at the end of the step.
  virtual void after_step(const TimeIntegration& integration) = 0;
};

/// Advances the film from one base crank angle to the next, with shorter steps where the film asks for them.
class TimeIntegration {
 public:
  explicit TimeIntegration(const Setup& setup, const PlaceOnLiner& place = {});
  TimeIntegration(const TimeIntegration&) = delete;  // an Instant refers to its states
  TimeIntegration& operator=(const TimeIntegration&) = delete;

  /// A steady film at the base angle k, or with oil on the liner a ring without film. Throws ConvergenceError.
  void start(int k);

  /// To the next base angle. Throws ConvergenceError with the state left at the last good angle.
  void advance(StepObserver& waypoints);

  // The step of advance() in three parts, for callers that solve the films of many integrations side by side: propose,
  // find the film, conclude.

  /// Lays out the next step.
  void propose();
  const film::FilmInputs& proposed() const { return step_.at.inputs; }
  /// What the proposed step follows from; of it only the `mass_per_area` enters.
  const film::FilmState& remembered() const { return step_.is_second_order ? history_ : state_; }
  /// Where the film of the proposed step is to be sought from, eq-continued-film; in `candidate()`.
  const film::FilmState& guess();
  /// The film of the proposed step goes here.
  film::FilmState& candidate() { return candidate_; }
  /// Does gas hold the ring off the liner in it? Then its film carries no load.
  bool is_off_liner() const { return step_.at.off_liner.has_value(); }
  /// Finds the film of the proposed step, in `candidate()`, by the method of the case.
  film::FilmReport solve();
  /// Takes the candidate as the next state, or shortens the step. Throws ConvergenceError if it cannot be shortened.
  void conclude(const film::FilmReport& report, StepObserver& waypoints);
  /// Is the step from base angle to base angle done?
  bool at_base_angle() const { return tick_ == kTicksPerBaseStep; }

  /// Can its films be sought in the lane of a block: films across the face, by the coupled Newton method, without
  /// factors or a gap that follow from the film?
  bool fits_a_lane() const {
    return !setup_.input.is_unrolled() && setup_.input.solver.method != Method::kPointRelaxation &&
           setup_.ring.factors.are_of_plain_film() && setup_.input.ring.local_deformation == LocalDeformation::kNone &&
           !film_.tilts();
  }

  /// A base step may be cut into as many.
  static constexpr int kTicksPerBaseStep = 64;
  /// Relative error of the film in a step of one tick from which on it counts as uncontrolled [-]. Of 700 random
  /// engines with backward Euler 268 have such steps over solver.step_error. Against a quarter of the crank step the
  /// smallest film of those with errors up to 0.05 is off by no more than that of the others (90 % quantile 1.1 % for
  /// both); it is off by 6 % and 28 % for the two with larger errors.
  static constexpr double kUncontrolledError = 0.05;
  /// Error that is allowed per step in the oil on the face, as a share of that in ln h_m [-].
  static constexpr double kContentShare = 0.5;
  /// Error allowed per step in the oil on the face with BDF2, as a share of that in ln h_m [-]. Over 64 random engines,
  /// 312 steps a cycle with 8 brought as many values within 0.5 % as 474 with 0.5.
  static constexpr double kContentShareOfBdf2 = 8;
  /// Weight of the pressure of asperities in eq-error-weight. Over the same engines 225 steps with 2 were as good as
  /// 240 without weight, and fewer values were far off.
  static constexpr double kWeightOfContact = 2;
  /// Smallest pressure of asperities that counts, over the mean pressure of the load [-].
  static constexpr double kFeltPressure = 1e-3;

  /// A film at `crank_angle_deg`, solved from the current instant without advancing the integration, in up to 64 steps.
  /// Throws ConvergenceError. `to` receives the film; the Instant refers to it and to memory of the integration.
  Instant side_step(double crank_angle_deg, film::FilmState& to);

  /// Error in time of the last step if it is one of UncontrolledStep, else 0 [-].
  double uncontrolled_error() const { return uncontrolled_error_; }

  /// The current instant.
  const Instant& instant() const { return instant_; }
  const film::FilmState& state() const { return state_; }
  /// Problem of the film across the face, which is that of each strip of an unrolled film.
  const film::FilmProblem& problem() const { return film_.across(); }
  const film::FilmGrid& unloaded_grid() const { return film_.unloaded_grid(); }
  /// Problem of an unrolled film, else nullptr.
  const film::Film2dProblem* film2d() const { return film_.film2d(); }
  /// What acts on an unrolled film.
  film::Film2dInputs film2d_inputs(const RingConditions& at) const { return film_.film2d_inputs(at); }
  std::vector<double> bore_at_strips(const RingConditions& at) const { return film_.bore_at_strips(at); }
  /// By how much the separation of a strip of a ring that bends exceeds h_m, else 0 [m].
  double rise(const film::FilmState& state, int strip) const { return film_.rise(state, strip); }

  /// The oil on the liner; nullptr where the case follows none.
  const LinerOil* liner_oil() const { return liner_oil_ ? &*liner_oil_ : nullptr; }

  /// What comes back after one cycle.
  struct Snapshot {
    film::FilmState film;
    std::vector<double> on_liner;  ///< [kg/m2]
  };
  Snapshot snapshot() const;
  /// From another state [-].
  struct Distance {
    double film = 0;      ///< largest relative difference of film, pressure and film content
    double on_liner = 0;  ///< oil that lies elsewhere on the liner, as a share of all
    double largest() const { return std::max(film, on_liner); }
  };
  Distance distance(const Snapshot& other) const;

  struct Totals {
    long crank_steps = 0, newton_iterations = 0, sub_steps = 0;
    long relaxation_sweeps = 0;  ///< sweeps of point relaxation
    long fallback_secant = 0, fallback_sub_step = 0;
    long exact_law_solves = 0;  ///< solves by the laws themselves because their fits did not reach
    double max_newton_step = 0;
  };
  const Totals& totals() const { return totals_; }

 private:
  bool is_second_order() const { return setup_.input.solver.time_scheme == TimeScheme::kBdf2; }
  bool has_parabola() const { return step_.is_second_order && time_step_older_ > 0; }
  int ticks_of_step() const;
  void lay_out_step();
  double growth_after(double error) const;
  double weight_of_film(const film::FilmState& to) const;
  bool adaptive() const { return setup_.input.solver.crank_step_control == StepControl::kAdaptive; }
  double time_error(const film::FilmState& to, double time_step) const;
  film::MassSums mass_off(const film::FilmState& to, const film::Prediction& prediction,
                          const film::FilmState& older) const;
  double change_of_trend(const film::FilmState& to, const film::Prediction& prediction,
                         const film::FilmState& older) const;
  void continue_ring(film::FilmState& to) const;
  void continue_film(film::FilmState& to) const;
  /// Rise of the film's temperature above that of its walls, eq-viscous-heating; of an unrolled film that of its strip
  /// halfway [K].
  double viscous_heating_rise(const film::FilmInputs& inputs, const film::FilmState& state) const;
  HeatBefore heat_of_state(const RingConditions& at) const;
  void start_steady(RingConditions& at);
  void turn(film::FilmState& state) const;
  /// What the edges meet.
  struct Fluids {
    film::EdgeFluid chamber = film::EdgeFluid::kOil, crankcase = film::EdgeFluid::kOil;
    friend bool operator==(const Fluids&, const Fluids&) = default;
  };
  static Fluids fluids(const RingConditions& at);
  void count(const film::FilmReport& report);
  /// Does gas hold the ring off the liner under these conditions, and by how far? eq-radial-collapse
  std::optional<double> off_liner(const RingConditions& at) const;
  /// A film that carries, or that under a ring off the liner.
  film::FilmReport solve_film(const RingConditions& at, const film::FilmState& previous, film::FilmState& state);
  /// h_m of a ring that gas holds off the liner there [m].
  double separation_off_liner(double distance) const;
  void forget_past();
  /// What acts on the ring at the end of a step from the current state.
  RingConditions conditions(double from_deg, double to_deg, double time_step) const;
  void account_of_oil();
  bool remember_two_films();

  const Setup& setup_;
  CycleFilm film_;
  std::optional<LinerOil> liner_oil_;
  film::FilmState state_, before_, older_, candidate_, side_before_;
  film::FilmState history_;         ///< what a step of second order remembers
  film::FilmState moved_;           ///< the film as the next step finds it where oil moves with the wall
  bool oil_moves_ = false;          ///< does it in the step that was solved last?
  Axis axis_ = Axis::kFromChamber;  ///< orientation of `state_` and `before_`
  Fluids fluids_;                   ///< at the edges of `state_`
  bool is_lifted_ = false;          ///< no film of the proposed step carries as little as the load
  double on_liner_ = 0;             ///< h_m of the last film that carried [m]
  double time_step_before_ = 0;     ///< that led to `state_`; 0: no history
  double time_step_older_ = 0;      ///< that led to `before_`; 0: there is no `older_`
  double thinnest_ = 0;             ///< h_m of all films so far [m]
  HeatBefore heat_;                 ///< heat of the film in `state_`, if it counts
  int k_ = 0;                       ///< current base angle
  double angle_deg_ = 0;            ///< crank angle of `state_`, within a base step too [degree]
  double longest_ticks_ = 0;        ///< longest next step, in ticks
  int tick_ = kTicksPerBaseStep;    ///< ticks of the current base step that are done
  double uncontrolled_error_ = 0;   ///< uncontrolled error of the last step [-]
  struct {
    int ticks = 0;  ///< length
    double to_deg = 0, time_step = 0, h_m = 0;
    RingConditions at;
    bool state_was_turned = false;
    bool is_repeated = false;  ///< shorter than a step that was not accepted
    bool is_second_order = false;
    double of_flow_before = 0;  ///< share of what the step before passed on in what this one passes on [-]
  } step_;                      ///< proposed
  Instant instant_;
  StepEffort effort_;
  Totals totals_;
};

}  // namespace ringfilm::cycle
