#include "ringfilm/cycle/cycle_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

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

// Half of the steps on both sides belongs to a sample: 90 + 50, 50 + 40 and 40 + 180 of 720 degree.
TEST(CycleValues, GasThroughABrokenFilmCountsForwardAndBack) {
  const ringfilm::cycle::Setup setup = prepare(testing::styles_new_ring());
  std::vector<Sample> samples(4);
  const double angle[] = {0, 100, 180, 540}, flow[] = {1e-6, 2e-6, -4e-6, 0};
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].crank_angle_deg = angle[k];
    samples[k].applied_load = 1;
    samples[k].gas_flow_through_film = flow[k];
  }
  const CycleValues values = cycle_values(setup, samples);
  const double duration = 0.08;  // 1500 rpm
  EXPECT_NEAR(values.gas_through_film_forward, (1e-6 * 140 + 2e-6 * 90) / 720 * duration, 1e-18);
  EXPECT_NEAR(values.gas_through_film_back, 4e-6 * 220 / 720 * duration, 1e-18);
}

// Steps of unequal lengths between which the film changes by factors of up to 1000, with dead centres anywhere.
TEST(CycleValues, ExtremesOfFilmAndLambdaRatioAreAboveZero) {
  const ringfilm::cycle::Setup setup = prepare(testing::styles_new_ring());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int cycle = 0; cycle < 2000; ++cycle) {
    std::vector<Sample> samples;
    double ln_film = std::log(1e-6), angle = 0;
    while (angle < 720) {
      Sample& s = samples.emplace_back();
      s.crank_angle_deg = angle;
      s.applied_load = 1;
      s.min_film_thickness = std::exp(ln_film);
      s.lambda_ratio = s.min_film_thickness / 0.5e-6;
      const double next_dead_centre = 180 * (std::floor(angle / 180) + 1);
      angle = std::min(angle + std::pow(2, std::floor(-6 + 10 * uniform(random))), next_dead_centre);
      const double jump = uniform(random) < 0.2 ? std::log(1000) : 0.1;
      ln_film = std::clamp(ln_film + jump * (2 * uniform(random) - 1), std::log(1e-8), std::log(1e-3));
    }
    const auto [least, most] = std::minmax_element(
        samples.begin(), samples.end(),
        [](const Sample& a, const Sample& b) { return a.min_film_thickness < b.min_film_thickness; });
    const CycleValues values = cycle_values(setup, samples);
    EXPECT_GT(values.min_film_thickness, 0);
    EXPECT_LE(values.min_film_thickness, least->min_film_thickness);
    EXPECT_GE(values.max_film_thickness, most->min_film_thickness);
    EXPECT_NEAR(values.min_lambda_ratio * 0.5e-6 / values.min_film_thickness, 1, 1e-9);
    EXPECT_GT(values.lambda_ratio_at_peak_pressure, 0);
  }
}

}  // namespace
}  // namespace ringfilm::cycle
