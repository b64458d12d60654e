#include "ringfilm/models/oil/shear_thinning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ringfilm::models {
namespace {

constexpr ShearThinning kCross{ShearThinningLaw::kCross, 0.7, 1};
constexpr ShearThinning kCarreau{ShearThinningLaw::kCarreau, 0.7, 0.5};

TEST(ShearThinning, GoesFromOneToTheSecondNewtonianRatio) {
  for (const ShearThinning& law : {kCross, kCarreau}) {
    EXPECT_EQ(law.ratio(0), 1);
    EXPECT_NEAR(law.ratio(1e12), 0.7, 1e-6);
    EXPECT_LT(law.ratio(2), law.ratio(1));
  }
  EXPECT_DOUBLE_EQ(kCross.ratio(1), 0.85);  // half way at the critical rate
  EXPECT_DOUBLE_EQ(kCarreau.ratio(1), 0.7 + 0.3 * std::pow(2, -0.25));
}

TEST(ShearThinning, RateIsTheInverseOfTheRatio) {
  for (const ShearThinning& law : {kCross, kCarreau}) {
    for (const double rate : {0.1, 1.0, 30.0}) EXPECT_NEAR(law.rate(law.ratio(rate)), rate, 1e-9 * rate);
  }
}

TEST(ShearThinning, UnderAStressTheRateIsThatOfTheThinnedOil) {
  // Cross with m = 1 under a stress alone: eta = R + (1 - R)/(1 + s/eta) is a quadratic equation.
  const double s = 2, R = kCross.second_newtonian, half = 0.5 * (1 - s);
  const double eta = half + std::sqrt(half * half + R * s);
  EXPECT_NEAR(kCross.ratio(0, s), eta, 1e-12);
  EXPECT_EQ(kCross.ratio(3, 0), kCross.ratio(3));
  const double both = kCarreau.ratio(1.5, 2);
  EXPECT_NEAR(both, kCarreau.ratio(std::hypot(1.5, 2 / both)), 1e-12);
}

}  // namespace
}  // namespace ringfilm::models
