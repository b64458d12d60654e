#include "ringfilm/models/contact/measured_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/base/error.hpp"

namespace ringfilm::models {
namespace {

/// Rows of a gap of two heights, h - d and h + d, half of the area each.
FlowTable two_heights(double d) {
  FlowTable table;
  table.sigma = d;
  for (int k = 0; k <= 80; ++k) table.gap.push_back(1e-8 * std::pow(10, k / 20.0));
  for (const double h : {1e-6, 1.5e-6, 2e-6, 3e-6, 4e-6}) {
    table.h.push_back(h);
    const double ratio = d / h;
    table.pressure_flow_x.push_back(1 - ratio * ratio);
    table.pressure_flow_y.push_back(1 + 3 * ratio * ratio);
    table.shear_flow.push_back(ratio);
    table.pressure_stress.push_back(1 - 0.5 * ratio * ratio);
    table.mean_gap.push_back(h + 0.1 * ratio * ratio * h);
    auto& share = table.gap_share.emplace_back(table.gap.size(), 0.0);
    for (const double H : {h - d, h + d}) {
      std::size_t k = 0;
      while (table.gap[k + 1] < H) ++k;
      const double upper = (H - table.gap[k]) / (table.gap[k + 1] - table.gap[k]);
      share[k] += 0.5 * (1 - upper);
      share[k + 1] += 0.5 * upper;
    }
  }
  return table;
}

TEST(MeasuredFlow, IsItsRowsAndBetweenThemMonotone) {
  const FlowTable table = two_heights(0.5e-6);
  const MeasuredFlow flow(table);
  for (std::size_t k = 0; k < table.h.size(); ++k) {
    EXPECT_NEAR(flow.pressure_flow(table.h[k]), table.pressure_flow_x[k], 1e-14);
    EXPECT_NEAR(flow.pressure_flow_across(table.h[k]), table.pressure_flow_y[k], 1e-14);
    EXPECT_NEAR(flow.shear_flow(table.h[k]), table.shear_flow[k], 1e-14);
    EXPECT_NEAR(flow.mean_gap(table.h[k]), table.mean_gap[k], 1e-20);
  }
  double former = 0;
  for (double h = 1e-6; h < 8e-6; h += 0.01e-6) {
    const double phi = flow.pressure_flow(h);
    EXPECT_GT(phi, former) << h;
    former = phi;
  }
}

TEST(MeasuredFlow, BeyondItsRowsRoughnessIsOfSecondOrder) {
  const double d = 0.5e-6;
  const MeasuredFlow flow(two_heights(d));
  for (const double h : {5e-6, 10e-6, 50e-6}) {
    const double ratio = d / h;
    EXPECT_NEAR(flow.pressure_flow(h), 1 - ratio * ratio, 1e-12);
    EXPECT_NEAR(flow.pressure_flow_across(h), 1 + 3 * ratio * ratio, 1e-12);
    EXPECT_NEAR(flow.shear_flow(h), ratio, 1e-12);
    EXPECT_NEAR(flow.pressure_stress(h), 1 - 0.5 * ratio * ratio, 1e-12);
  }
  EXPECT_DOUBLE_EQ(flow.pressure_flow(0.2e-6), flow.pressure_flow(1e-6));  // before the first row
}

TEST(MeasuredFlow, ShiftedLetsTheSameThroughAtTheOtherSeparation) {
  const FlowTable table = two_heights(0.5e-6);
  const MeasuredFlow flow(table);
  for (const double shift : {0.3e-6, -0.4e-6}) {
    const MeasuredFlow moved = flow.shifted(shift);
    for (const double h : table.h) {
      const double there = h + shift, ratio = h / there;
      EXPECT_NEAR(moved.pressure_flow(there), flow.pressure_flow(h) * std::pow(ratio, 3), 1e-13);
      EXPECT_NEAR(moved.pressure_flow_across(there), flow.pressure_flow_across(h) * std::pow(ratio, 3), 1e-13);
      EXPECT_NEAR(moved.pressure_stress(there), flow.pressure_stress(h) * ratio, 1e-13);
      EXPECT_NEAR(moved.mean_gap(there), flow.mean_gap(h), 1e-19);
      EXPECT_NEAR(moved.shear_flow(there), flow.shear_flow(h), 1e-13);
      // The stress of the sliding walls is the mean of asinh(S/H), whatever the separation is called.
      EXPECT_NEAR(moved.sliding_stress(there, 1e-6) / there, flow.sliding_stress(h, 1e-6) / h, 1e-4 / h);
    }
  }
  EXPECT_EQ(flow.shifted(-1.2e-6).first(), 1.5e-6 - 1.2e-6);  // the row at 1 um is gone
  EXPECT_THROW(flow.shifted(-3.5e-6), InputError);
}

TEST(MeasuredFlow, TheStressIsThatOfTheGapsUpToTheLimitOfTheOil) {
  const double d = 0.5e-6, h = 1e-6;
  const MeasuredFlow flow(two_heights(d));
  for (const double S : {1e-10, 1e-8, 1e-7, 1e-6, 1e-5}) {
    const double mean = 0.5 * (std::asinh(S / (h - d)) + std::asinh(S / (h + d)));
    EXPECT_NEAR(flow.sliding_stress(h, S) / (mean * h / S), 1, 4e-3) << S;  // places of the gap, and of S
    EXPECT_DOUBLE_EQ(flow.sliding_stress(h, -S), flow.sliding_stress(h, S));
  }
  EXPECT_NEAR(flow.sliding_stress(h, 1e-10), 0.5 * (h / (h - d) + h / (h + d)), 4e-3);  // a Newtonian oil
  EXPECT_EQ(flow.sliding_stress(h, 0), 1);
  EXPECT_NEAR(flow.sliding_stress(100e-6, 1e-9), 1, 1e-3);
}

TEST(MeasuredFlow, WhatIsNotATableIsRefused) {
  const auto refused = [](const std::function<void(FlowTable&)>& change) {
    FlowTable table = two_heights(0.5e-6);
    change(table);
    EXPECT_THROW(MeasuredFlow{table}, InputError);
  };
  refused([](FlowTable& table) { table.h[1] = table.h[0]; });
  refused([](FlowTable& table) { table.h.front() = 0; });
  refused([](FlowTable& table) { table.shear_flow.pop_back(); });
  refused([](FlowTable& table) { table.pressure_flow_x[2] = -0.1; });
  refused([](FlowTable& table) { table.mean_gap[2] = std::nan(""); });
  refused([](FlowTable& table) { table.gap_share.pop_back(); });
  refused([](FlowTable& table) { table.gap_share[1][5] += 0.5; });
}

TEST(MeasuredFlow, AMapThatItsSpotsShutLetsALittleOilPass) {
  FlowTable table = two_heights(0.5e-6);
  table.pressure_flow_x.front() = 0;
  EXPECT_GT(MeasuredFlow(table).pressure_flow(1e-6), 0);
}

}  // namespace
}  // namespace ringfilm::models
