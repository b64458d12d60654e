#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/life/life_result.hpp"

namespace ringfilm::life {

/// A cycle that a life requires.
struct CycleRequest {
  cycle::Case input;  ///< a case of one ring or a pack
  std::string name;   ///< for messages, e.g. "10 h, idle"
};

/// Integrates cycles; results in the order of the requests. Throws ConvergenceError with the name of a request that
/// has no solution.
using CycleIntegrator = std::function<std::vector<cycle::CycleResult>(const std::vector<CycleRequest>&)>;

/// What integrates the cycles of a life.
struct CycleIntegrators {
  CycleIntegrator alone;         ///< with the bits of a case that is run alone: for what is reported
  CycleIntegrator side_by_side;  ///< many cycles in the lanes of a batch: for bands and wear
};

/// Computes a life without faults_of().
LifeResult run_life(const Life& life, const CycleIntegrators& integrators);

}  // namespace ringfilm::life
