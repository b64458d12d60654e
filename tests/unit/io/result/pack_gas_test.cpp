#include "ringfilm/io/gas_path/pack_gas.hpp"

#include <gtest/gtest.h>

#include "../result_example.hpp"
#include "ringfilm/io/gas_path/pack_sums.hpp"
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
  gas.events = {{1, 123.5, gas_path::FlankEvent::kLeavesLower}};
  gas.motion.emplace_back().has_groove = true;
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
  EXPECT_EQ(read.gas->blow_by_per_cycle, 2e-6);
  EXPECT_EQ(read.gas->rings.at(0).number, 1);
  EXPECT_EQ(ring_numbers(read), ring_numbers(pack));
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
  EXPECT_DOUBLE_EQ(sums[1].fmep, 5e3);
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
