#include "ringfilm/life/wear/wear_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../cycle/styles_case.hpp"

namespace ringfilm::life {
namespace {

constexpr double kArcMinute = std::numbers::pi / 180 / 60;

FaceHeights ring_of(std::vector<double> coefficients) {
  cycle::Case c = cycle::testing::styles_new_ring();
  c.ring.face.coefficients = std::move(coefficients);
  return face_heights(c);
}
FaceHeights new_ring() { return ring_of({427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.3}); }
FaceHeights run_in_ring() { return ring_of({-197.16, 578.85, -583.44, 200.37, 56.366, -62.709, 13.857}); }
FaceHeights embedded_ring() { return ring_of({-6.493, -49.845, 143.22, -98.541, 27.351, -17.338, 7.4986}); }

struct Expected {
  double margin_mm, level_depth_um, level_area, free_depth_um, free_area, tilt_arc_minutes;
};

/// Computed with another program: the linear programme of the bound on a grid of its own, faces of styles2014.
void expect_bounds(const FaceHeights& earlier, const FaceHeights& later, const std::vector<Expected>& all) {
  for (const Expected& expected : all) {
    const WearBound level = least_wear(earlier, later, expected.margin_mm * 1e-3, Tilt::kNone);
    const WearBound free = least_wear(earlier, later, expected.margin_mm * 1e-3, Tilt::kFree);
    EXPECT_NEAR(level.depth_at_middle * 1e6, expected.level_depth_um, 0.06) << expected.margin_mm;
    EXPECT_NEAR(level.area * 1e9, expected.level_area, 0.06) << expected.margin_mm;
    EXPECT_NEAR(free.depth_at_middle * 1e6, expected.free_depth_um, 0.08) << expected.margin_mm;
    EXPECT_NEAR(free.area * 1e9, expected.free_area, 0.06) << expected.margin_mm;
    EXPECT_NEAR(free.tilt / kArcMinute, expected.tilt_arc_minutes, 1) << expected.margin_mm;
  }
}

TEST(WearBounds, FacesOfThePaperFromNewToRunIn) {
  expect_bounds(new_ring(), run_in_ring(),
                {{0, 23.0, 23.9, 16.8, 16.5, 35},
                 {0.06, 11.1, 9.8, 9.0, 7.5, 13},
                 {0.1, 6.5, 4.9, 6.0, 4.4, 4},
                 {0.3, 2.5, 1.1, 1.6, 0.6, -11}});
}

TEST(WearBounds, FacesOfThePaperFromNewToEmbedded) {
  expect_bounds(new_ring(), embedded_ring(),
                {{0, 21.5, 21.8, 19.3, 19.2, 13},
                 {0.06, 11.0, 9.7, 10.8, 9.5, 1},
                 {0.1, 7.8, 6.3, 7.3, 5.8, -4},
                 {0.3, 1.5, 0.67, 1.1, 0.46, -4}});
}

TEST(WearBounds, NoPlaceGainsMaterial) {
  const FaceHeights earlier = new_ring(), later = run_in_ring();
  const WearBound bound = least_wear(earlier, later, 0.1e-3, Tilt::kFree);
  EXPECT_GE(bound.largest_depth, bound.depth_at_middle);
  EXPECT_LT(bound.area, least_wear(earlier, later, 0.1e-3, Tilt::kNone).area);
}

TEST(WearBounds, AFaceThatIsOnlyShiftedAndTiltedHasLostNothing) {
  const FaceHeights earlier = new_ring();
  FaceHeights later = earlier;
  for (std::size_t i = 0; i < later.x.size(); ++i) later.height[i] += 3e-6 + 0.01 * (later.x[i] - 0.6e-3);
  const WearBound bound = least_wear(earlier, later, 0, Tilt::kFree);
  EXPECT_NEAR(bound.area, 0, 1e-20);
  EXPECT_NEAR(bound.tilt, -std::atan(0.01), 1e-9);
}

TEST(WearBounds, ConcaveTailsAreFound) {
  constexpr double kNoticed = 0.1e-6;
  EXPECT_TRUE(concave_stretches(new_ring(), kNoticed).empty());
  const auto run_in = concave_stretches(run_in_ring(), kNoticed),
             embedded = concave_stretches(embedded_ring(), kNoticed);
  ASSERT_EQ(run_in.size(), 1u);
  EXPECT_LT(run_in[0].from, 0.985e-3);  // where it turns concave
  EXPECT_EQ(run_in[0].to, 1.2e-3);
  EXPECT_NEAR(run_in[0].height * 1e6, 2.3, 0.1);
  ASSERT_EQ(embedded.size(), 1u);
  EXPECT_LT(embedded[0].from, 0.989e-3);
  EXPECT_NEAR(embedded[0].height * 1e6, 0.96, 0.05);
}

TEST(WearBounds, AgainstAFixedMiddleTheEdgesOfThePaperGainMaterial) {
  // Another program: 23.0 and 21.5 um at the crankcase edge, from new to run-in and to embedded.
  const Gain run_in = largest_gain(new_ring(), run_in_ring()), embedded = largest_gain(new_ring(), embedded_ring());
  EXPECT_NEAR(run_in.height * 1e6, 23.0, 0.05);
  EXPECT_NEAR(embedded.height * 1e6, 21.5, 0.05);
  EXPECT_EQ(run_in.x, 1.2e-3);
  EXPECT_LE(largest_gain(new_ring(), new_ring()).height, 0);
}

TEST(WearBounds, ATurnedFaceIsMirrored) {
  const FaceHeights face = new_ring(), other = turned(face);
  EXPECT_NEAR(other.height.front(), face.height.back(), 1e-18);
  EXPECT_NEAR(other.x.front(), 0, 1e-18);
}

}  // namespace
}  // namespace ringfilm::life
