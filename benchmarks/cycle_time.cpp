#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "marched_case.hpp"
#include "ringfilm/cycle/simulate.hpp"

/// Processor time of one marched engine cycle (fixed steps of 1 degree) against the number of cells, for both
/// cavitation models. Absolute times belong to the machine; the ratios printed at the end can be compared between
/// machines.
namespace ringfilm {
namespace {

const std::vector<int> kCells = {100, 200, 400, 800};
constexpr int kReferenceCells = 200;
constexpr const char* kFastest = "fastest";

void marched_cycle(benchmark::State& state, cycle::Cavitation cavitation) {
  const cycle::Setup setup = cycle::prepare(case_to_march(static_cast<int>(state.range(0)), cavitation));
  cycle::Effort effort;
  for (auto _ : state) {
    const std::clock_t start = std::clock();
    effort = cycle::simulate(setup).effort;
    const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    state.SetIterationTime(spent / effort.cycles_marched);
  }
  state.counters["iterations_per_step"] =
      static_cast<double>(effort.newton_iterations) / static_cast<double>(effort.crank_steps);
  state.counters["cycles_marched"] = effort.cycles_marched;
  state.counters["fallbacks"] = static_cast<double>(effort.fallback_secant + effort.fallback_sub_step);
}

void making_ready(benchmark::State& state) {
  const cycle::Case c = case_to_march(kReferenceCells, cycle::Cavitation::kMassConserving);
  for (auto _ : state) benchmark::DoNotOptimize(cycle::prepare(c));
}

/// Keeps the fastest time of each benchmark beside what the console shows.
class FastestReporter : public benchmark::ConsoleReporter {
 public:
  FastestReporter() : ConsoleReporter(OO_Tabular) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.aggregate_name == kFastest) {
        fastest_[run.run_name.function_name + "/" + run.run_name.args] = run.GetAdjustedRealTime();  // [ms]
      }
    }
    ConsoleReporter::ReportRuns(runs);
  }

  void print_ratios() const {
    const auto reference = fastest_.find(name("reynolds-exit", kReferenceCells));
    if (reference == fastest_.end()) return;
    std::printf("\nfastest run of a marched cycle, 720 steps of 1 degree; ratio to reynolds-exit at %d cells\n",
                kReferenceCells);
    std::printf("%8s %26s %26s\n", "cells", "reynolds-exit", "mass-conserving");
    for (const int cells : kCells) {
      std::printf("%8d", cells);
      for (const char* model : {"reynolds-exit", "mass-conserving"}) {
        const auto at = fastest_.find(name(model, cells));
        if (at == fastest_.end()) continue;
        std::printf("    %9.2f ms  x %7.2f", at->second, at->second / reference->second);
      }
      std::printf("\n");
    }
  }

 private:
  static std::string name(const std::string& model, int cells) {
    return "marched_cycle/" + model + "/" + std::to_string(cells);
  }

  std::map<std::string, double> fastest_;
};

void register_all() {
  const std::vector<std::pair<const char*, cycle::Cavitation>> models = {
      {"reynolds-exit", cycle::Cavitation::kReynoldsExit}, {"mass-conserving", cycle::Cavitation::kMassConserving}};
  for (const auto& [model, cavitation] : models) {
    auto* marched = benchmark::RegisterBenchmark(
        (std::string("marched_cycle/") + model).c_str(),
        [cavitation = cavitation](benchmark::State& state) { marched_cycle(state, cavitation); });
    for (const int cells : kCells) marched->Arg(cells);
    marched->UseManualTime()->Unit(benchmark::kMillisecond)->Repetitions(5)->DisplayAggregatesOnly(true);
    marched->ComputeStatistics(
        kFastest, [](const std::vector<double>& times) { return *std::min_element(times.begin(), times.end()); });
  }
  benchmark::RegisterBenchmark("making_ready", making_ready)->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace ringfilm

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  ringfilm::register_all();
  ringfilm::FastestReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_ratios();
}
