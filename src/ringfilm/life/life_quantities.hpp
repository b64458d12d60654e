#pragma once
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Values of cycles that a life reports, and what becomes of them over several operating points.
namespace ringfilm::life {

/// How the values of the operating points make that of the duty.
enum class Combination {
  kTimeMean,   ///< weighted with the share of the time
  kCycleMean,  ///< weighted with the share of the cycles: of what counts per cycle
  kMin,
  kMax
};

/// A value of a cycle over the life.
struct LifeQuantity : cycle::CycleQuantity {
  Combination combination;
};

/// In the order of files and tables.
const std::vector<LifeQuantity>& life_quantities();

/// One value for each of life_quantities().
using LifeValues = std::vector<double>;

LifeValues life_values(const cycle::CycleValues& values);  ///< those of one cycle

/// A cycle that is one of several.
struct WeightedValues {
  double time_share;   ///< share of the running time [-]
  double cycle_share;  ///< share of the number of cycles [-]
  LifeValues values;   ///< values of this cycle
};
LifeValues combined(const std::vector<WeightedValues>& points);  ///< eq-life-duty

}  // namespace ringfilm::life
