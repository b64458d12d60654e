#include "ringfilm/gas_path/composition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pack_cases.hpp"
#include "ringfilm/gas_path/scalar_transport.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"

namespace ringfilm::gas_path {
namespace {

const std::vector<Path> kSeries = {
    {PathKind::kEndGap, 0, 0, 1}, {PathKind::kEndGap, 1, 1, 2}, {PathKind::kEndGap, 2, 2, 3}};

/// Two volumes that a constant flow passes, filled with a scalar from the chamber: shares after `passed` in n steps.
ScalarTable filled_in_series(double m1, double m2, double passed, int n) {
  const double each = passed / n;
  const FlowStep step{0, 0, {m1, m2}, {m1, m2}, {each, each, each}, {0, 0, 0}};
  const Eigen::RowVectorXd one = Eigen::RowVectorXd::Ones(1);
  ScalarTable share = ScalarTable::Zero(2, 1);
  for (int i = 0; i < n; ++i) transport_step(kSeries, step, {one, one, 0 * one}, share);
  return share;
}

// Y_1 = 1 - exp(-a t), Y_2 = 1 - (b exp(-a t) - a exp(-b t))/(b - a), a and b flow over mass, eq-series-closed-form.
TEST(ScalarTransport, TwoVolumesInSeriesFollowTheirExponentials) {
  const double m1 = 1, m2 = 2, passed = 1.5, a = 1 / m1, b = 1 / m2;
  const double first = 1 - std::exp(-a * passed);
  const double second = 1 - (b * std::exp(-a * passed) - a * std::exp(-b * passed)) / (b - a);
  const ScalarTable coarse = filled_in_series(m1, m2, passed, 20), fine = filled_in_series(m1, m2, passed, 40);
  EXPECT_NEAR(coarse(0, 0), first, 1e-13);
  EXPECT_NEAR(fine(1, 0), second, 2e-5);                                 // 1.5e-5 by hand
  EXPECT_NEAR((coarse(1, 0) - second) / (fine(1, 0) - second), 4, 0.1);  // second order
}

// One step in which a volume is exchanged a thousand times over.
TEST(ScalarTransport, SharesRemainBetweenZeroAndOneInLongSteps) {
  const FlowStep step{0, 0, {1e-3, 2}, {2e-3, 1.5}, {1, 1, 1.6}, {0.4, 0.401, 0.5}};
  const Eigen::RowVectorXd chamber = Eigen::RowVector2d(1, 0), crankcase = Eigen::RowVector2d(0.25, 0.75);
  ScalarTable share(2, 2);
  share << 0, 1, 1, 0;
  // Masses that the paths move and masses that change must agree.
  FlowStep balanced = step;
  balanced.mass_after[0] = step.mass_before[0] + 1 - 0.4 - 1 + 0.401;
  balanced.mass_after[1] = step.mass_before[1] + 1 - 0.401 - 1.6 + 0.5;
  transport_step(kSeries, balanced, {chamber, chamber, crankcase}, share);
  EXPECT_GE(share.minCoeff(), 0);
  EXPECT_LE(share.maxCoeff(), 1 + 1e-13);
  for (Eigen::Index i = 0; i < 2; ++i) EXPECT_NEAR(share.row(i).sum(), 1, 1e-13);
}

// What enters a crankcase and what ventilates it, in the ratio of their masses.
TEST(ScalarTransport, AirDilutesTheCrankcase) {
  const FlowStep step{540, 1260, {1e-6, 1e-6}, {1e-6, 1e-6}, {3e-6, 3e-6, 3e-6}, {0, 0, 0}};
  const Eigen::RowVectorXd gas = Eigen::RowVector2d(1, 0), air = Eigen::RowVector2d(0, 1);
  const ScalarCycle cycle = periodic_scalars(
      kSeries, {step}, [&](double) { return gas; }, 9e-6, air);
  EXPECT_NEAR(cycle.crankcase[0], 0.25, 1e-9);
  EXPECT_NEAR(cycle.crankcase.sum(), 1, 1e-12);
  EXPECT_LT(cycle.defect, 1e-12);
}

Pack pack_with_composition() {
  Pack pack = two_ring_pack();
  Composition composition;
  const models::ChargeMixture charge{models::Fuel::kHydrogen, 2, 1, 0.01};
  composition.fresh = fresh_charge(charge);
  composition.burnt = burnt_gas(charge);
  composition.air = models::humid_air(charge.humidity);
  composition.fuel = charge.fuel;
  composition.liner_wall = 380;
  const models::Burning burning{models::BurnLaw::kWiebe, -10, 60, 0.05};
  for (int angle = 0; angle < 720; ++angle) {
    composition.burnt_share.push_back(burnt_share(burning, pack.crank, angle));
    composition.chamber_wall.push_back(390);
  }
  pack.composition = composition;
  return pack;
}

TEST(GasComposition, LeavesTheGasAsItIs) {
  for (const RingMotion motion : {RingMotion::kSeated, RingMotion::kAxial}) {
    Pack pack = pack_with_composition();
    pack.ring_motion = motion;
    const GasPathResult with = solve_gas_path(pack);
    pack.composition.reset();
    const GasPathResult without = solve_gas_path(pack);
    EXPECT_EQ(with.pressure, without.pressure);
    EXPECT_EQ(with.blow_by, without.blow_by);
    EXPECT_FALSE(without.composition.has_value());
    EXPECT_FALSE(without.regions[1].peak_dew_point.has_value());
  }
}

TEST(GasComposition, SharesAddUpAndTheirBalanceClosesToRounding) {
  for (const RingMotion motion : {RingMotion::kSeated, RingMotion::kAxial}) {
    Pack pack = pack_with_composition();
    pack.ring_motion = motion;
    const GasPathResult result = solve_gas_path(pack);
    ASSERT_TRUE(result.composition.has_value());
    const CompositionResult& composition = *result.composition;
    EXPECT_LT(composition.defect, 1e-12);
    const std::size_t n = composition.scalars.size(), n_regions = result.regions.size();
    ASSERT_EQ(composition.share.size(), 720 * n_regions * n);
    for (std::size_t row = 0; row < 720 * n_regions; ++row) {
      const double* share = composition.share.data() + row * n;
      EXPECT_NEAR(share[kFreshScalar] + share[kBurntScalar] + share[kAirScalar], 1, 1e-11);
      EXPECT_GE(*std::min_element(share, share + n), -1e-13);
    }
    double into_crankcase = 0;
    for (const std::size_t gas : {kFreshScalar, kBurntScalar, kAirScalar}) {
      into_crankcase += composition.scalars[gas].crankcase_per_cycle;
    }
    EXPECT_NEAR(into_crankcase, result.blow_by, 1e-10 * result.blow_by);
  }
}

// The chamber has burnt gas at the peak, and fresh charge in the compression; what reaches the crankcase is in between.
TEST(GasComposition, HydrogenAndWaterReachTheCrankcase) {
  Pack pack = pack_with_composition();
  const GasPathResult result = solve_gas_path(pack);
  const CompositionResult& composition = *result.composition;
  const ScalarValues &hydrogen = composition.scalars[kFuelScalar], &water = composition.scalars[kWaterScalar];
  EXPECT_EQ(hydrogen.name, "hydrogen");
  EXPECT_GT(hydrogen.crankcase_flow, 0);
  EXPECT_LT(hydrogen.crankcase_mass_share, share(pack.composition->fresh, models::Species::kHydrogen));
  EXPECT_LT(water.crankcase_mass_share, share(pack.composition->burnt, models::Species::kWater));
  EXPECT_GT(hydrogen.crankcase_mole_share, 10 * hydrogen.crankcase_mass_share);  // 29/2 by molar masses
  EXPECT_GT(*result.regions.front().condensing_share, 0);                        // 20 % of vapour at the peak pressure
  EXPECT_FALSE(result.regions.front().condensable_water.has_value());
  // About 10 kPa of vapour: less than saturation in the warm crankcase, 360 K, and more in a cold one.
  EXPECT_EQ(composition.condensate_flow, 0);
  pack.crankcase_temperature = 290;
  EXPECT_GT(solve_gas_path(pack).composition->condensate_flow, 0);
}

}  // namespace
}  // namespace ringfilm::gas_path
