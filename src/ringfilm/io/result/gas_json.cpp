#include "ringfilm/io/result/gas_json.hpp"

#include <optional>
#include <variant>

#include "ringfilm/cycle/pack/gas_quantities.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

template <class Value>
void put(const std::string& name, const Value& value, ordered_json& object) {
  object[name] = value;
}
template <class Value>
void put(const std::string& name, const std::optional<Value>& value, ordered_json& object) {
  if (value) object[name] = *value;
}

template <class Quantities, class Row>
void put_values(const Quantities& quantities, const Row& row, ordered_json& object) {
  for (const auto& quantity : quantities) {
    std::visit([&](auto member) { put(quantity.name, row.*member, object); }, quantity.value);
  }
}

template <class Quantities, class Row>
ordered_json named_rows(const Quantities& quantities, const std::vector<Row>& rows) {
  ordered_json list = ordered_json::array();
  for (const Row& row : rows) put_values(quantities, row, list.emplace_back(ordered_json{{"name", row.name}}));
  return list;
}

template <class Quantities>
void put_units(const Quantities& quantities, ordered_json& units) {
  for (const auto& quantity : quantities) units[quantity.name] = quantity.unit;
}

}  // namespace

void put_gas_sums(const gas_path::GasSums& sums, ordered_json& object) {
  put_values(cycle::gas_sum_quantities(), sums, object);
}

ordered_json gas_object(const PackGas& gas) {
  ordered_json object = ordered_json::object(), units = ordered_json::object();
  put_gas_sums(gas.sums, object);
  object["regions"] = named_rows(cycle::gas_region_quantities(), gas.regions);
  object["ring_events"] = ordered_json::array();
  for (const PackGas::Event& event : gas.events) {
    object["ring_events"].push_back(
        {{"ring", event.ring}, {"crank_angle", event.crank_angle_deg}, {"event", event.event}});
  }
  object["ring_motion"] = ordered_json::array();
  for (std::size_t i = 0; i < gas.motion.size(); ++i) {
    put_values(cycle::gas_ring_quantities(), gas.motion[i],
               object["ring_motion"].emplace_back(ordered_json{{"ring", gas.rings[i].number}}));
  }
  object["paths"] = named_rows(cycle::gas_path_quantities(), gas.paths);
  put_units(cycle::gas_sum_quantities(), units);
  put_units(cycle::gas_region_quantities(), units);
  units["crank_angle"] = "degree";
  put_units(cycle::gas_ring_quantities(), units);
  put_units(cycle::gas_path_quantities(), units);
  object["units"] = std::move(units);
  return object;
}

}  // namespace ringfilm::io
