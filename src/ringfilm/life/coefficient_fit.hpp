#pragma once
#include "ringfilm/life/life_run.hpp"
#include "ringfilm/life/pack_gas.hpp"

namespace ringfilm::life {

/// Wear coefficients that the measured faces allow, eq-life-fit: with roughness and shear strength of the base case,
/// the faces that a scenario passes do not depend on its coefficient, which only sets the clock. The duty wears the
/// face until it has lost the largest lower bound and has passed the faces that it is compared with.
CoefficientFit fit_coefficient(const Life& life, const CycleIntegrators& integrators, PackGas& gas);

}  // namespace ringfilm::life
