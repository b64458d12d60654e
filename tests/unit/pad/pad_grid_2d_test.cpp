#include "ringfilm/pad/pad_grid_2d.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ringfilm::pad {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kRounding = 1e-14;

TEST(GapSurface, IsBilinearBetweenPointsAndJumpsAtPlacesThatComeTwice) {
  // x steps at 2, y at 1; one height for each corner of each of the four pieces.
  const GapSurface gap({0, 2, 2, 3}, {0, 1, 1, 3},
                       {0, 2, 5, 5,  //
                        4, 6, 5, 9,  //
                        7, 7, 8, 8,  //
                        7, 9, 8, 8});
  EXPECT_THAT(gap.pieces_x(), ElementsAre(std::pair(0.0, 2.0), std::pair(2.0, 3.0)));
  EXPECT_THAT(gap.pieces_y(), ElementsAre(std::pair(0.0, 1.0), std::pair(1.0, 3.0)));
  EXPECT_DOUBLE_EQ(gap.height(0, 0, 1, 0.5), 3);  // middle of 0, 2, 4, 6
  EXPECT_DOUBLE_EQ(gap.height(0, 0, 2, 1), 6);
  EXPECT_DOUBLE_EQ(gap.height(1, 0, 2, 1), 5);
  EXPECT_DOUBLE_EQ(gap.height(0, 1, 2, 1), 7);
  EXPECT_DOUBLE_EQ(gap.height(1, 1, 2, 1), 8);
  EXPECT_DOUBLE_EQ(gap.height(0, 1, 2, 3), 9);
  EXPECT_DOUBLE_EQ(gap.height(1, 0, 2.5, 1), 7);
}

TEST(GapSurface, FindsItsPlaceAmongManyPoints) {
  const GapSurface gap({0, 1, 2, 3, 4}, {0, 1}, {0, 1, 4, 9, 16, 0, 1, 4, 9, 16});
  EXPECT_DOUBLE_EQ(gap.height(0, 0, 2.5, 0.3), 6.5);
  EXPECT_DOUBLE_EQ(gap.height(0, 0, 4, 1), 16);
  EXPECT_DOUBLE_EQ(gap.height(0, 0, 0, 0), 0);
  EXPECT_DOUBLE_EQ(gap.height(0, 0, 3, 1), 9);
}

/// A pocket 8 deep, 1 <= x <= 2 and 1 <= y <= 3, in a flat pad of 4 times 4 that is 0 high.
GapSurface pocket() {
  return {{0, 1, 1, 2, 2, 4}, {0, 1, 1, 3, 3, 4}, {0, 0, 0, 0, 0, 0,  //
                                                   0, 0, 0, 0, 0, 0,  //
                                                   0, 0, 8, 8, 0, 0,  //
                                                   0, 0, 8, 8, 0, 0,  //
                                                   0, 0, 0, 0, 0, 0,  //
                                                   0, 0, 0, 0, 0, 0}};
}

TEST(PadGrid2d, StepsAreNodesInBothDirections) {
  const PadGrid2d film2d = pad_grid_2d(pocket(), {8, 8}, film::Ends::kOpen);
  EXPECT_THAT(film2d.grid.x, ElementsAre(0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4));
  EXPECT_THAT(film2d.around.y, ElementsAre(0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4));
  EXPECT_THAT(film2d.steps_x, ElementsAre(2, 4));
  EXPECT_THAT(film2d.steps_y, ElementsAre(2, 6));
  EXPECT_THAT(film2d.piece_of_x, ElementsAre(0, 0, 1, 1, 2, 2, 2, 2));
  EXPECT_TRUE(film2d.grid.jumps.empty());
  EXPECT_EQ(film2d.lowest, 0);
}

TEST(PadGrid2d, NodesOnWallsHoldTheMeanOfWhatSurroundsThem) {
  const PadGrid2d film2d = pad_grid_2d(pocket(), {8, 8}, film::Ends::kOpen);
  const auto node = [&](int i, int j) { return film2d.gap.node[static_cast<std::size_t>(j) * 9 + i]; };
  EXPECT_EQ(node(0, 0), 0);
  EXPECT_EQ(node(3, 4), 8);               // inside
  EXPECT_NEAR(node(2, 4), 4, kRounding);  // on a wall
  EXPECT_NEAR(node(3, 2), 4, kRounding);  // on another
  EXPECT_NEAR(node(2, 2), 2, kRounding);  // at a corner: a quarter of it
  EXPECT_EQ(node(1, 4), 0);
}

