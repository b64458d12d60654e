#pragma once
#include "ringfilm/life/life_run.hpp"

namespace ringfilm::life {

/// The scenario of a face that wears by Archard's law, eq-life-archard.
LifeResult run_archard(const Life& life, const CycleIntegrators& integrators);

}  // namespace ringfilm::life
