#include "ringfilm/io/result/pack_gas.hpp"

namespace ringfilm::io {

PackGas pack_gas(const gas_path::GasPathResult& result, double gas_constant, std::optional<double> cylinders) {
  PackGas gas;
  gas.cylinders = cylinders;
  gas.sums = gas_sums(result, gas_constant);
  gas.regions = result.regions;
  gas.paths = path_values(result);
  if (result.composition) {
    gas.scalars = result.composition->scalars;
    gas.share = result.composition->share;
  }
  for (const gas_path::RingEvent& event : result.events) {
    gas.events.push_back({static_cast<long>(event.ring), event.crank_angle_deg, event_name(event.event)});
  }
  for (std::size_t i = 0; i < result.motion.size(); ++i) {
    if (!result.motion[i].has_groove) continue;
    gas.rings.push_back({static_cast<long>(i + 1)});
    gas.motion.push_back(result.motion[i]);
  }
  for (std::size_t angle = 0; angle < result.pressure.size(); ++angle) {
    gas.crank_angle_deg.push_back(static_cast<double>(angle));
    gas.pressure.insert(gas.pressure.end(), result.pressure[angle].begin(), result.pressure[angle].end());
    gas.flow.insert(gas.flow.end(), result.flow[angle].begin(), result.flow[angle].end());
    for (const PackGas::Ring& ring : gas.rings) {
      gas.position.push_back(result.position[angle][static_cast<std::size_t>(ring.number - 1)]);
    }
  }
  return gas;
}

}  // namespace ringfilm::io
