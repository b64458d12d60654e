#include "ringfilm/gas_path/solve_gas_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <string>

#include "pack_cases.hpp"

namespace ringfilm::gas_path {
namespace {

std::vector<std::string> region_names(const GasPathResult& result) {
  std::vector<std::string> names;
  for (const RegionValues& region : result.regions) names.push_back(region.name);
  return names;
}

double largest_flow(const GasPathResult& result, std::size_t path) {
  double largest = 0;
  for (const auto& flow : result.flow) largest = std::max(largest, flow[path]);
  return largest;
}

TEST(GasPath, RegionsAreNamedFromTheChamberToTheCrankcase) {
  const auto result = solve_gas_path(two_ring_pack());
  EXPECT_EQ(region_names(result),
            (std::vector<std::string>{"chamber", "groove 1", "land 2", "groove 2", "land 3", "crankcase"}));
}

TEST(GasPath, ALandOfNoVolumeIsTheRegionBelowIt) {
  Pack pack = two_ring_pack();
  pack.rings[1].volume_below = 0;
  pack.rings.pop_back();
  const auto result = solve_gas_path(pack);
  EXPECT_EQ(region_names(result), (std::vector<std::string>{"chamber", "groove 1", "land 2", "groove 2", "crankcase"}));
  EXPECT_GT(result.blow_by, 0);
}

// Rings below a piston land of no volume may have the crankcase on both sides: no gas passes them.
TEST(GasPath, RingsWithTheCrankcaseOnBothSidesChangeNothing) {
  for (const RingMotion motion : {RingMotion::kSeated, RingMotion::kAxial}) {
    Pack one = two_ring_pack();
    one.ring_motion = motion;
    one.rings.resize(1);
    one.rings[0].volume_below = 0;
    const auto alone = solve_gas_path(one);
    Pack pack = one;
    pack.rings.resize(4, one.rings[0]);
    const auto result = solve_gas_path(pack);
    EXPECT_GT(result.blow_by, 0);
    EXPECT_NEAR(result.blow_by, alone.blow_by, 1e-6 * alone.blow_by);
    EXPECT_LT(result.mass_defect, 1e-12);
    EXPECT_NEAR(result.regions.at(1).peak_pressure, alone.regions.at(1).peak_pressure, 1e-6 * 6e6);
  }
}

// A film that never opens seals; one that opens around firing lets gas pass, and no mass is lost.
TEST(GasPath, GasPassesAFaceWhereItIsOpen) {
  Pack pack = two_ring_pack();
  const auto sealed = solve_gas_path(pack);
  pack.rings[0].face_opening.assign(720, 0.0);
  EXPECT_NEAR(solve_gas_path(pack).blow_by, sealed.blow_by, 1e-6 * sealed.blow_by);
  for (int angle = 0; angle < 40; ++angle) pack.rings[0].face_opening[angle] = 1e-6;
  const auto open = solve_gas_path(pack);
  EXPECT_GT(open.blow_by, 1.01 * sealed.blow_by);
  EXPECT_LT(open.mass_defect, 1e-12);
  const auto face = std::ranges::find(open.paths, PathKind::kFace, &Path::kind);
  ASSERT_NE(face, open.paths.end());
  EXPECT_EQ(path_name(*face), "face of ring 1");
  EXPECT_GT(open.transported[static_cast<std::size_t>(face - open.paths.begin())], 0);
}

// Laminar flow through the gap over the face, far from choking: eq-channel-flow.
TEST(GasPath, TheFaceIsAChannelAroundTheBore) {
  Pack pack = two_ring_pack();
  pack.rings[0].face_opening.assign(720, 0.5e-6);
  const Network network(pack);
  const Path path{PathKind::kFace, 0, 0, 2};
  const double p_a = 1.2e5, p_b = 1.1e5, c = 0.5e-6;
  const double closed_form = (p_a * p_a - p_b * p_b) * c * c * c * std::numbers::pi * pack.bore /
                             (24 * pack.gas.viscosity * pack.gas.gas_constant * pack.chamber_temperature * 1.2e-3);
  EXPECT_NEAR(network.flow(path, p_a, p_b, c), closed_form, 1e-3 * closed_form);
  const std::vector<double> pressure(network.n_regions(), 1e5);
  EXPECT_DOUBLE_EQ(network.face_opening(0, 719.5, pressure), 0.5e-6);
}

// A weak second ring whose piston land above fills slowly: sealed, the gas below would press it off by bars.
TEST(GasPath, ARingThatGasPressesOffTheLinerOpensLikeAValve) {
  Pack pack = two_ring_pack();
  pack.rings[0].gap_area = 2e-8;
  pack.rings[1].gap_area = 1e-8;
  pack.rings[1].elastic_pressure = 1e4;
  pack.chamber = models::CyclePressure(101325.0);
  std::vector<double> angle, pressure;
  for (int k = 0; k < 720; ++k) {
    angle.push_back(k);
    pressure.push_back(k < 360 ? 4e5 : 101325.0);
  }
  pack.crankcase = {angle, pressure};
  const GasPathResult sealed = solve_gas_path(pack);
  EXPECT_EQ(sealed.motion[1].off_liner_share, 0) << "no stiffness is stated";
  pack.rings[1].collapse = {0.25, models::radial_stiffness(3.5e-3, 1.2e11, pack.bore), 5e-5};
  const GasPathResult open = solve_gas_path(pack);
  const Network network(pack);
  double before = 0, now = 0;  // largest pressures off the liner
  for (int k = 0; k < 720; ++k) {
    before = std::max(before, network.pressure_off_liner(1, sealed.pressure[k]));
    now = std::max(now, network.pressure_off_liner(1, open.pressure[k]));
  }
  EXPECT_GT(before, 1e5);
  EXPECT_LT(now, 0.1 * before);
  EXPECT_GT(open.motion[1].off_liner_share, 0.01);
  EXPECT_LE(open.motion[1].farthest_off_liner, 5e-5);
  EXPECT_LT(open.mass_defect, 1e-12);
  EXPECT_NE(std::ranges::find_if(open.paths, [](const Path& p) { return path_name(p) == "face of ring 2"; }),
            open.paths.end());
  EXPECT_EQ(open.motion[0].off_liner_share, 0);
}

// Its ends meet at 2 pi a = g; the stiffness is that of the free gap, eq-elastic-pressure-gap.
TEST(GasPath, ACollapsingRingIsAsStiffAsItsFreeGap) {
  const double t = 3.5e-3, E = 1.2e11, bore = 0.089, a = 1e-5, r = bore / 2;
  const double closed = E * t * t * t * (2 * std::numbers::pi * a) / (36 * std::numbers::pi * r * r * r * r);
  EXPECT_NEAR(models::radial_stiffness(t, E, bore) * a, closed, 1e-12 * closed);
  const models::RadialCollapse ring{0.5, models::radial_stiffness(t, E, bore), 5e-5};
  EXPECT_NEAR(ring.distance(closed), a, 1e-12);
  EXPECT_EQ(ring.distance(-1e5), 0);
  EXPECT_EQ(ring.distance(1e6), 5e-5);
}

// The same force decides on the flank and makes the criterion: where it turns negative the ring leaves.
TEST(GasPath, ARingLeavesWhereItsSeatingForceEnds) {
  Pack pack = two_ring_pack();
  const auto seated = solve_gas_path(pack);
  EXPECT_LT(seated.motion[0].least_seating_force, 0);
  EXPECT_GT(seated.motion[0].unseated_share, 0);
  EXPECT_FALSE(seated.motion[2].has_groove);
  pack.ring_motion = RingMotion::kAxial;
  const auto axial = solve_gas_path(pack);
  EXPECT_GT(axial.motion[0].departures, 0U);
  EXPECT_LT(axial.motion[0].least_seating_force, 0);
}

TEST(GasPath, MassOfACycleBalances) {
  for (const RingMotion motion : {RingMotion::kSeated, RingMotion::kAxial}) {
    Pack pack = two_ring_pack();
    pack.ring_motion = motion;
    const auto result = solve_gas_path(pack);
    EXPECT_TRUE(result.repeats);
    EXPECT_LT(result.mass_defect, 1e-12);
    // What enters through the gap of ring 1 and around it leaves below the oil ring.
    double in = 0;
    for (std::size_t k = 0; k < result.paths.size(); ++k) {
      if (result.paths[k].from == 0) in += result.transported[k];
    }
    EXPECT_NEAR(in, result.blow_by, 1e-6 * result.blow_by);
  }
}

TEST(GasPath, BlowByGrowsWithTheGapOfTheTopRing) {
  double before = 0;
  for (const double area : {0.0, 4e-8, 8e-8, 16e-8}) {
    Pack pack = two_ring_pack();
    pack.rings.front().gap_area = area;
    const double blow_by = solve_gas_path(pack).blow_by;
    EXPECT_GE(blow_by, before);
    before = blow_by;
  }
}

TEST(GasPath, NoGasPassesWhereNoGapIsOpen) {
  Pack pack = two_ring_pack();
  for (Ring& ring : pack.rings) ring.gap_area = 0;
  const auto result = solve_gas_path(pack);
  EXPECT_EQ(result.blow_by, 0);
  EXPECT_NEAR(result.regions[2].peak_pressure, 101325, 1e-3);
  EXPECT_LT(result.mass_defect, 1e-12);
}

TEST(GasPath, TheTopRingChangesItsFlankTwiceACycleAtLowSpeed) {
  Pack pack = two_ring_pack();
  pack.ring_motion = RingMotion::kAxial;
  const auto result = solve_gas_path(pack);
  std::vector<std::string> events;
  for (const RingEvent& event : result.events) {
    if (event.ring == 1) events.push_back(event_name(event.event));
  }
  ASSERT_GE(events.size(), 4u);
  EXPECT_EQ(result.motion[0].departures, 1u);
  for (std::size_t k = 0; k < 720; ++k) {
    for (const double z : result.position[k]) {
      EXPECT_GE(z, -1e-12);
      EXPECT_LE(z, 5e-5 * (1 + 1e-6));
    }
  }
  EXPECT_GT(largest_flow(result, 2), 0);  // below ring 1, while it is off its lower flank
}

TEST(GasPath, RandomPacksStayPositiveAndKeepTheirMass) {
  std::mt19937 random(20);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
  };
  for (int n = 0; n < 60; ++n) {
    Pack pack = two_ring_pack();
    pack.ring_motion = n % 2 == 0 ? RingMotion::kSeated : RingMotion::kAxial;
    pack.speed = between(300, 9000) * std::numbers::pi / 30;
    for (Ring& ring : pack.rings) {
      ring.gap_area = n % 7 == 0 ? 0 : between(0, 1e-6);
      ring.volume_below = n % 5 == 0 ? 0 : between(0, 1e-5);
      ring.groove_volume = n % 3 == 0 ? 0 : between(0, 1e-5);
      ring.mass = between(1e-3, 5e-2);
    }
    const auto result = solve_gas_path(pack);
    EXPECT_LT(result.mass_defect, 1e-12) << n;
    for (const auto& pressures : result.pressure) EXPECT_GT(*std::ranges::min_element(pressures), 0) << n;
  }
}

}  // namespace
}  // namespace ringfilm::gas_path
