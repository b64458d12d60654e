#include "operations.hpp"

#include "counted.hpp"
#include "ringfilm/cycle/simulate_batch.hpp"
#include "ringfilm/film/kernels/kernels_of.hpp"

namespace ringfilm::benchmarks {
namespace {

/// What the integrations of the first scenarios asked of some kernels.
struct Asked {
  double operations = 0, nodes_swept = 0, nodes_stepped = 0;
};

Asked integration(const Scenarios& scenarios, int n_scenarios, const film::FilmKernels& kernels) {
  Asked asked;
  std::size_t given = 0;
  const auto next = [&]() -> std::optional<cycle::Setup> {
    if (given == static_cast<std::size_t>(n_scenarios)) return std::nullopt;
    cycle::Setup setup = scenarios.setup(given++);
    setup.kernels = &kernels;
    return setup;
  };
  const auto finished = [&](const cycle::BatchOutcome& outcome) {
    asked.nodes_stepped += static_cast<double>(outcome.result.effort.crank_steps) * (scenarios.cells() + 1);
  };
  Operations::done = 0;
  const cycle::LaneEffort effort = cycle::simulate_batch(next, finished);
  asked.operations = static_cast<double>(Operations::done);
  asked.nodes_swept = static_cast<double>(effort.node_sweeps);
  return asked;
}

}  // namespace

OperationCount count_operations(const Scenarios& scenarios, int n_scenarios) {
  static constexpr film::FilmKernels counting = film::kernels_of<1, kCounted>("counting");
  static const film::FilmKernels sweeps_counting = [] {
    film::FilmKernels kernels = film::kernels();
    kernels.width = counting.width;
    kernels.sweep = counting.sweep;
    kernels.single_sweep = counting.single_sweep;
    return kernels;
  }();
  const Asked of_sweeps = integration(scenarios, n_scenarios, sweeps_counting);
  const Asked of_all = integration(scenarios, n_scenarios, counting);
  const double per_sweep = of_sweeps.operations / of_sweeps.nodes_swept;
  return {per_sweep, (of_all.operations - per_sweep * of_all.nodes_swept) / of_all.nodes_stepped};
}

}  // namespace ringfilm::benchmarks