// A wall along x halves the share of the strips on it: two heights of equal weight, d apart, have the moments d^2/4, 0.
TEST(PadGrid2d, FacesOnWallsHoldTheMomentsOfTheirHalves) {
  const PadGrid2d film2d = pad_grid_2d(pocket(), {8, 8}, film::Ends::kOpen);
  const auto face_x = [&](const std::vector<double>& of, int i, int j) {
    return of[static_cast<std::size_t>(j) * 8 + i];
  };
  const auto face_y = [&](const std::vector<double>& of, int i, int j) {
    return of[static_cast<std::size_t>(j) * 9 + i];
  };
  ASSERT_EQ(film2d.gap.face_x.size(), 8u * 9);
  ASSERT_EQ(film2d.gap.face_y.size(), 9u * 8);
  EXPECT_NEAR(face_x(film2d.gap.face_x, 2, 2), 4, kRounding);
  EXPECT_NEAR(face_x(film2d.gap.face_x_second, 2, 2), 16, 1e-13);
  EXPECT_NEAR(face_x(film2d.gap.face_x_third, 2, 2), 0, 1e-12);
  EXPECT_EQ(face_x(film2d.gap.face_x, 2, 4), 8);
  EXPECT_EQ(face_x(film2d.gap.face_x_second, 2, 4), 0);
  EXPECT_EQ(face_x(film2d.gap.face_x_second, 1, 2), 0);  // before the pocket nothing steps
  EXPECT_NEAR(face_y(film2d.gap.face_y, 2, 3), 4, kRounding);
  EXPECT_NEAR(face_y(film2d.gap.face_y_second, 2, 3), 16, 1e-13);
  EXPECT_EQ(face_y(film2d.gap.face_y, 3, 3), 8);
  EXPECT_EQ(face_y(film2d.gap.face_y, 3, 0), 0);
}

// Cells of other lengths on the two sides of a wall: weights 1/3 and 2/3 of heights 0 and 6 have mean 4, second moment
// 8, third (1/3)(-4)^3 + (2/3) 2^3 = -16.
TEST(PadGrid2d, HalvesCountByTheirLengths) {
  const GapSurface gap({0, 4}, {0, 2, 2, 6}, {0, 0, 0, 0, 6, 6, 6, 6});
  const PadGrid2d film2d = pad_grid_2d(gap, {2, 2}, film::Ends::kClosed);
  ASSERT_THAT(film2d.around.spacing, ElementsAre(1, 1, 2, 2));
  const auto on_wall = [](const std::vector<double>& of, int n) { return of[2 * static_cast<std::size_t>(n)]; };
  EXPECT_NEAR(on_wall(film2d.gap.node, 3), 4, kRounding);
  EXPECT_NEAR(on_wall(film2d.gap.face_x, 2), 4, kRounding);
  EXPECT_NEAR(on_wall(film2d.gap.face_x_second, 2), 8, 1e-13);
  EXPECT_NEAR(on_wall(film2d.gap.face_x_third, 2), -16, 1e-12);
  EXPECT_THAT(film2d.gap.face_y_second, Each(0));  // there, and without a step
  EXPECT_THAT(film2d.gap.face_y_third, Each(0));
}

TEST(PadGrid2d, WithoutStepsNothingHasMoments) {
  const GapSurface gap({0, 1}, {0, 1}, {0, 1, 2, 3});
  const PadGrid2d film2d = pad_grid_2d(gap, {4, 2}, film::Ends::kOpen);
  EXPECT_THAT(film2d.gap.face_x_second, IsEmpty());
  EXPECT_THAT(film2d.gap.face_y_second, IsEmpty());
  // h = x + 2 y: nodes and faces have their own heights.
  EXPECT_THAT(film2d.gap.node, ElementsAre(0, 0.25, 0.5, 0.75, 1, 1, 1.25, 1.5, 1.75, 2, 2, 2.25, 2.5, 2.75, 3));
  EXPECT_NEAR(film2d.gap.face_x[4 + 1], 1.375, kRounding);  // x = 3/8, y = 1/2
  EXPECT_NEAR(film2d.gap.face_y[5 + 2], 2.0, kRounding);    // x = 1/2, y = 3/4
}

// The first strip has a half cell at either side of the seam.
TEST(PadGrid2d, JoinedSidesMeetOnTheFirstStrip) {
  const GapSurface gap({0, 1}, {0, 1, 2}, {3, 3, 5, 5, 3, 3});
  const PadGrid2d film2d = pad_grid_2d(gap, {2, 4}, film::Ends::kJoined);
  EXPECT_THAT(film2d.around.y, ElementsAre(0, 0.5, 1, 1.5));
  EXPECT_THAT(film2d.around.share, ElementsAre(0.5, 0.5, 0.5, 0.5));
  ASSERT_EQ(film2d.gap.node.size(), 12u);
  ASSERT_EQ(film2d.gap.face_y.size(), 12u);
  EXPECT_EQ(film2d.gap.node[0], 3);
  EXPECT_NEAR(film2d.gap.face_y[9], 3.5, kRounding);  // between the last strip and the first
  EXPECT_THAT(film2d.gap.face_x_second, IsEmpty());
}

// A cell that is to the right of a step sees the right side's height, not that of the point on the step.
TEST(PadGrid2d, AStepAlongXAloneHasNoMoments) {
  const GapSurface gap({0, 1, 1, 2}, {0, 1}, {4, 4, 1, 1, 4, 4, 1, 1});
  const PadGrid2d film2d = pad_grid_2d(gap, {4, 2}, film::Ends::kClosed);
  EXPECT_THAT(film2d.gap.face_x_second, Each(0));
  ASSERT_FALSE(film2d.gap.face_y_second.empty());  // the share of the node on the step has two halves in x
  EXPECT_NEAR(film2d.gap.face_y_second[2], 2.25, kRounding);
  EXPECT_EQ(film2d.gap.face_x[1], 4);
  EXPECT_EQ(film2d.gap.face_x[2], 1);
}

}  // namespace
}  // namespace ringfilm::pad
