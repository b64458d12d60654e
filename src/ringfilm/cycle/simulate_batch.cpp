#include "ringfilm/cycle/simulate_batch.hpp"

#include <map>
#include <utility>

#include "ringfilm/cycle/menisci_cycle.hpp"

namespace ringfilm::cycle {

LaneEffort simulate_batch(const SetupSource& next, const std::function<void(BatchOutcome)>& finished,
                          const std::function<void()>& pulse) {
  std::map<const BatchMember*, std::size_t> index;
  std::size_t n_given = 0;
  const auto start = [&]() -> std::unique_ptr<BatchMember> {
    while (std::optional<Setup> setup = next()) {
      if (setup->input.solver.method == Method::kMenisci) {
        std::optional<Setup> on_cells;
        if (std::optional<CycleResult> result = simulate_menisci(*setup, on_cells)) {
          finished({n_given++, *std::move(result), std::nullopt});
          if (pulse) pulse();
          continue;
        }
        setup = std::move(on_cells);
      }
      auto run = std::make_unique<CycleRun>(*std::move(setup));
      index[run.get()] = n_given++;
      return run;
    }
    return nullptr;
  };
  const auto end = [&](std::unique_ptr<BatchMember> integrating) {
    const auto& run = static_cast<const CycleRun&>(*integrating);
    const auto number = index.extract(&run).mapped();
    std::optional<Setup> again = run.stop() ? second_attempt(run.setup(), *run.stop()) : std::nullopt;
    if (!again) return finished({number, run.result(), run.stop()});
    CycleRun graded(std::move(*again));
    integrate_alone(graded, pulse);
    finished({number, graded.result(), graded.stop()});
  };
  return integrate_side_by_side(start, end, pulse);
}

}  // namespace ringfilm::cycle
