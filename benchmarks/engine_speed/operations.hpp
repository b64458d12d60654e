#pragma once
#include "scenarios.hpp"

namespace ringfilm::benchmarks {

/// Floating-point operations that the kernels ask for, counted while they run.
struct OperationCount {
  double per_node_and_iteration;  ///< of Newton's sweep
  double per_node_and_step;       ///< of what follows a solved film: its oil and its sums over the face
};

/// Over the integrations of the first scenarios. Contact counts where the surfaces of the film at hand are near enough.
OperationCount count_operations(const Scenarios& scenarios, int n_scenarios);

}  // namespace ringfilm::benchmarks
