#include "ringfilm/io/gas_path/pack_gas.hpp"

namespace ringfilm::io {

PackGas pack_gas(const gas_path::GasPathResult& result, double gas_constant) {
  PackGas gas;
  gas.regions = result.regions;
  for (std::size_t k = 0; k < result.paths.size(); ++k) {
    gas.paths.push_back({path_name(result.paths[k]), result.transported[k]});
  }
  for (const gas_path::RingEvent& event : result.events) {
    gas.events.push_back({static_cast<long>(event.ring), event.crank_angle_deg, event_name(event.event)});
  }
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    if (result.motion[i].has_groove) gas.rings.push_back({static_cast<long>(i + 1)});
  }
  for (std::size_t angle = 0; angle < result.pressure.size(); ++angle) {
    gas.crank_angle_deg.push_back(static_cast<double>(angle));
    gas.pressure.insert(gas.pressure.end(), result.pressure[angle].begin(), result.pressure[angle].end());
    gas.flow.insert(gas.flow.end(), result.flow[angle].begin(), result.flow[angle].end());
    for (const PackGas::Ring& ring : gas.rings) {
      gas.position.push_back(result.position[angle][static_cast<std::size_t>(ring.number - 1)]);
    }
  }
  gas.blow_by_per_cycle = result.blow_by;
  gas.blow_by_flow = blow_by_flow(result, gas_constant);
  gas.mass_defect = result.mass_defect;
  gas.periodicity_error = result.periodicity;
  return gas;
}

}  // namespace ringfilm::io
