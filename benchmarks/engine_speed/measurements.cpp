#include "measurements.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include "engine_runs.hpp"
#include "fma_peak/fma_peak.hpp"
#include "operations.hpp"
#include "processor.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "sampled_steps.hpp"

namespace ringfilm::benchmarks {
namespace {

constexpr int kSampleEvery = 10;
constexpr int kSparseEvery = 40;  // where point relaxation would take longest
constexpr int kCountedScenarios = 4;
constexpr std::size_t kTimedScenarios = 16;
constexpr long kPeakRounds = 4'000'000;

/// What is made once for a number of cells and a cavitation model, when it is first asked for.
template <class Made>
class Once {
 public:
  explicit Once(std::function<Made()> make) : make_(std::move(make)) {}
  const Made& operator()() {
    if (!made_) made_ = std::make_unique<Made>(make_());
    return *made_;
  }

 private:
  std::function<Made()> make_;
  std::unique_ptr<Made> made_;
};

void add(const std::string& name, int repetitions, const std::function<void(benchmark::State&)>& measure) {
  benchmark::RegisterBenchmark(name.c_str(), measure)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->Repetitions(repetitions);
}

double peak_seconds(long rounds) {
  const FmaPeak& peak = fma_peak(film::kernels().name);
  const double start = processor_seconds();
  benchmark::DoNotOptimize(peak.run(rounds));
  return processor_seconds() - start;
}

double peak_operations() { return kPeakRounds * fma_peak(film::kernels().name).operations_per_round; }

/// Notes the peak around a measurement, the better of before and after: a machine with other work is not always as
/// fast.
class PeakBaseline {
 public:
  explicit PeakBaseline(benchmark::State& state) : state_(state), before_(peak_seconds(kPeakRounds)) {}
  ~PeakBaseline() { state_.counters["peak_flops"] = peak_operations() / std::min(before_, peak_seconds(kPeakRounds)); }
  PeakBaseline(const PeakBaseline&) = delete;
  PeakBaseline& operator=(const PeakBaseline&) = delete;

