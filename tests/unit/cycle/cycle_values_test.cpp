#include "ringfilm/cycle/cycle_values.hpp"

#include <gtest/gtest.h>

#include "styles_case.hpp"

namespace ringfilm::cycle {
namespace {

TEST(CycleValues, MeansWeightedWithTheLoadAreThoseOfTheSums) {
  const ringfilm::cycle::Setup setup = prepare(testing::styles_new_ring());
  std::vector<Sample> samples(4);
  const double load[] = {100, 900, 400, 600}, friction[] = {20, 9, 40, 6}, stribeck[] = {9, 1, 4, 2},
               film[] = {8, 1, 3, 2};
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].crank_angle_deg = 180.0 * static_cast<double>(k);
    samples[k].applied_load = load[k];
    samples[k].total_friction = friction[k];
    samples[k].friction_coefficient = friction[k] / load[k];
    samples[k].stribeck_number = stribeck[k];
    samples[k].lambda_ratio = film[k];
  }
  const CycleValues values = cycle_values(setup, samples);
  EXPECT_DOUBLE_EQ(values.mean_friction_coefficient, 75.0 / 2000);
  EXPECT_DOUBLE_EQ(values.mean_stribeck_number, (900.0 + 900 + 1600 + 1200) / 2000);
  EXPECT_DOUBLE_EQ(values.mean_lambda_ratio, (800.0 + 900 + 1200 + 1200) / 2000);
}

TEST(CycleValues, PeaksAreVerticesAndStepsMayBeUnequal) {
  const ringfilm::cycle::Setup setup = prepare(testing::styles_new_ring());
  std::vector<Sample> samples;
  for (const double angle : {0.0, 100.0, 130.0, 150.0, 200.0, 500.0}) {
    Sample& s = samples.emplace_back();
    s.crank_angle_deg = angle;
    s.total_friction = 50 - (angle - 140) * (angle - 140) / 100;
    s.applied_load = 1;
    s.lambda_ratio = angle == 0 ? 2 : 6;  // below 3 for a quarter of the way to either side
  }
  const CycleValues values = cycle_values(setup, samples);
  EXPECT_NEAR(values.peak_total_friction, 50, 1e-12);
  EXPECT_NEAR(values.peak_total_friction_angle, 140, 1e-9);
  EXPECT_NEAR(values.mixed_share, 0.25 * (100 + 220) / 720, 1e-12);
  EXPECT_NEAR(values.mean_lambda_ratio, 6 - 4 * 0.5 * (100 + 220) / 720, 1e-12);
}

}  // namespace
}  // namespace ringfilm::cycle
