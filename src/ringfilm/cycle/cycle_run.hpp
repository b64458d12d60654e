#pragma once
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/approach.hpp"
#include "ringfilm/cycle/integration/side_by_side.hpp"
#include "ringfilm/cycle/integration/time_integration.hpp"
#include "ringfilm/cycle/oil_settling.hpp"
#include "ringfilm/cycle/recorder.hpp"

namespace ringfilm::cycle {

/// Why an integration stopped before its state repeated.
struct Stop {
  std::string message;
  std::optional<double> crank_angle_deg;
  std::optional<film::Failure> failure{};  ///< where a film was not found
};

/// Topics of the notes that such a second attempt carries.
inline constexpr const char* kCellsGraded = "cells-graded";
inline constexpr const char* kSurfacesFlattened = "surfaces-flattened";

/// After a stop where no film was found: the same scenario once more, with a note. A ring that bends gets surfaces that
/// flatten; any other one graded cells, which see films too thin and too short for uniform ones. Nothing where they
/// cannot help: the film is lifted off, not sought by the coupled Newton method, or it was the second attempt.
std::optional<Setup> second_attempt(const Setup& setup, const Stop& stop);

/// One scenario on its way from a steady film to a cycle that repeats itself.
class CycleRun final : public BatchMember {
 public:
  /// Starts the integration; a start without an answer is a stop like any other.
  /// @param of_own_liner how the oil comes to rest on the liner of a ring that shares it with no other
  explicit CycleRun(Setup setup, PlaceOnLiner place = {}, OilIteration of_own_liner = OilIteration::kMixed);

  TimeIntegration& integration() override { return integration_; }
  void conclude(const film::FilmReport& report) override;
  bool done() const override { return stop_ || repeats_ || approach_.moves_on(); }

  const Setup& setup() const { return setup_; }
  int steps_integrated() const { return steps_integrated_; }
  double crank_angle_deg() const { return k_ * step_deg_; }  ///< crank angle of the last base angle [degree]

  // Oil on the liner, see OilSettling.
  /// Is the integration at the angle where a cycle of the oil ends and the next begins, BDC before compression? There
  /// the rings leave free what settles slowly, the liner near TDC.
  bool begins_compression() const;
  /// Compares the state with that of one cycle before, if there is one, and keeps it.
  void compare_with_last_cycle();
  /// By how much the last cycle has changed the film, FilmOfCycle.
  double film_moved() const { return film_.moved(); }
  bool oil_repeats() const;
  /// @param ahead what all cycles to come are expected to move, as a share of the oil on the liner
  /// @param cycles the multiple of what the last one moved that this is
  void expect_oil_to_move(double ahead, double cycles) {
    oil_ahead_ = ahead;
    film_ahead_ = std::max(cycles, 1.0) * film_.moved();
  }
  /// After a change of the oil on the liner: cycles are compared from the present state on.
  void forget_last_cycle();

  /// Once done: what was found, and why no more if the integration stopped. @param others of its pack
  CycleResult result(Completeness others = Completeness::kComplete) const;
  const std::optional<Stop>& stop() const { return stop_; }

 private:
  void arrived();
  /// From the state that repeats itself, as far as it is known.
  double distance_ahead() const;
  void stopped(const ConvergenceError& error, std::optional<film::Failure> failure);
  /// Does a part of the integration; what it throws stops it.
  template <class Part>
  void attempt(const Part& part);

  Setup setup_;
  bool shares_liner_;  ///< with other rings of a pack, which settle the oil together
  PlaceOnLiner place_;
  std::optional<OilSettling> settling_;  ///< settling of the oil on a liner of its own
  int n_steps_;                          ///< number of steps of a cycle
  double step_deg_;
  int check_every_;
  FilmOfCycle film_;
  TimeIntegration integration_;
  Recorder recorder_;
  std::map<int, TimeIntegration::Snapshot> one_cycle_ago_;  ///< by base angle
  int k_ = 0;                                               ///< base angle
  int steps_integrated_ = 0;
  TimeIntegration::Distance distance_;
  double film_ahead_ = 0;  ///< what all cycles to come are expected to change the film, relative
  double oil_ahead_;       ///< what all cycles to come are expected to move on the liner, as a share
  Approach approach_;
  bool repeats_ = false;
  std::optional<Stop> stop_;
};

}  // namespace ringfilm::cycle
