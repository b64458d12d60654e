#pragma once
#include "ringfilm/cycle/simulate_batch.hpp"
#include "scenarios.hpp"

/// Whole cycles through our own engine, one at a time or in lanes.
namespace ringfilm::benchmarks {

/// What some scenarios took. Times are processor time of the thread that integrated.
struct Spent {
  double integrating = 0;   ///< all but making ready [s]
  double making_ready = 0;  ///< of the setups [s]
  long scenarios = 0, crank_steps = 0, iterations = 0;
  long stopped = 0;              ///< scenarios without a cycle that repeats
  double cycles = 0;             ///< integrated
  cycle::LaneEffort lanes;       ///< of a batch
  double heap_per_scenario = 0;  ///< most that the heap grew, over the number of lanes [byte]

  double seconds_per_cycle() const { return integrating / cycles; }
  double seconds_per_scenario() const { return (integrating + making_ready) / static_cast<double>(scenarios); }
  double iterations_per_step() const { return static_cast<double>(iterations) / static_cast<double>(crank_steps); }
  /// Share of the lanes that had a film to iterate.
  double occupation(int width) const {
    return static_cast<double>(lanes.lane_sweeps) / (static_cast<double>(lanes.sweeps) * width);
  }
};

/// Scenarios first ... first + count - 1, one after the other by cycle::simulate.
Spent run_singly(const Scenarios& scenarios, std::size_t first, std::size_t count);

/// The same by one call of cycle::simulate_batch, on the thread that calls.
Spent run_batch(const Scenarios& scenarios, std::size_t first, std::size_t count);

/// `threads` calls of cycle::simulate_batch at once, each with `count` scenarios of its own. All that can be summed is;
/// `integrating` and `making_ready` are those of the slowest thread.
Spent run_batches(const Scenarios& scenarios, int threads, std::size_t count);

/// Processor time that Newton's sweep alone takes for a node of a block, all lanes [s]: some of the sweeps of a batch
/// are done again and again where they occur.
double sweep_seconds_per_node(const Scenarios& scenarios, std::size_t count);

/// Memory of a block of lanes [byte per cell].
double block_bytes_per_cell();

}  // namespace ringfilm::benchmarks
