#include "ringfilm/io/result/pack_gas.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../result_example.hpp"
#include "ringfilm/io/result/gas_json.hpp"
#include "ringfilm/io/result/pack_sums.hpp"
#include "ringfilm/io/result/result_csv.hpp"
#include "ringfilm/io/result/result_document.hpp"

/// The gas of a pack and the sums of its rings in results.
namespace ringfilm::io {
namespace {

/// A compression ring, and an oil ring of two rails.
ResultDocument pack_of_three_films() {
  std::vector<ResultDocument> rings(3, example_document());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    rings[i].rail = static_cast<long>(i);
    rings[i].result.complete = true;
    rings[i].result.values.fmep = 1e3 * static_cast<double>(i + 1);
  }
  return pack_document("pack", std::move(rings));
}

gas_path::GasPathResult gas_of_two_regions() {
  gas_path::GasPathResult gas;
  gas.regions = {{"chamber", 60e5, 15, 6e5}, {"crankcase", 1e5, 0, 1e5}};
  gas.paths = {{gas_path::PathKind::kEndGap, 0, 0, 1}};
  gas.pressure.assign(720, {2e5, 1e5});
  gas.flow.assign(720, {3e-4});
  gas.position.assign(720, {2e-5});
  gas.transported = {2e-6};
  gas.back = {5e-7};
  gas.events = {{1, 123.5, gas_path::FlankEvent::kLeavesLower}};
  gas.motion.emplace_back().has_groove = true;
  gas.motion.back().departures = 2;
  gas.motion.back().flutters = true;
  gas.motion.back().least_seating_force = -12.5;
  gas.motion.back().unseated_share = 0.25;
  gas.motion.back().largest_static_twist = 1e-3;
  gas.cycles = 7;
  gas.period = 2;
  gas.blow_by = 2e-6;
  gas.duration = 0.08;
  return gas;
}

TEST(PackGas, IsTheSameFromTheFile) {
  ResultDocument pack = pack_of_three_films();
  pack.gas = pack_gas(gas_of_two_regions(), 287);
  const ResultDocument read = result_of_bytes("a pack", result_bytes(pack));
  ASSERT_TRUE(read.gas);
  EXPECT_EQ(read.gas->pressure, pack.gas->pressure);
  EXPECT_EQ(read.gas->flow, pack.gas->flow);
  EXPECT_EQ(read.gas->position, pack.gas->position);
  EXPECT_EQ(read.gas->crank_angle_deg, pack.gas->crank_angle_deg);
  EXPECT_EQ(read.gas->regions.at(0).name, "chamber");
  EXPECT_EQ(read.gas->paths.at(0).name, "end gap 1");
  ASSERT_EQ(read.gas->events.size(), 1U);
  EXPECT_EQ(read.gas->events[0].event, "leaves-lower");
  EXPECT_EQ(read.gas->events[0].crank_angle_deg, 123.5);
  EXPECT_EQ(read.gas->rings.at(0).number, 1);
  EXPECT_EQ(gas_object(*read.gas), gas_object(*pack.gas));
  EXPECT_EQ(ring_numbers(read), ring_numbers(pack));
}

TEST(PackGas, HasEachQuantityInSiWithItsUnit) {
  const PackGas gas = pack_gas(gas_of_two_regions(), 287);
  const nlohmann::ordered_json object = gas_object(gas);
  // 2 mg in 80 ms at 101325/(287 298.15) kg/m3.
  EXPECT_NEAR(object["blow_by_flow"], 2e-6 / 0.08 * 287 * 298.15 / 101325, 1e-12 * 2e-5);
  EXPECT_EQ(object["units"]["blow_by_flow"], "m3/s");
  EXPECT_EQ(object["units"]["largest_static_twist"], "rad");
  EXPECT_EQ(object["cycles_integrated"], 7);
  EXPECT_EQ(object["period_in_cycles"], 2);
  EXPECT_EQ(object["periodic"], false);
  const nlohmann::ordered_json& path = object["paths"].at(0);
  EXPECT_EQ(path["name"], "end gap 1");
  EXPECT_DOUBLE_EQ(path["mass_forward_per_cycle"], 2.5e-6);
  EXPECT_EQ(path["mass_back_per_cycle"], 5e-7);
  const nlohmann::ordered_json& ring = object["ring_motion"].at(0);
  EXPECT_EQ(ring["departures_from_lower_flank"], 2);
  EXPECT_EQ(ring["flutters"], true);
  EXPECT_EQ(ring["least_seating_force"], -12.5);
  EXPECT_EQ(ring["unseated_share"], 0.25);
  EXPECT_EQ(ring["largest_static_twist"], 1e-3);
  EXPECT_FALSE(ring.contains("twisted_share"));
}

TEST(PackGas, OfAnEarlierFileLacksWhatItDoesNotHave) {
  PackGas gas = pack_gas(gas_of_two_regions(), 287);
  gas.motion.clear();
  gas.sums.periodic.reset();
  ResultDocument pack = pack_of_three_films();
  pack.gas = gas;
  const nlohmann::ordered_json object = gas_object(*result_of_bytes("a pack", result_bytes(pack)).gas);
  EXPECT_TRUE(object["ring_motion"].empty());
  EXPECT_FALSE(object.contains("periodic"));
  EXPECT_TRUE(object.contains("period_in_cycles"));
}

TEST(PackGas, OfGivenPressuresIsAbsent) {
  EXPECT_FALSE(result_of_bytes("a pack", result_bytes(pack_of_three_films())).gas);
}

TEST(PackSums, RailsAreOneRing) {
  const ResultDocument pack = pack_of_three_films();
  EXPECT_EQ(ring_numbers(pack), (std::vector<std::size_t>{1, 2, 2}));
  const std::vector<RingSums> sums = ring_sums(pack);
  ASSERT_EQ(sums.size(), 2U);
  EXPECT_EQ(sums[1].ring, 2U);
  EXPECT_DOUBLE_EQ(sums[1].values.fmep, 5e3);
  EXPECT_EQ(pack.rings[2].title.find("pack: ring 2"), 0U);
}

TEST(PackSums, TheBoundOfOilIsAllThatTheFirstRingLeavesOnDownstrokes) {
  ResultDocument pack = pack_of_three_films();
  EXPECT_FALSE(pack_oil(pack));
  ResultDocument& first = pack.rings.front();
  first.inputs.push_back({"engine.bore", "0.1", "100 mm", false, "", 0.1});
  std::erase_if(first.inputs, [](const CaseEntry& one) { return one.key == "engine.bore" && one.value != "0.1"; });
  first.result.derived["oil_density"] = 800;
  first.result.stroke.liner_position = {0.01, 0.03, 0.05, 0.07};
  first.result.stroke.film_behind[0] = {1e-6, 1e-6, 2e-6, 2e-6};
  first.result.stroke.film_behind[2] = {1e-6, 1e-6, 1e-6, 1e-6};
  const auto oil = pack_oil(pack);
  ASSERT_TRUE(oil);
  EXPECT_DOUBLE_EQ(oil->film_after_power_stroke, 1.5e-6);
  EXPECT_DOUBLE_EQ(oil->film_after_intake_stroke, 1e-6);
  EXPECT_NEAR(oil->to_chamber_upper_bound, 2.5e-6 * 0.08 * 0.1 * 3.14159265 * 800, 1e-12);
}

}  // namespace
}  // namespace ringfilm::io
