#include "ringfilm/models/oil/viscosity_index.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace ringfilm::models {
namespace {

constexpr double kMm2_s = 1e-6;

// The two examples that ASTM D2270 works out, rounded there to the whole index: 73.30 and 8.86 mm2/s have 92, and
// 22.83 and 5.05 mm2/s have 156.
TEST(ViscosityIndex, ExamplesOfTheStandard) {
  EXPECT_NEAR(viscosity_index(73.30 * kMm2_s, 8.86 * kMm2_s).value(), 92, 0.5);
  EXPECT_NEAR(viscosity_index(22.83 * kMm2_s, 5.05 * kMm2_s).value(), 156, 0.5);
}

// Rows of table 1 of ASTM D2270: Y, L and H in mm2/s. An oil with L at 40 degC has the index 0, one with H 100.
// The equations follow the table to 0.1 %, which is half a unit of the index at most.
TEST(ViscosityIndex, ReferenceOilsOfTheTable) {
  for (const auto& [Y, L, H] : {std::tuple(2.00, 7.994, 6.394),
                                {5.00, 40.23, 28.49},
                                {10.0, 147.7, 82.87},
                                {20.0, 493.2, 229.5},
                                {50.0, 2618.0, 919.6},
                                {70.0, 4905.0, 1558.0}}) {
    EXPECT_NEAR(viscosity_index(L * kMm2_s, Y * kMm2_s).value(), 0, 0.5) << Y;
    EXPECT_NEAR(viscosity_index(H * kMm2_s, Y * kMm2_s).value(), 100, 0.5) << Y;
    EXPECT_NEAR(viscosity_at_40(Y * kMm2_s, 100).value(), H * kMm2_s, 1.5e-3 * H * kMm2_s) << Y;
    EXPECT_NEAR(viscosity_at_100(L * kMm2_s, 0).value(), Y * kMm2_s, 1.5e-3 * Y * kMm2_s) << Y;
  }
}

TEST(ViscosityIndex, EachFollowsFromTheOtherTwo) {
  for (const double index : {20.0, 95.0, 100.0, 130.0, 170.0, 300.0}) {
    for (const double at_100 : {4.1, 6.0, 9.5, 14.5, 26.0, 60.0}) {  // within the ranges of the equations
      const double at_40 = viscosity_at_40(at_100 * kMm2_s, index).value();
      EXPECT_NEAR(viscosity_index(at_40, at_100 * kMm2_s).value(), index, 1e-6);
      EXPECT_NEAR(viscosity_at_100(at_40, index).value(), at_100 * kMm2_s, 1e-9 * at_100 * kMm2_s);
    }
  }
}

TEST(ViscosityIndex, IsNotDefinedBelowTwoSquareMillimetresPerSecond) {
  EXPECT_FALSE(viscosity_index(5 * kMm2_s, 1.9 * kMm2_s));
  EXPECT_FALSE(viscosity_index(5 * kMm2_s, 6 * kMm2_s));  // a viscosity that rises
  EXPECT_FALSE(viscosity_at_40(1.9 * kMm2_s, 100));
  EXPECT_FALSE(viscosity_at_100(5 * kMm2_s, 100));
  EXPECT_FALSE(viscosity_at_100(60 * kMm2_s, -10));
  EXPECT_FALSE(viscosity_at_100(60 * kMm2_s, 500));
}

}  // namespace
}  // namespace ringfilm::models
