#include "engine_runs.hpp"

#include <algorithm>
#include <optional>
#include <thread>
#include <vector>

#include "processor.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/film/solver/lane_newton.hpp"

namespace ringfilm::benchmarks {
namespace {

void add(const cycle::CycleResult& result, Spent& spent) {
  ++spent.scenarios;
  spent.cycles += result.effort.cycles_integrated;
  spent.crank_steps += result.effort.crank_steps;
  spent.iterations += result.effort.newton_iterations;
}

/// A sweep that leaves what any sweep leaves; one in some is first done several times over by the clock. Kernels are
/// plain functions, so their results must be independent.
struct TimedSweep {
  static constexpr long kEvery = 61;  // no multiple of anything in an integration
  static constexpr int kRepeats = 16;
  static inline long calls = 0;
  static inline double seconds = 0, nodes = 0;

  static void sweep(film::LaneBlock& block) {
    const film::FilmKernels& kernels = film::kernels();
    if (++calls % kEvery == 0) {
      const std::vector<double> z(block.z, block.z + static_cast<long>(block.n_cells + 1) * kernels.width);
      const double start = processor_seconds();
      for (int k = 0; k < kRepeats; ++k) kernels.sweep(block);
      seconds += processor_seconds() - start;
      nodes += static_cast<double>(kRepeats) * (block.n_cells + 1);
      std::copy(z.begin(), z.end(), block.z);
    }
    kernels.sweep(block);
  }
};

}  // namespace

Spent run_singly(const Scenarios& scenarios, std::size_t first, std::size_t count) {
  Spent spent;
  for (std::size_t i = first; i < first + count; ++i) {
    const double start = processor_seconds();
    const cycle::Setup setup = scenarios.setup(i);
    const double ready = processor_seconds();
    spent.making_ready += ready - start;
    add(cycle::simulate(setup), spent);
    spent.integrating += processor_seconds() - ready;
  }
  return spent;
}

Spent run_batch(const Scenarios& scenarios, std::size_t first, std::size_t count) {
  Spent spent;
  const double heap_before = heap_bytes();
  double heap = heap_before;
  std::size_t given = 0;
  const auto n_watched =
      static_cast<std::size_t>(4 * film::kernels().width);  // by then integrations have come to their end
  const auto next = [&]() -> std::optional<cycle::Setup> {
    if (given == count) return std::nullopt;
    const double start = processor_seconds();
    if (given <= n_watched) heap = std::max(heap, heap_bytes());
    std::optional<cycle::Setup> setup = scenarios.setup(first + given++);
    spent.making_ready += processor_seconds() - start;
    return setup;
  };
  const auto finished = [&](const cycle::BatchOutcome& outcome) {
    add(outcome.result, spent);
    spent.stopped += outcome.stop.has_value();
  };
  const double start = processor_seconds();
  spent.lanes = cycle::simulate_batch(next, finished);
  spent.integrating = processor_seconds() - start - spent.making_ready;
  spent.heap_per_scenario = (heap - heap_before) / film::kernels().width;
  return spent;
}

Spent run_batches(const Scenarios& scenarios, int threads, std::size_t count) {
  std::vector<Spent> shares(threads);
  std::vector<std::thread> workers;
  for (int t = 0; t < threads; ++t) {
    workers.emplace_back([&, t] { shares[t] = run_batch(scenarios, static_cast<std::size_t>(t) * count, count); });
  }
  for (std::thread& worker : workers) worker.join();
  Spent all = *std::max_element(shares.begin(), shares.end(),
                                [](const Spent& a, const Spent& b) { return a.integrating < b.integrating; });
  all.scenarios = all.crank_steps = all.iterations = all.stopped = 0;
  all.cycles = 0;
  all.lanes = {};
  for (const Spent& share : shares) {
    all.scenarios += share.scenarios;
    all.crank_steps += share.crank_steps;
    all.iterations += share.iterations;
    all.stopped += share.stopped;
    all.cycles += share.cycles;
    all.lanes.sweeps += share.lanes.sweeps;
    all.lanes.lane_sweeps += share.lanes.lane_sweeps;
  }
  return all;
}

double sweep_seconds_per_node(const Scenarios& scenarios, std::size_t count) {
  static const film::FilmKernels timing = [] {
    film::FilmKernels kernels = film::kernels();
    kernels.sweep = TimedSweep::sweep;
    return kernels;
  }();
  TimedSweep::calls = 0;
  TimedSweep::seconds = TimedSweep::nodes = 0;
  std::size_t given = 0;
  const auto next = [&]() -> std::optional<cycle::Setup> {
    if (given == count) return std::nullopt;
    cycle::Setup setup = scenarios.setup(given++);
    setup.kernels = &timing;
    return setup;
  };
  cycle::simulate_batch(next, [](const cycle::BatchOutcome&) {});
  return TimedSweep::seconds / TimedSweep::nodes;
}

double block_bytes_per_cell() {
  constexpr int kFew = 1000, kMany = 9000;
  const film::FilmKernels& kernels = film::kernels();
  const double before = heap_bytes();
  const film::LaneNewton small(kernels, kernels.width, kFew);
  const double with_small = heap_bytes();
  const film::LaneNewton large(kernels, kernels.width, kMany);
  return (heap_bytes() - with_small - (with_small - before)) / (kMany - kFew);
}

}  // namespace ringfilm::benchmarks
