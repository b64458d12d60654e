#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "processor.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/film/kernels/kernels.hpp"
#include "tables.hpp"

// usage: engine_speed [--quick] [--scenarios=COUNT] [--benchmark_out=FILE] [--benchmark_filter=REGEX]
// How fast engine cycles are integrated, by every method and in lanes, against the machine's limit; see
// docs/manual/performance.md.
namespace ringfilm::benchmarks {
namespace {

void print_machine(const Extent& extent) {
  const film::FilmKernels& kernels = film::kernels();
  const std::string name(kernels.name);
  const std::string width = std::to_string(kernels.width);
  const std::string load = machine_load();
  benchmark::AddCustomContext("processor", processor_name());
  benchmark::AddCustomContext("kernels", name);
  benchmark::AddCustomContext("lanes", width);
  benchmark::AddCustomContext("load_before", load);
  std::printf("processor  %s\n", processor_name().c_str());
  std::printf("load       %s before the run (1, 5, 15 minutes)\n", load.c_str());
  std::printf("kernels    %s, %s lanes\n", name.c_str(), width.c_str());
  std::printf(
      "case       new ring of styles2014, fixed steps of 1 degree, properties by certified fits, tolerance 1e-8\n");
  std::printf(
      "yardstick  point relaxation, reynolds-exit, best factor, sampled steps: one in 10, at 800 cells in 40\n");
  std::printf("times      processor time, the fastest of %d; %zu scenarios in a batch, %zu one by one\n",
              extent.repetitions, extent.batch_scenarios, extent.single_scenarios);
  if (extent.most_relaxed_cells < kCells.back()) {
    std::printf("OMITTED    point relaxation beyond %d cells\n", extent.most_relaxed_cells);
  }
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  Extent extent;
  extent.threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  benchmark::Initialize(&argc, argv);
  const std::string more = "--scenarios=";
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--quick") {
      extent.repetitions = 1;
      extent.single_scenarios = 2;
      extent.batch_scenarios = 64;
      extent.most_relaxed_cells = 400;
      extent.batch_sizes = {64, 256};
    } else if (word.rfind(more, 0) == 0 && std::atol(word.c_str() + more.size()) > 0) {
      extent.batch_sizes.push_back(static_cast<std::size_t>(std::atol(word.c_str() + more.size())));
    } else {
      std::fprintf(stderr, "engine_speed: unknown argument %s\n", word.c_str());
      return 2;
    }
  }
  print_machine(extent);
  register_measurements(extent);
  Figures figures;
  Collector collector(figures);
  benchmark::RunSpecifiedBenchmarks(&collector);
  print_tables(figures, extent);
  std::printf("\nload       %s after the run\n", machine_load().c_str());
  benchmark::Shutdown();
  return 0;
}

}  // namespace
}  // namespace ringfilm::benchmarks

int main(int argc, char** argv) {
  try {
    return ringfilm::benchmarks::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "engine_speed: %s\n", error.what());
    return 1;
  }
}
