#include "ringfilm/life/life_quantities.hpp"

#include <algorithm>
#include <stdexcept>

namespace ringfilm::life {

const std::vector<LifeQuantity>& life_quantities() {
  static const std::vector<LifeQuantity> table = [] {
    const std::vector<std::pair<const char*, Combination>> reported = {
        {"mean_power_loss", Combination::kTimeMean},
        {"mean_boundary_power", Combination::kTimeMean},
        {"mean_viscous_power", Combination::kTimeMean},
        {"energy_per_cycle", Combination::kCycleMean},
        {"fmep", Combination::kCycleMean},
        {"min_film_thickness", Combination::kMin},
        {"min_lambda_ratio", Combination::kMin},
        {"lambda_ratio_at_peak_pressure", Combination::kMin},
        {"boundary_regime_cycle_share", Combination::kTimeMean},
        {"mixed_regime_cycle_share", Combination::kTimeMean},
        {"full_film_cycle_share", Combination::kTimeMean},
        {"peak_friction_coefficient_firing", Combination::kMax},
        {"net_oil_flow", Combination::kTimeMean},
        {"mean_absolute_oil_flow", Combination::kTimeMean},
        {"archard_wear_load", Combination::kCycleMean},
    };
    std::vector<LifeQuantity> quantities;
    for (const auto& [name, combination] : reported) {
      const auto index = cycle::cycle_quantity_index(name);
      if (!index) throw std::logic_error("a value that no cycle has");
      quantities.push_back({cycle::cycle_quantities()[*index], combination});
    }
    return quantities;
  }();
  return table;
}

LifeValues life_values(const cycle::CycleValues& values) {
  LifeValues all;
  for (const LifeQuantity& quantity : life_quantities()) all.push_back(values.*quantity.value);
  return all;
}

LifeValues combined(const std::vector<WeightedValues>& points) {
  if (points.size() == 1) return points.front().values;  // to the bit
  LifeValues all;
  for (std::size_t i = 0; i < life_quantities().size(); ++i) {
    const Combination combination = life_quantities()[i].combination;
    double value =
        combination == Combination::kMin || combination == Combination::kMax ? points.front().values[i] : 0.0;
    for (const WeightedValues& point : points) {
      switch (combination) {
        case Combination::kTimeMean:
          value += point.time_share * point.values[i];
          break;
        case Combination::kCycleMean:
          value += point.cycle_share * point.values[i];
          break;
        case Combination::kMin:
          value = std::min(value, point.values[i]);
          break;
        case Combination::kMax:
          value = std::max(value, point.values[i]);
          break;
      }
    }
    all.push_back(value);
  }
  return all;
}

}  // namespace ringfilm::life
