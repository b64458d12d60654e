#include "ringfilm/gas_path/result.hpp"

#include <algorithm>

#include "ringfilm/base/constants.hpp"

namespace ringfilm::gas_path {

const char* event_name(FlankEvent event) {
  switch (event) {
    case FlankEvent::kLeavesLower:
      return "leaves-lower";
    case FlankEvent::kLandsUpper:
      return "lands-upper";
    case FlankEvent::kLeavesUpper:
      return "leaves-upper";
    case FlankEvent::kLandsLower:
      return "lands-lower";
  }
  return "";
}

namespace {

/// Mass that flows back along all paths for which `holds(path)` [kg].
template <class Condition>
double mass_back(const GasPathResult& result, const Condition& holds) {
  double mass = 0;
  for (std::size_t k = 0; k < result.paths.size(); ++k) {
    if (holds(result.paths[k])) mass += result.back[k];
  }
  return mass;
}

}  // namespace

double reverse_blow_by(const GasPathResult& result, std::size_t ring) {
  return mass_back(result, [ring](const Path& path) { return path.ring == ring && path.kind != PathKind::kAboveRing; });
}

GasSums gas_sums(const GasPathResult& result, double gas_constant) {
  GasSums sums;
  sums.blow_by_per_cycle = result.blow_by;
  sums.blow_by_flow = volume_flow(result, gas_constant);
  sums.reverse_blow_by_per_cycle = reverse_blow_by(result, 0);
  sums.reverse_blow_by_charge_share =
      result.trapped_mass > 0 ? *sums.reverse_blow_by_per_cycle / result.trapped_mass : 0;
  const std::size_t crankcase = result.regions.size() - 1;
  sums.returned_to_chamber_per_cycle = mass_back(result, [](const Path& path) { return path.from == 0; });
  sums.returned_from_crankcase_per_cycle =
      mass_back(result, [crankcase](const Path& path) { return path.to == crankcase; });
  sums.trapped_mass = result.trapped_mass;
  sums.mass_defect = result.mass_defect;
  sums.periodicity_error = result.periodicity;
  if (result.composition) {
    const CompositionResult& composition = *result.composition;
    const ScalarValues &fuel = composition.scalars[kFuelScalar], &water = composition.scalars[kWaterScalar];
    sums.fuel_to_crankcase = fuel.crankcase_flow;
    sums.water_to_crankcase = water.crankcase_flow;
    sums.crankcase_fuel_share = fuel.crankcase_mole_share;
    sums.condensate_in_crankcase = composition.condensate_flow;
    sums.composition_defect = composition.defect;
  }
  sums.cycles_integrated = result.cycles;
  sums.periodic = result.repeats;
  sums.period_in_cycles = result.period;
  return sums;
}

std::vector<PathValues> path_values(const GasPathResult& result) {
  std::vector<PathValues> values;
  for (std::size_t k = 0; k < result.paths.size(); ++k) {
    const double net = result.transported[k], back = result.back[k];
    values.push_back({path_name(result.paths[k]), net, std::max(net + back, 0.0), back});
  }
  return values;
}

double volume_flow(const GasPathResult& result, double gas_constant) {
  return result.blow_by / result.duration * gas_constant * kBlowByTemperature / base::kAtmosphere;
}

}  // namespace ringfilm::gas_path
