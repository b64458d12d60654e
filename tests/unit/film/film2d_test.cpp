#include "ringfilm/film/film2d.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ringfilm::film {
namespace {

double sum(const std::vector<double>& of) { return std::accumulate(of.begin(), of.end(), 0.0); }

TEST(CircumferentialGrid, HalfwayIsByPlaceNotByNumber) {
  EXPECT_EQ(around_at({0, 1, 2, 3, 10}, 10, Ends::kOpen).halfway(), 3);
  EXPECT_EQ(uniform_around(8, 1, Ends::kOpen).halfway(), 4);
  EXPECT_EQ(uniform_around(8, 1, Ends::kJoined).halfway(), 4);
}

TEST(CircumferentialGrid, SharesAreTheLength) {
  for (const Ends ends : {Ends::kOpen, Ends::kJoined, Ends::kClosed}) {
    const CircumferentialGrid around = uniform_around(7, 2.0, ends);
    EXPECT_EQ(around.n_cells(), 7);
    EXPECT_EQ(around.n_strips(), ends == Ends::kJoined ? 7 : 8);
    EXPECT_NEAR(sum(around.share), 2.0, 1e-15);
    EXPECT_NEAR(sum(around.spacing), 2.0, 1e-15);
  }
}

TEST(CircumferentialGrid, RefinedTowardsBothEnds) {
  const double L = 0.28, end_cell = 24e-6;
  const CircumferentialGrid around = refined_around(180, L, end_cell);
  ASSERT_EQ(around.n_strips(), 181);
  EXPECT_EQ(around.y.front(), 0);
  EXPECT_EQ(around.y.back(), L);
  EXPECT_NEAR(sum(around.spacing), L, 1e-15);
  EXPECT_NEAR(around.spacing.front(), end_cell, 1e-3 * end_cell);  // the last cell of the growth is cut to the middle's
  const double middle = around.spacing[90];
  for (int c = 0; c < 180; ++c) {
    EXPECT_NEAR(around.spacing[c], around.spacing[179 - c], 1e-12);
    EXPECT_LE(around.spacing[c], middle * (1 + 1e-9));
    if (c >= 89) continue;
    EXPECT_LE(around.spacing[c + 1], kSteepestGrowth * around.spacing[c] * (1 + 1e-9)) << c;
    EXPECT_GE(around.spacing[c + 1], around.spacing[c] * (1 - 1e-9)) << c;
  }
  EXPECT_LT(middle, 1.3 * L / 180);
}

TEST(CircumferentialGrid, WithFewCellsTheEndsAreAsFineAsTheGrowthAllows) {
  const CircumferentialGrid around = refined_around(20, 0.28, 24e-6);
  EXPECT_GT(around.spacing.front(), 24e-6);
  for (int c = 0; c < 9; ++c) {
    EXPECT_LE(around.spacing[c + 1], kSteepestGrowth * around.spacing[c] * (1 + 1e-9)) << c;
  }
  EXPECT_NEAR(sum(around.spacing), 0.28, 1e-15);
}

TEST(CircumferentialGrid, ACellAsLongAsTheOthersRefinesNothing) {
  const CircumferentialGrid around = refined_around(10, 1.0, 0.2);
  for (const double cell : around.spacing) EXPECT_NEAR(cell, 0.1, 1e-15);
}

TEST(Film2dGap, OfStripsIsThatOfTheGridAcross) {
  const FilmGrid grid = uniform_grid(4, 1.0, [](double x) { return x * x; });
  const CircumferentialGrid around = uniform_around(3, 1.0, Ends::kJoined);
  const Film2dGap gap = gap_of_strips(grid, around);
  ASSERT_EQ(gap.node.size(), 15u);
  ASSERT_EQ(gap.face_x.size(), 12u);
  ASSERT_EQ(gap.face_y.size(), 15u);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 5; ++i) EXPECT_EQ(gap.node[j * 5 + i], grid.node_height[i]);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(gap.face_x[j * 4 + i], grid.face_height[i]);
  }
  EXPECT_EQ(gap.face_y, gap.node);
  EXPECT_TRUE(gap.face_x_second.empty());
}

}  // namespace
}  // namespace ringfilm::film
