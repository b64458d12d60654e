#include "ringfilm/report/payload/payload_pack.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/result/gas_json.hpp"
#include "ringfilm/io/result/pack_sums.hpp"
#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/report/payload/described.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kGasDigits = 6;

/// The columns of a table of `n` columns, row by row, as one list each.
ordered_json columns(const std::vector<double>& rows, std::size_t n) {
  ordered_json lists = ordered_json::array();
  for (std::size_t column = 0; column < n; ++column) {
    std::vector<double> list;
    for (std::size_t k = column; k < rows.size(); k += n) list.push_back(rows[k]);
    lists.push_back(rounded_list(list, kGasDigits));
  }
  return lists;
}

/// Mass share of one scalar in each region over crank angle.
ordered_json shares(const io::PackGas& gas, std::size_t scalar) {
  const std::size_t n = gas.scalars.size();
  std::vector<double> of_regions;
  for (std::size_t i = scalar; i < gas.share.size(); i += n) of_regions.push_back(gas.share[i]);
  return columns(of_regions, gas.regions.size());
}

/// Values as `run --json` has them, their descriptions, and the curves.
ordered_json gas_payload(const io::PackGas& gas) {
  ordered_json object = io::gas_object(gas), rings = ordered_json::array();
  for (const io::PackGas::Ring& ring : gas.rings) rings.push_back(ring.number);
  object["events"] = std::move(object["ring_events"]);
  object.erase("ring_events");
  object["quantities"] = {{"sums", described_all(cycle::gas_sum_quantities())},
                          {"regions", described_all(cycle::gas_region_quantities())},
                          {"paths", described_all(cycle::gas_path_quantities())},
                          {"composition", described_all(cycle::gas_scalar_quantities())},
                          {"ring_motion", described_all(cycle::gas_ring_quantities())}};
  object["rings"] = std::move(rings);
  object["crank_angle"] = rounded_list(gas.crank_angle_deg, kGasDigits);
  object["pressure"] = columns(gas.pressure, gas.regions.size());
  if (!gas.scalars.empty()) {
    object["fuel_share"] = shares(gas, gas_path::kFuelScalar);
    object["water_share"] = shares(gas, gas_path::kWaterScalar);
  }
  object["flow"] = columns(gas.flow, gas.paths.size());
  object["position"] = columns(gas.position, gas.rings.size());
  return object;
}

ordered_json oil_payload(const io::PackOil& oil) {
  ordered_json object = io::quantities_object(io::pack_oil_quantities(), oil);
  object["quantities"] = described_all(io::pack_oil_quantities());
  return object;
}

ordered_json sums_payload(const cycle::CycleValues& values) {
  return io::quantities_object(cycle::summed_quantities(), values);
}

}  // namespace

ordered_json pack_payload(const io::ResultDocument& pack, std::size_t first_case) {
  ordered_json by_ring = ordered_json::array();
  for (const io::RingSums& ring : io::ring_sums(pack)) {
    by_ring.push_back({{"ring", ring.ring}, {"values", sums_payload(ring.values)}});
  }
  const std::optional<io::PackOil> oil = io::pack_oil(pack);
  return {{"title", pack.title},
          {"n_rings", by_ring.size()},
          {"complete", pack.result.complete},
          {"first_case", first_case},
          {"ring_numbers", io::ring_numbers(pack)},
          {"values", sums_payload(pack.result.values)},
          {"by_ring", std::move(by_ring)},
          {"oil_consumption", io::record_array(pack.oil_losses)},
          {"oil_narrowed_by", io::record_array(cycle::narrowed_bands(pack.oil_losses))},
          {"oil", oil ? oil_payload(*oil) : ordered_json(nullptr)},
          {"gas", pack.gas ? gas_payload(*pack.gas) : ordered_json(nullptr)}};
}

ordered_json gas_alone_payload(const io::PackGas& gas) { return gas_payload(gas); }

}  // namespace ringfilm::report
