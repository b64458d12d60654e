#include "ringfilm/cycle/simulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/kinematics.hpp"
#include "ringfilm/cycle/march.hpp"
#include "ringfilm/cycle/recorder.hpp"

namespace ringfilm::cycle {
namespace {

/// The march starts here, from a steady film: mid exhaust stroke, high speed and low load.
constexpr double kStartAngleDeg = 270;
/// States are compared with those of one cycle before at this spacing.
constexpr double kCheckSpacingDeg = 15;
/// A flooded film forgets its start within half a stroke; a march that is not periodic by then never will be.
constexpr int kMostCycles = 20;

}  // namespace

CycleResult simulate(const Setup& setup, Observer* observer) {
  const int n_steps = steps_per_cycle(setup.input.solver);
  const double step_deg = kCycleDeg / n_steps;
  const int check_every = std::max(1, static_cast<int>(std::lround(kCheckSpacingDeg / step_deg)));
  const double repeats_within = kPeriodicityFactor * setup.input.solver.tolerance;

  March march(setup);
  Recorder recorder(setup);
  std::vector<std::optional<film::FilmState>> one_cycle_ago(n_steps);
  double distance = std::numeric_limits<double>::infinity();
  int marched = 0;
  try {
    int k = static_cast<int>(std::lround(kStartAngleDeg / step_deg)) % n_steps;
    march.start(k);
    while (marched < kMostCycles * n_steps) {
      march.advance(recorder);
      k = (k + 1) % n_steps;
      ++marched;
      if (observer != nullptr) observer->advanced(1 + (marched - 1) / n_steps, k * step_deg);
      if (k % check_every != 0) continue;
      if (one_cycle_ago[k]) distance = march.distance(*one_cycle_ago[k]);
      if (distance <= repeats_within) return recorder.result(march, distance, marched, Completeness::kComplete);
      one_cycle_ago[k] = march.state();
    }
    throw ConvergenceError("the cycle does not repeat itself after " + std::to_string(kMostCycles) + " cycles",
                           k * step_deg);
  } catch (const ConvergenceError& error) {
    throw StoppedCycle(error.what(), error.crank_angle_deg(),
                       recorder.result(march, distance, marched, Completeness::kStopped));
  }
}

}  // namespace ringfilm::cycle
