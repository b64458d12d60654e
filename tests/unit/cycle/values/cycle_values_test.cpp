#include "ringfilm/cycle/cycle_values.hpp"

#include <gtest/gtest.h>

#include "../styles_case.hpp"

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

// Parabolas within a stroke, with a kink at the dead centres, on steps of unequal lengths.
TEST(CycleValues, ParabolasWithinStrokesAreExact) {
  const ringfilm::cycle::Setup setup = prepare(testing::styles_new_ring());
  std::vector<Sample> samples;
  for (int stroke = 0; stroke < 4; ++stroke) {
    for (const double within : {0.0, 20.0, 50.0, 60.0, 100.0, 150.0}) {
      Sample& s = samples.emplace_back();
      s.crank_angle_deg = 180 * stroke + within;
      s.power_loss = s.total_friction = 50 + (stroke == 2 ? 10 : 0) - (within - 70) * (within - 70) / 100;
      s.applied_load = 1;
    }
  }
  const CycleValues values = cycle_values(setup, samples);
  EXPECT_NEAR(values.peak_total_friction, 60, 1e-12);
  EXPECT_NEAR(values.peak_total_friction_angle, 430, 1e-9);
}

}  // namespace
}  // namespace ringfilm::cycle
