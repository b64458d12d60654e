#include "ringfilm/models/ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../../traps/floating_point_traps.hpp"
#include "ringfilm/base/error.hpp"

namespace {

using ringfilm::InputError;
using ringfilm::models::RingFace;

constexpr double kWidth = 1.2e-3;

/// styles2014, Table 4: x in mm, height in um.
RingFace paper_face(std::vector<double> coefficients) {
  return RingFace::polynomial(std::move(coefficients), 1e-3, 1e-6, kWidth);
}
RingFace new_ring() { return paper_face({427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.30}); }
RingFace run_in_ring() { return paper_face({-197.16, 578.85, -583.44, 200.37, 56.366, -62.709, 13.857}); }
RingFace embedded_ring() { return paper_face({-6.493, -49.845, 143.22, -98.541, 27.351, -17.338, 7.4986}); }

TEST(RingFace, PolynomialTakesItsUnits) {
  EXPECT_NEAR(new_ring().height(0), 25.30e-6, 1e-20);
  // At x = 1 mm the height is the sum of the coefficients, cancelling two digits of 2000.
  EXPECT_NEAR(new_ring().height(1e-3), (427.9 - 1455.8 + 1971.4 - 1354.4 + 544.57 - 150.49 + 25.30) * 1e-6, 1e-17);
}

TEST(RingFace, NewRingHasTheMinimumOfThePaperFit) {
  EXPECT_NEAR(new_ring().minimum().height, 0.7552e-6, 5e-11);  // PHYSICS 2.3, four decimals
}

TEST(RingFace, MinimumIsNeverAboveAnySample) {
  for (const auto& face : {new_ring(), run_in_ring(), embedded_ring(), RingFace::parabola(10e-6, 0.3, kWidth)}) {
    const auto lowest = face.minimum();
    EXPECT_EQ(face.height(lowest.x), lowest.height);
    for (int k = 0; k <= 100000; ++k) {
      // Terms of up to 2000 um cancel in these polynomials: 5e-19 m of rounding.
      EXPECT_LE(lowest.height, face.height(kWidth * k / 100000) + 1e-18);
    }
  }
}

TEST(RingFace, MinimumLiesBetweenSamplePointsWhereTheFaceDoes) {
  // (x - a)^2 with a at no simple fraction of the width; x to half of the 16 digits.
  const double a = 0.4142135;
  const auto face = RingFace::polynomial({1, -2 * a, a * a}, 1e-3, 1e-6, kWidth);
  EXPECT_NEAR(face.minimum().x, a * 1e-3, 1e-10);
  EXPECT_NEAR(face.minimum().height, 0, 1e-20);
}

TEST(RingFace, MinimumMayLieAtAnEdge) {
  const auto rising = RingFace::polynomial({3, 1}, 1e-3, 1e-6, kWidth);
  EXPECT_EQ(rising.minimum().x, 0);
  EXPECT_EQ(rising.turned().minimum().x, kWidth);
}

TEST(RingFace, ParabolaRisesByTheCrownAtTheFartherEdge) {
  const auto face = RingFace::parabola(8e-6, 0.25, kWidth);
  EXPECT_NEAR(face.height(kWidth), 8e-6, 1e-20);
  EXPECT_NEAR(face.height(0), 8e-6 / 9, 1e-20);
  EXPECT_NEAR(face.height(0.25 * kWidth), 0, 1e-20);
  EXPECT_EQ(face.minimum().x, 0.25 * kWidth);
  EXPECT_EQ(face.minimum().height, 0);
}

TEST(RingFace, CosineHasOnePeriodFromItsLowestPoint) {
  for (const double apex : {0.0, 0.3, 1.0}) {
    const auto face = RingFace::cosine(8e-6, apex, kWidth);
    EXPECT_EQ(face.minimum().height, 0);
    EXPECT_NEAR(face.height((apex + (apex < 0.5 ? 0.5 : -0.5)) * kWidth), 8e-6, 1e-20);
    EXPECT_NEAR(face.height(0), face.height(kWidth), 1e-20);
    EXPECT_NEAR(face.height((apex + (apex < 0.5 ? 0.25 : -0.25)) * kWidth), 4e-6, 1e-20);
  }
  EXPECT_EQ(RingFace::cosine(8e-6, 0.3, kWidth).minimum().x, 0.3 * kWidth);
}

TEST(RingFace, PointsAreJoinedByStraightLines) {
  const auto face = RingFace::points({-1e-4, 4e-4, 8e-4, 1.3e-3}, {3e-6, 1e-6, 0.2e-6, 4e-6}, kWidth);
  EXPECT_NEAR(face.height(6e-4), 0.6e-6, 1e-20);
  EXPECT_NEAR(face.height(0), 2.6e-6, 1e-20);
  EXPECT_EQ(face.minimum().x, 8e-4);
  EXPECT_NEAR(face.minimum().height, 0.2e-6, 1e-21);
}

TEST(RingFace, PointsOutsideTheWidthDoNotMakeItsMinimum) {
  const auto face = RingFace::points({-1e-3, 0, kWidth}, {-5e-6, 2e-6, 1e-6}, kWidth);
  EXPECT_EQ(face.minimum().x, kWidth);
  EXPECT_NEAR(face.minimum().height, 1e-6, 1e-21);
}

TEST(RingFace, TurnedTwiceIsTheSame) {
  const auto face = new_ring();
  for (double x = 0; x <= kWidth; x += 1e-5) {
    // b - (b - x) loses the last digit of b, the face's slope there is at most 0.15 um/um.
    EXPECT_NEAR(face.turned().turned().height(x), face.height(x), 1e-18);
    EXPECT_NEAR(face.turned().height(kWidth - x), face.height(x), 1e-18);
  }
  // Half the digits of x, relative to the width.
  EXPECT_NEAR(face.turned().minimum().x, kWidth - face.minimum().x, 1e-10);
}

TEST(RingFace, PointsThatDoNotCoverTheWidthAreRefusedWithTheirRange) {
  try {
    RingFace::points({0, 1e-3}, {1e-6, 2e-6}, kWidth);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("0 mm to 1 mm"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("1.2 mm"), std::string::npos) << error.what();
  }
}

TEST(RingFace, PointsOutOfOrderAndMeaninglessWidthsAreRefused) {
  const ringfilm::traps::NoTraps no_traps;  // a NaN on purpose
  EXPECT_THROW(RingFace::points({0, 1e-3, 1e-3, kWidth}, {0, 0, 0, 0}, kWidth), InputError);
  EXPECT_THROW(RingFace::points({0}, {0}, kWidth), InputError);
  EXPECT_THROW(RingFace::parabola(1e-6, 0.5, -kWidth), InputError);
  EXPECT_THROW(RingFace::parabola(1e-6, 0.5, NAN), InputError);
}

TEST(RingTension, AgreesWithTheDefaultRing) {
  // PHYSICS section 1: 0.20 MPa belong to about 10.7 N; gap 10.5 mm, thickness 3.5 mm, 203 GPa give 0.206 MPa.
  EXPECT_NEAR(ringfilm::models::tangential_force_from_elastic_pressure(0.2e6, kWidth, 0.089), 10.7, 0.05);
  EXPECT_NEAR(ringfilm::models::elastic_pressure_from_free_gap(10.5e-3, 3.5e-3, 203e9, 0.089), 0.206e6, 500);
  EXPECT_NEAR(ringfilm::models::elastic_pressure_from_tangential_force(10.68, kWidth, 0.089), 0.2e6, 1);
}

}  // namespace
