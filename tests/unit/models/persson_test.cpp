#include "ringfilm/models/contact/persson.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ringfilm::models {
namespace {

TEST(PerssonArea, HasItsPublishedValues) {
  EXPECT_NEAR(persson_area(0.1, 1), 0.15851942, 1e-8);
  const PerssonArea area = persson_area(0.05, 1, 1);
  EXPECT_NEAR(area.elastic, 0.05800627, 1e-8);
  EXPECT_NEAR(area.plastic, 0.02170428, 1e-8);
}

TEST(PerssonArea, IsProportionalToSmallPressures) {
  EXPECT_NEAR(persson_area(1e-4, 1) / 1e-4, std::sqrt(8 / std::numbers::pi), 1e-6);
}

TEST(PerssonArea, HasItsLimitsInTheHardness) {
  for (const double p : {0.02, 0.1, 0.3}) {
    const PerssonArea hard = persson_area(p, 1, 50 * p + 20);
    EXPECT_NEAR(hard.total(), persson_area(p, 1), 1e-6);
    EXPECT_NEAR(hard.plastic, 0, 1e-6);
    const PerssonArea soft = persson_area(0.01 * p, 1, 0.01);  // E* h' a hundred times the hardness: p = H A
    EXPECT_NEAR(soft.total(), p, 1e-6);
    EXPECT_NEAR(soft.elastic, 0, 1e-6);
  }
  EXPECT_EQ(persson_area(0, 1, 1).total(), 0);
}

}  // namespace
}  // namespace ringfilm::models
