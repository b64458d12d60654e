#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"

/// The benchmarks of the engine by name. Each reports the processor time of one of what it counts.
namespace ringfilm::benchmarks {

inline const std::vector<int> kCells = {100, 200, 400, 800};
inline constexpr int kReferenceCells = 200;

/// How much is measured.
struct Extent {
  int repetitions = 3;                ///< of which the fastest counts
  std::size_t single_scenarios = 8;   ///< integrated one by one
  std::size_t batch_scenarios = 256;  ///< in a call of simulate_batch
  int most_relaxed_cells = 800;       ///< point relaxation is omitted beyond
  int threads = 1;                    ///< of the batches on all threads
  std::vector<std::size_t> batch_sizes = {64, 512, 4096};
};

const std::string& name_of(cycle::Cavitation cavitation);

/// "batched/mass-conserving/200"
std::string name_of(const std::string& what, cycle::Cavitation cavitation, int cells);

/// Registers all of them with Google Benchmark:
///   fma-peak, fma-peak-all-threads                           a floating-point operation
///   point-relaxation/MODEL/CELLS                             an integrated cycle, from sampled steps
///   coupled-newton/..., batched/..., batched-all-threads/... an integrated cycle
///   newton-sweep/MODEL/CELLS                                 a node of a block, all lanes
///   batch-of/COUNT                                           a scenario, set up and integrated
void register_measurements(const Extent& extent);

}  // namespace ringfilm::benchmarks
