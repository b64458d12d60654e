#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ringfilm/cycle/menisci/menisci_liner.hpp"
#include "ringfilm/cycle/menisci/menisci_step.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/menisci/menisci_film.hpp"
#include "ringfilm/film/menisci/rosenbrock_step.hpp"

namespace ringfilm::cycle {

/// What an integration has spent.
struct MenisciEffort {
  long steps = 0, rejected = 0;  ///< steps that were accepted, and that were not
  long changes_of_places =
      0;              ///< changes of menisci that came to an edge or the throat or left it, of films that formed
  long balances = 0;  ///< films whose pressure was found
};

/// Integrates film, menisci, bead and the oil on the liner over the crank angle (docs/theory/menisci.md).
class MenisciIntegration {
 public:
  /// Begins at BDC before compression, with the fresh liner and a ring without film. @param tolerance error that a step
  /// may make in ln h_m
  MenisciIntegration(const Setup& setup, double tolerance);
  MenisciIntegration(const MenisciIntegration&) = delete;  // the film refers to its problem
  MenisciIntegration& operator=(const MenisciIntegration&) = delete;

  /// Over one cycle of the oil, to the next BDC before compression. Throws ConvergenceError with the crank angle where
  /// no step is found.
  void integrate_cycle();

  /// Steps of the last cycle; their angles continue beyond 720 degree.
  const std::vector<MenisciStep>& steps() const { return steps_; }
  /// Film, pressure and flows at a crank angle within a step of the last cycle.
  MenisciSample sample(const MenisciStep& step, double crank_angle_deg);

  const film::MenisciState& state() const { return state_; }
  const MenisciLiner& liner() const { return liner_; }
  /// Between cycles, other oil on the liner in equal cells [kg/m2].
  void replace_oil(const std::vector<double>& cells) { liner_.replace(cells); }
  /// The liner before and after each stroke of the last cycle, from firing TDC.
  struct Pass {
    MenisciLiner before, after;
  };
  const std::vector<Pass>& passes() const { return passes_; }
  const film::FilmProblem& contact() const { return contact_; }  ///< face and asperities
  const MenisciEffort& effort() const { return effort_; }

 private:
  using Rosenbrock = film::RosenbrockStep<4>;
  using Vector = Rosenbrock::Vector;

  /// The film at an angle with all that follows from it.
  struct Instant {
    double angle_deg;
    MenisciConditions conditions;
    film::MenisciState state;
    film::OnLiner on_liner;
    film::MenisciBalance balance;
  };
  /// A step that may be accepted.
  struct Candidate {
    Instant end;
    double error;   ///< over the one that is allowed
    double margin;  ///< below 0: a place has changed on the way
  };

  MenisciConditions conditions(double crank_angle_deg) const { return conditions(crank_angle_deg, highest_pressure_); }
  MenisciConditions conditions(double crank_angle_deg, double highest_pressure) const;
  film::MenisciState with(const Vector& y) const;
  Vector unknowns() const;
  film::OnLiner read(const RingConditions& at, const film::MenisciState& state) const;
  film::MenisciBalance solve(film::MenisciInputs& inputs, const film::MenisciState& state,
                             const film::OnLiner& on_liner, double lift_rate,
                             film::Iteration iteration = film::Iteration::kUntilSolved);
  Vector rate(const film::MenisciState& state, const film::MenisciBalance& balance) const;
  void begin_step(double to_deg);
  std::optional<Candidate> candidate(double to_deg);
  void take_up_all(const MenisciConditions& at, const film::OnLiner& ahead, double oil_by_time, double length,
                   film::MenisciState& state) const;
  Candidate up_to_change(Candidate beyond);
  std::vector<LinerSide::Point> hung_oil() const;
  void integrate_stroke(double to_deg);
  void step(double to_deg);
  void accept(const Instant& end);
  void warm_up();
  void settle_places();
  OilBeyond oil_beyond() const;

  const Setup& setup_;
  double tolerance_;
  film::FilmGrid grid_;
  film::FilmProblem contact_;
  film::MenisciFilm film_;
  double degrees_per_second_;
  double direction_ = 1;         ///< direction of the liner in the present stroke
  double highest_pressure_ = 0;  ///< that oils serve [Pa]
  HeatBefore heat_;
  film::MenisciState state_;
  MenisciLiner liner_;
  Instant now_;
  OilBeyond beyond_;
  double next_length_deg_;
  Rosenbrock::Begin begin_;
  Vector by_time_, by_film_;  ///< slopes of the rates, in the angle and in the oil ahead of the leading meniscus
  double speed_by_time_ = 0;  ///< slope of the speed of the liner [m/(s degree)]
  std::vector<MenisciStep> steps_;
  std::vector<Pass> passes_;
  MenisciEffort effort_;
};

}  // namespace ringfilm::cycle
