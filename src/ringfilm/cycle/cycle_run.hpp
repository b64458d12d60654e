#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/integration/recorder.hpp"
#include "ringfilm/cycle/integration/side_by_side.hpp"
#include "ringfilm/cycle/integration/time_integration.hpp"

namespace ringfilm::cycle {

/// Why an integration stopped before its state repeated.
struct Stop {
  std::string message;
  std::optional<double> crank_angle_deg;
  std::optional<film::Failure> failure{};  ///< where a film was not found
};

/// Topic of the note that such a second attempt carries.
inline constexpr const char* kCellsGraded = "cells-graded";

/// After a stop where uniform cells found no film: the same scenario on graded cells, which see films too thin and too
/// short for the others, with a note. Nothing where they cannot help: the film is lifted off, not sought by the coupled
/// Newton method, unrolled, or the cells are graded already.
std::optional<Setup> second_attempt(const Setup& setup, const Stop& stop);

/// One scenario on its way from a steady film to a cycle that repeats itself.
class CycleRun final : public BatchMember {
 public:
  /// Starts the integration; a start without an answer is a stop like any other.
  explicit CycleRun(Setup setup, PlaceOnLiner place = {});

  TimeIntegration& integration() override { return integration_; }
  void conclude(const film::FilmReport& report) override;
  bool done() const override { return stop_ || repeats_; }

  const Setup& setup() const { return setup_; }
  int steps_integrated() const { return steps_integrated_; }
  double crank_angle_deg() const { return k_ * step_deg_; }  ///< of the last base angle

  /// Once done: what was found, and why no more if the integration stopped. @param others of its pack
  CycleResult result(Completeness others = Completeness::kComplete) const;
  const std::optional<Stop>& stop() const { return stop_; }

 private:
  void arrived();
  /// From the state of one cycle before, where the cycle counts as the same.
  double allowed_distance() const;
  /// At the end of a cycle. Throws ConvergenceError where its state approaches that of the one before no longer.
  void check_approach();
  void stopped(const ConvergenceError& error, std::optional<film::Failure> failure);
  /// Does a part of the integration; what it throws stops it.
  template <class Part>
  void attempt(const Part& part);

  Setup setup_;
  PlaceOnLiner place_;
  int n_steps_;  ///< of a cycle
  double step_deg_;
  int check_every_;
  TimeIntegration integration_;
  Recorder recorder_;
  std::map<int, TimeIntegration::Snapshot> one_cycle_ago_;  ///< by base angle
  int k_ = 0;                                               ///< base angle
  int steps_integrated_ = 0;
  double distance_;
  std::vector<double> distances_;  ///< at the end of each cycle
  bool repeats_ = false;
  std::optional<Stop> stop_;
};

}  // namespace ringfilm::cycle
