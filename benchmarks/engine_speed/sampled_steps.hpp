#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ringfilm/cycle/integration/time_integration.hpp"
#include "ringfilm/film/solver/point_relaxation.hpp"
#include "scenarios.hpp"

namespace ringfilm::benchmarks {

/// Point relaxation on all sampled steps.
struct MethodCost {
  double seconds_per_cycle = 0;  ///< of processor time
  double effort_per_step = 0;    ///< sweeps
  int failed = 0;                ///< steps without convergence
  double difference = 0;         ///< largest relative one of h_m from the coupled Newton's
};

/// Steps of an integrated cycle of the first scenario, one in `every`, for a method too slow for all of them: it
/// solves them from the coupled Newton's state before and the same guess, to the same tolerance.
class SampledSteps {
 public:
  SampledSteps(const Scenarios& scenarios, int every);

  /// Processor time of the steps, times what makes a cycle of them.
  MethodCost cost(film::RelaxationWorkspace workspace) const;

  /// The fixed over-relaxation factor, of some tried, with which point relaxation needs the fewest sweeps and leaves no
  /// step unsolved; nothing: it fails with all of them.
  std::optional<double> best_factor() const;

 private:
  struct Step {
    film::FilmInputs inputs;
    film::FilmState previous, guess, solution;
  };
  class Sampler;

  std::unique_ptr<cycle::Setup> setup_;  // where the integration looks for it, wherever this object goes
  std::unique_ptr<cycle::TimeIntegration> integration_;
  std::vector<Step> steps_;
};

}  // namespace ringfilm::benchmarks
