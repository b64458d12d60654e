#pragma once
#include <cstddef>
#include <functional>
#include <optional>

#include "ringfilm/cycle/cycle_run.hpp"

namespace ringfilm::cycle {

/// A scenario of a batch that has come to its end.
struct BatchOutcome {
  std::size_t index;         ///< in the order in which the scenarios were given, from 0
  CycleResult result;        ///< all up to the last good angle if the integration stopped
  std::optional<Stop> stop;  ///< why it did
};

/// Gives the scenarios one by one; nothing: there are no more.
using SetupSource = std::function<std::optional<Setup>()>;

/// Simulates the cycle of every scenario that `next` gives, films side by side in the lanes of a vector register, and
/// reports each as it finishes, not in order. Memory does not grow with their number: a scenario is asked for when a
/// lane is free, and at most 64 of other kinds are read ahead. Same setup, same bits, whatever else is in the batch;
/// not the bits of `simulate`, from which every value differs by what the iteration may leave (solver.tolerance).
/// `pulse` is called now and then, every few crank steps at the latest; what it throws ends the batch. One thread.
LaneEffort simulate_batch(const SetupSource& next, const std::function<void(BatchOutcome)>& finished,
                          const std::function<void()>& pulse = {});

}  // namespace ringfilm::cycle