 private:
  benchmark::State& state_;
  double before_;
};

void register_peak(const Extent& extent) {
  const double operations = peak_operations();
  add("fma-peak", 3 * extent.repetitions, [operations](benchmark::State& state) {
    for (auto _ : state) state.SetIterationTime(peak_seconds(kPeakRounds) / operations);
  });
  add("fma-peak-all-threads", extent.repetitions, [operations, threads = extent.threads](benchmark::State& state) {
    for (auto _ : state) {
      std::vector<double> seconds(threads);
      std::vector<std::thread> workers;
      for (double& share : seconds) workers.emplace_back([&share] { share = peak_seconds(kPeakRounds); });
      for (std::thread& worker : workers) worker.join();
      double slowest = 0;
      for (const double share : seconds) slowest = share > slowest ? share : slowest;
      state.SetIterationTime(slowest / (threads * operations));
    }
  });
}

void count_method(benchmark::State& state, const MethodCost& cost) {
  state.SetIterationTime(cost.seconds_per_cycle);
  state.counters["effort_per_step"] = cost.effort_per_step;
  state.counters["failed_steps"] = cost.failed;
  state.counters["difference"] = cost.difference;
}

using SharedSteps = std::shared_ptr<Once<SampledSteps>>;
using SharedScenarios = std::shared_ptr<Once<Scenarios>>;

void register_point_relaxation(const Extent& extent, const std::string& name, const SharedSteps& steps) {
  auto factor = std::make_shared<Once<std::optional<double>>>([steps] { return (*steps)().best_factor(); });
  add(name, extent.repetitions, [steps, factor](benchmark::State& state) {
    if (!(*factor)()) return state.SkipWithError("no factor converges everywhere");
    for (auto _ : state) count_method(state, (*steps)().cost(film::RelaxationWorkspace({*(*factor)()})));
    state.counters["factor"] = *(*factor)();
  });
}

void count_engine(benchmark::State& state, const Spent& spent) {
  state.SetIterationTime(spent.seconds_per_cycle());
  const auto scenarios = static_cast<double>(spent.scenarios);
  state.counters["iterations_per_step"] = spent.iterations_per_step();
  state.counters["steps_per_cycle"] = static_cast<double>(spent.crank_steps) / spent.cycles;
  state.counters["cycles_per_scenario"] = spent.cycles / scenarios;
  state.counters["making_ready_ms"] = 1e3 * spent.making_ready / scenarios;
  state.counters["stopped"] = static_cast<double>(spent.stopped);
}

void count_batch(benchmark::State& state, const Spent& spent) {
  count_engine(state, spent);
  state.counters["occupation"] = spent.occupation(film::kernels().width);
  state.counters["lane_sweeps_per_cycle"] = static_cast<double>(spent.lanes.lane_sweeps) / spent.cycles;
  state.counters["single_solves"] = static_cast<double>(spent.lanes.single_solves);
}

void register_engine(const Extent& extent, cycle::Cavitation cavitation, int cells, const SharedScenarios& scenarios) {
  add(name_of("coupled-newton", cavitation, cells), extent.repetitions, [scenarios, extent](benchmark::State& state) {
    for (auto _ : state) count_engine(state, run_singly((*scenarios)(), 0, extent.single_scenarios));
  });
  add(name_of("batched", cavitation, cells), extent.repetitions, [scenarios, extent](benchmark::State& state) {
    Spent spent;
    const PeakBaseline peak(state);
    for (auto _ : state) count_batch(state, spent = run_batch((*scenarios)(), 0, extent.batch_scenarios));
    state.counters["heap_per_scenario"] = spent.heap_per_scenario;
  });
  add(name_of("batched-all-threads", cavitation, cells), extent.repetitions,
      [scenarios, extent](benchmark::State& state) {
        for (auto _ : state) {
          count_batch(state, run_batches((*scenarios)(), extent.threads, extent.batch_scenarios));
        }
      });
  auto count = std::make_shared<Once<OperationCount>>(
      [scenarios] { return count_operations((*scenarios)(), kCountedScenarios); });
  add(name_of("newton-sweep", cavitation, cells), extent.repetitions, [scenarios, count](benchmark::State& state) {
    const PeakBaseline peak(state);
    for (auto _ : state) state.SetIterationTime(sweep_seconds_per_node((*scenarios)(), kTimedScenarios));
    state.counters["operations_per_node_and_iteration"] = (*count)().per_node_and_iteration;
    state.counters["operations_per_node_and_step"] = (*count)().per_node_and_step;
    state.counters["block_bytes_per_cell"] = block_bytes_per_cell();
  });
}

void register_sizes(const Extent& extent) {
  auto scenarios =
      std::make_shared<Once<Scenarios>>([] { return Scenarios(kReferenceCells, cycle::Cavitation::kMassConserving); });
  for (const std::size_t size : extent.batch_sizes) {
    add("batch-of/" + std::to_string(size), 1, [scenarios, size](benchmark::State& state) {
      (*scenarios)();
      const bool afresh = forget_peak_resident();
      Spent spent;
      for (auto _ : state) {
        spent = run_batch((*scenarios)(), 0, size);
        state.SetIterationTime(spent.seconds_per_scenario());
      }
      state.counters["occupation"] = spent.occupation(film::kernels().width);
      state.counters["stopped"] = static_cast<double>(spent.stopped);
      if (afresh) state.counters["peak_resident_bytes"] = peak_resident_bytes();
    });
  }
}

}  // namespace

const std::string& name_of(cycle::Cavitation cavitation) {
  static const std::string reynolds = "reynolds-exit", film_content = "mass-conserving";
  return cavitation == cycle::Cavitation::kReynoldsExit ? reynolds : film_content;
}

std::string name_of(const std::string& what, cycle::Cavitation cavitation, int cells) {
  return what + "/" + name_of(cavitation) + "/" + std::to_string(cells);
}

void register_measurements(const Extent& extent) {
  register_peak(extent);
  register_sizes(extent);
  for (const int cells : kCells) {
    for (const auto cavitation : {cycle::Cavitation::kReynoldsExit, cycle::Cavitation::kMassConserving}) {
      auto scenarios = std::make_shared<Once<Scenarios>>([=] { return Scenarios(cells, cavitation); });
      if (cavitation == cycle::Cavitation::kReynoldsExit && cells <= extent.most_relaxed_cells) {
        auto steps = std::make_shared<Once<SampledSteps>>(
            [=] { return SampledSteps((*scenarios)(), cells > 2 * kReferenceCells ? kSparseEvery : kSampleEvery); });
        register_point_relaxation(extent, name_of("point-relaxation", cavitation, cells), steps);
      }
      register_engine(extent, cavitation, cells, scenarios);
    }
  }
}

}  // namespace ringfilm::benchmarks
