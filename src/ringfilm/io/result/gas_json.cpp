#include "ringfilm/io/result/gas_json.hpp"

#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/result/record_json.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

template <class Quantities, class Row>
ordered_json named_rows(const Quantities& quantities, const std::vector<Row>& rows) {
  ordered_json list = ordered_json::array();
  for (const Row& row : rows) put_quantities(quantities, row, list.emplace_back(ordered_json{{"name", row.name}}));
  return list;
}

/// The masses and flows of one cylinder times their number; masses are those of a cycle of all cylinders.
ordered_json engine_object(const gas_path::GasSums& sums, double cylinders) {
  ordered_json object = {{"cylinders", cylinders}};
  for (const cycle::GasSumQuantity& quantity : cycle::gas_sum_quantities()) {
    const std::optional<double> of_cylinder = cycle::number_of(quantity, sums);
    if (of_cylinder && (quantity.unit == "kg" || quantity.unit == "kg/s" || quantity.unit == "m3/s")) {
      object[quantity.name] = cylinders * *of_cylinder;
    }
  }
  return object;
}

}  // namespace

ordered_json gas_object(const PackGas& gas) {
  ordered_json object = quantities_object(cycle::gas_sum_quantities(), gas.sums), units = ordered_json::object();
  if (gas.cylinders) object["engine"] = engine_object(gas.sums, *gas.cylinders);
  object["regions"] = named_rows(cycle::gas_region_quantities(), gas.regions);
  object["ring_events"] = ordered_json::array();
  for (const PackGas::Event& event : gas.events) {
    object["ring_events"].push_back(
        {{"ring", event.ring}, {"crank_angle", event.crank_angle_deg}, {"event", event.event}});
  }
  object["ring_motion"] = ordered_json::array();
  for (std::size_t i = 0; i < gas.motion.size(); ++i) {
    put_quantities(cycle::gas_ring_quantities(), gas.motion[i],
                   object["ring_motion"].emplace_back(ordered_json{{"ring", gas.rings[i].number}}));
  }
  object["paths"] = named_rows(cycle::gas_path_quantities(), gas.paths);
  for (ordered_json& path : object["paths"]) {
    for (const char* flow : {"mass_forward", "mass_back"}) {  // short names of the same masses per cycle
      const std::string long_name = std::string(flow) + "_per_cycle";
      if (path.contains(long_name)) path[flow] = path[long_name];
    }
  }
  if (!gas.scalars.empty()) {
    object["composition"] = named_rows(cycle::gas_scalar_quantities(), gas.scalars);
    put_units(cycle::gas_scalar_quantities(), units);
  }
  put_units(cycle::gas_sum_quantities(), units);
  put_units(cycle::gas_region_quantities(), units);
  units["crank_angle"] = "degree";
  put_units(cycle::gas_ring_quantities(), units);
  put_units(cycle::gas_path_quantities(), units);
  units["mass_forward"] = units["mass_back"] = "kg";
  object["units"] = std::move(units);
  return object;
}

}  // namespace ringfilm::io
