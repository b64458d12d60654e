#pragma once
#include "ringfilm/life/life_run.hpp"
#include "ringfilm/life/pack_gas.hpp"

namespace ringfilm::life {

/// The scenario of a face that wears by Archard's law, eq-life-archard.
LifeResult run_archard(const Life& life, const CycleIntegrators& integrators, PackGas& gas);

}  // namespace ringfilm::life
