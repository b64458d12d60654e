#include "ringfilm/study/design/kept_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../study_example.hpp"
#include "ringfilm/study/study_run.hpp"

namespace ringfilm::study {
namespace {

using testing::coarse_case;
using testing::factor;
using testing::reported;
using testing::study_of;

OutputSelection all_curves(double crank_step_deg) {
  OutputSelection keep;
  keep.curves = Curves::kAll;
  keep.crank_step_deg = crank_step_deg;
  return keep;
}

Study small_study(const OutputSelection& keep) {
  Study study = study_of({factor("operating.speed", Levels{{1.0, 1.5, -1.0}}, FactorMode::kScale)}, Method::kGrid);
  study.keep = keep;
  return study;
}

std::vector<ScenarioRow> rows_of(const Study& study) {
  std::vector<ScenarioRow> rows;
  const Plan plan(study);
  run_scenarios(plan, {0, plan.size()}, [&rows](const ScenarioBlock& block) {
    rows.insert(rows.end(), block.rows.begin(), block.rows.end());
    return Continuation::kYes;
  });
  return rows;
}

TEST(KeptCurves, AxisRunsFromGasExchangeToGasExchangeWithFiringInTheMiddle) {
  const std::vector<double> angles = kept_angles(all_curves(4));
  ASSERT_EQ(angles.size(), 180u);
  EXPECT_EQ(angles.front(), -360);
  EXPECT_EQ(angles[90], 0);
  EXPECT_EQ(angles.back(), 356);
  // Of an odd number of angles none is -360.
  EXPECT_EQ(kept_angles(all_curves(144)), (std::vector<double>{-288, -144, 0, 144, 288}));
  EXPECT_TRUE(kept_angles(OutputSelection{}).empty());
}

TEST(KeptCurves, NumbersAreThoseOfTheSampleAtTheAngle) {
  OutputSelection keep = all_curves(144);
  keep.quantities = {"power_loss", "min_film_thickness"};
  std::vector<cycle::Sample> samples;
  for (int k = 0; k < 5; ++k) {
    cycle::Sample sample;
    sample.crank_angle_deg = 144 * k;
    sample.power_loss = 144 * k;
    sample.min_film_thickness = -144 * k;
    samples.push_back(sample);
  }
  EXPECT_EQ(kept_numbers(keep, samples), (std::vector<float>{432, 576, 0, 144, 288, -432, -576, 0, -144, -288}));
  samples.pop_back();
  EXPECT_THROW(kept_numbers(keep, samples), std::logic_error);
}

TEST(KeptCurves, LeaveTheValuesOfTheCycleAsTheyAre) {
  Study plain = small_study({}), kept = small_study(all_curves(8));
  // What the base itself asks for plays no part.
  kept.bases.front().input.output.crank_angles_deg = {0.5, 1.5, 7};
  const auto without = rows_of(plain), with = rows_of(kept);
  ASSERT_EQ(without.size(), 3u);
  ASSERT_EQ(with.size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(without[i].values, with[i].values);
    EXPECT_TRUE(without[i].curves.empty());
    ASSERT_EQ(with[i].curves.size(), 4 * 90u);
    for (const float number : with[i].curves) EXPECT_TRUE(std::isfinite(number));
  }
  EXPECT_FALSE(with[2].reason.empty());
  ASSERT_EQ(with[2].curves.size(), 4 * 90u);
  for (const float number : with[2].curves) EXPECT_TRUE(std::isnan(number));
}

TEST(KeptCurves, MinimumOfTheCurveIsThatOfTheCycle) {
  OutputSelection keep = all_curves(4);  // every step of the integration
  keep.quantities = {"min_film_thickness"};
  const ScenarioRow row = rows_of(small_study(keep)).front();
  const auto& quantities = cycle::cycle_quantities();
  const auto value = std::find_if(quantities.begin(), quantities.end(),
                                  [](const auto& one) { return one.name == "min_film_thickness"; });
  const double smallest = *std::min_element(row.curves.begin(), row.curves.end());
  // The value is that of the vertex between the steps.
  EXPECT_NEAR(smallest / row.values.at(static_cast<std::size_t>(value - quantities.begin())), 1, 1e-3);
}

TEST(KeptCurves, WhatCannotBeKeptIsRefused) {
  EXPECT_EQ(reported(small_study(all_curves(4))), "");
  EXPECT_NE(reported(small_study(all_curves(7))).find("does not divide the cycle"), std::string::npos);
  EXPECT_NE(reported(small_study(all_curves(0))).find("does not divide the cycle"), std::string::npos);
  EXPECT_NE(reported(small_study(all_curves(2))).find("not a multiple of solver.crank_step = 4 degree"),
            std::string::npos);
  OutputSelection keep = all_curves(4);
  keep.quantities = {"min_film_thickness", "crank_angle", "min_film_thickness"};
  EXPECT_NE(reported(small_study(keep)).find("no curve crank_angle"), std::string::npos);
  EXPECT_NE(reported(small_study(keep)).find("min_film_thickness twice"), std::string::npos);
  keep.quantities.clear();
  EXPECT_NE(reported(small_study(keep)).find("names no curve"), std::string::npos);
  Study fine = small_study(all_curves(0.01));
  EXPECT_NE(reported(fine).find("numbers, more than"), std::string::npos);
  fine.keep.curves = Curves::kNone;
  EXPECT_EQ(reported(fine), "");
}

}  // namespace
}  // namespace ringfilm::study
