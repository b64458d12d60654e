#include "ringfilm/models/gas/gas_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ringfilm::models {
namespace {

TEST(GasFlow, CriticalRatioAndChokedFlowAreThoseOfTheTextbooks) {
  EXPECT_NEAR(critical_pressure_ratio(1.3), 0.545728, 5e-7);
  EXPECT_NEAR(critical_pressure_ratio(1.33), 0.540364, 5e-7);
  EXPECT_NEAR(critical_pressure_ratio(1.4), 0.528282, 5e-7);
  EXPECT_NEAR(OrificeLaw(1.3, 1e-3).flow_function(0.1), 0.6672624, 5e-8);
  EXPECT_NEAR(OrificeLaw(1.33, 1e-3).flow_function(0.1), 0.6726284, 5e-8);
  EXPECT_NEAR(OrificeLaw(1.4, 1e-3).flow_function(0.1), 0.6847315, 5e-8);
}

TEST(GasFlow, FlowFunctionIsContinuousAndFallsToZeroOnAStraightLine) {
  const OrificeLaw law(1.33, 0.01);
  const double r_c = law.critical_ratio();
  EXPECT_NEAR(law.flow_function(r_c - 1e-9), law.flow_function(r_c + 1e-9), 1e-12);
  EXPECT_NEAR(law.flow_function(0.99 - 1e-9), law.flow_function(0.99 + 1e-9), 1e-7);
  EXPECT_NEAR(law.flow_function(0.995), law.flow_function(0.99) / 2, 1e-12);
  EXPECT_EQ(law.flow_function(1), 0);
}

TEST(GasFlow, OrificeTakesTheTemperatureOfTheUpstreamSide) {
  const OrificeLaw law(1.4, 1e-3);
  const GasState hot{2e5, 800}, cold{2e5, 200}, low{1e4, 400};
  EXPECT_NEAR(orifice_flow(law, 1e-7, 287, cold, low) / orifice_flow(law, 1e-7, 287, hot, low), 2, 1e-12);
  EXPECT_EQ(orifice_flow(law, 1e-7, 287, hot, low), -orifice_flow(law, 1e-7, 287, low, hot));
}

TEST(GasFlow, ChannelIsLaminarWhereNarrowAndAnOrificeWhereWide) {
  const OrificeLaw law(1.33, 1e-3);
  const GasChannel channel{0.27, 3.3e-3, 2.5e-5, 287, 500};
  const double narrow = 1e-6, wide = 1e-2, p_a = 5e5, p_b = 1e5;
  EXPECT_NEAR(channel.limited_flow(law, narrow, p_a, p_b) / channel.flow(narrow, p_a, p_b), 1, 1e-4);
  const double choked = orifice_flow(law, 0.27 * wide, 287, {p_a, 500}, {p_b, 500});
  EXPECT_NEAR(channel.limited_flow(law, wide, p_a, p_b) / choked, 1, 1e-4);
  EXPECT_EQ(channel.limited_flow(law, 0, p_a, p_b), 0);
  EXPECT_EQ(channel.limited_flow(law, wide, p_a, p_a), 0);
  EXPECT_EQ(channel.limited_flow(law, 5e-5, p_a, p_b), -channel.limited_flow(law, 5e-5, p_b, p_a));
}

TEST(GasFlow, MeanPressureOfTheChannelIsThatOfItsSquareRootProfile) {
  const double a = 8e5, b = 2e5;
  double mean = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) mean += std::sqrt(a * a + (b * b - a * a) * (i + 0.5) / n) / n;
  EXPECT_NEAR(mean_channel_pressure(a, b), mean, 1e-9 * mean);
  EXPECT_NEAR(mean_channel_pressure(a, a), a, 1e-9);
}

}  // namespace
}  // namespace ringfilm::models
