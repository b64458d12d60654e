#pragma once
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::cycle {

/// The state of a cycle repeats when film and pressure agree to this many solver tolerances [-].
inline constexpr double kPeriodicityFactor = 10;

/// Receives the progress of the time integration; may be slow; what it throws ends the work.
class Observer {
 public:
  virtual ~Observer() = default;
  /// @param cycle 1 for the first; @param crank_angle_deg of the step just accepted
  virtual void advanced(int cycle, double crank_angle_deg) = 0;
};

/// The integration stopped at a crank angle where nothing balances the load; `result` holds all up to the last good
/// one.
class StoppedCycle : public ConvergenceError {
 public:
  /// What was solved goes with it.
  StoppedCycle(const std::string& message, std::optional<double> crank_angle_deg, CycleResult result_so_far)
      : ConvergenceError(message, crank_angle_deg), result(std::move(result_so_far)) {}
  CycleResult result;  ///< complete is false, values of the cycle are NaN
};

/// Integrates the engine cycle until its state repeats and returns every quantity at the angles asked for.
/// Where uniform cells find no film, once more on graded ones, with a note. Same setup, same bits. Throws StoppedCycle.
CycleResult simulate(const Setup& setup, Observer* observer = nullptr);

}  // namespace ringfilm::cycle
