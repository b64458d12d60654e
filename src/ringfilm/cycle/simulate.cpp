#include "ringfilm/cycle/simulate.hpp"

#include "ringfilm/cycle/cycle_run.hpp"
#include "ringfilm/cycle/menisci_cycle.hpp"

namespace ringfilm::cycle {

CycleResult simulate(const Setup& setup, Observer* observer) {
  if (setup.input.solver.method == Method::kMenisci) {
    std::optional<Setup> on_cells;
    std::optional<CycleResult> result = simulate_menisci(setup, on_cells);
    return result ? *std::move(result) : simulate(*on_cells, observer);
  }
  CycleRun run(setup);
  const int n_steps = steps_per_cycle(setup.input.solver);
  int before = 0;
  integrate_alone(run, [&] {
    const int integrated = run.steps_integrated();
    if (observer != nullptr && integrated > before) observer->advanced(1 + before / n_steps, run.crank_angle_deg());
    before = integrated;
  });
  if (!run.stop()) return run.result();
  if (const std::optional<Setup> graded = second_attempt(setup, *run.stop())) return simulate(*graded, observer);
  throw StoppedCycle(run.stop()->message, run.stop()->crank_angle_deg, run.result());
}

}  // namespace ringfilm::cycle
