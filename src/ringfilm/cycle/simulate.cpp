#include "ringfilm/cycle/simulate.hpp"

#include "ringfilm/cycle/cycle_run.hpp"

namespace ringfilm::cycle {

CycleResult simulate(const Setup& setup, Observer* observer) {
  CycleRun run(setup);
  const int n_steps = steps_per_cycle(setup.input.solver);
  while (!run.done()) {
    const int before = run.steps_marched();
    run.march().propose();
    run.conclude(run.march().solve());
    if (observer != nullptr && run.steps_marched() > before) {
      observer->advanced(1 + before / n_steps, run.crank_angle_deg());
    }
  }
  if (run.stop()) throw StoppedCycle(run.stop()->message, run.stop()->crank_angle_deg, run.result());
  return run.result();
}

}  // namespace ringfilm::cycle
