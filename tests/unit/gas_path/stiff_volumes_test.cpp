#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pack_cases.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/gas_path/cycle_integration.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"

/// Volumes that follow their neighbours in nanoseconds: they take their quasi-steady limit, or the reason is named.
namespace ringfilm::gas_path {
namespace {

/// Largest relative difference of the pressures of two regions over the cycle.
double largest_difference(const GasPathResult& result, std::size_t a, std::size_t b) {
  double largest = 0;
  for (const auto& p : result.pressure) largest = std::max(largest, std::abs(p[a] / p[b] - 1));
  return largest;
}

/// A cold piston land, and below it a small hot one that the end gap of the second ring joins to it.
Pack small_hot_land(double volume) {
  Pack pack = two_ring_pack();
  pack.rings[0].volume_below = 209215e-9;
  pack.rings[0].temperature_below = 181;
  pack.rings[1].gap_area = 1.68e-3 * 0.73e-3;
  pack.rings[1].volume_below = volume;
  pack.rings[1].temperature_below = 956;
  pack.rings[2].gap_area = 0.0088e-3 * 0.2e-3;
  return pack;
}

// The flow into the small volume turns with each ripple of pressure, and its temperature changes fivefold with it.
TEST(StiffVolumes, ASmallHotLandHasThePressureOfTheLandItIsOpenTo) {
  const GasPathResult result = solve_gas_path(small_hot_land(4e-12));
  EXPECT_TRUE(result.repeats);
  EXPECT_LT(result.mass_defect, 1e-12);
  EXPECT_EQ(result.regions.at(2).name, "land 2");
  EXPECT_EQ(result.regions.at(4).name, "land 3");
  // What leaves through 0.00176 mm2 (psi = 0.673 if choked) enters through 1.23 mm2 with psi = 0.673 (0.00176/1.23)
  // sqrt(181/956) = 4.2e-4, on the straight line of 0.0447 over a pressure ratio of 1e-3: a difference of 9.4e-6.
  EXPECT_LT(largest_difference(result, 2, 4), 1e-5);
  const GasPathResult larger = solve_gas_path(small_hot_land(100e-12));
  EXPECT_NEAR(result.blow_by, larger.blow_by, 1e-5 * larger.blow_by);
}

// The groove follows the chamber at once and the ring has the crankcase below it: what passes is the flow through its
// end gap alone, as of an oil ring in its place.
TEST(StiffVolumes, AGrooveWithoutVolumeHasThePressureAboveTheRing) {
  Pack pack = two_ring_pack();
  pack.gas.viscosity = 2.67e-6;
  Ring& top = pack.rings[0];
  top.volume_below = 0;
  top.groove_volume = 0;
  top.side_clearance = 647e-6;
  top.radial_thickness = 0.995e-3;
  pack.rings.resize(1);
  const GasPathResult result = solve_gas_path(pack);
  EXPECT_LT(largest_difference(result, 0, 1), 1e-6);
  EXPECT_LT(result.mass_defect, 1e-12);
  Pack gap = pack;
  gap.rings[0].kind = RingKind::kOil;
  const GasPathResult alone = solve_gas_path(gap);
  EXPECT_NEAR(result.blow_by, alone.blow_by, 1e-6 * alone.blow_by);
}

// Wide clearances over several small volumes at once, seated and moving.
TEST(StiffVolumes, AllVolumesAtTheirLeastAreSolved) {
  for (const RingMotion motion : {RingMotion::kSeated, RingMotion::kAxial}) {
    Pack pack = two_ring_pack();
    pack.ring_motion = motion;
    pack.gas.viscosity = 1e-6;
    pack.gas.choking_smoothing = 1e-6;
    for (Ring& ring : pack.rings) {
      ring.groove_volume = 0;
      ring.volume_below = 1e-13;
      ring.side_clearance = 2e-3;
      ring.gap_area = 1e-5;
    }
    pack.rings.back().volume_below = 0;
    const GasPathResult result = solve_gas_path(pack);
    EXPECT_GT(result.blow_by, 0);
    EXPECT_LT(result.mass_defect, 1e-12);
  }
}

TEST(StiffVolumes, ACycleOfTooManyStepsNamesTheFastestVolumeAndTheRings) {
  Pack pack = two_ring_pack();
  pack.rings[1].volume_below = 1e-11;
  const Network network(pack);
  const PackState begin{std::vector<double>(network.inner().size(), 1.0), std::vector<double>(3, 0.0),
                        std::vector<double>(3, 0.0), std::vector<Contact>(3, Contact::kLowerFlank)};
  try {
    CycleIntegration(network, begin).integrate(100);
    FAIL() << "a cycle of 100 steps";
  } catch (const ConvergenceError& error) {
    EXPECT_NE(std::string(error.what()).find("more than 100 steps"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("land 3 follows its neighbours within"), std::string::npos)
        << error.what();
    EXPECT_TRUE(error.crank_angle_deg());
  }
  pack.ring_motion = RingMotion::kAxial;
  const Network moving(pack);
  try {
    CycleIntegration(moving, begin).integrate(100);
    FAIL() << "a cycle of 100 steps";
  } catch (const ConvergenceError& error) {
    EXPECT_NE(std::string(error.what()).find("the rings have changed flanks"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace ringfilm::gas_path
