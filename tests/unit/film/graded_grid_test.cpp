#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {
namespace {

constexpr double kWidth = 1e-3, kThinnest = 1e-10;  // [m]

TEST(GradedGrid, CellsAreShortWhereTheGapIsThinAndSteep) {
  const auto parabola = [](double x) { return 1e-4 * std::pow(2 * x / kWidth - 0.6, 2); };  // lowest between nodes
  const FilmGrid grid = graded_grid(50, kWidth, parabola, kThinnest);
  for (int i = 0; i < grid.n_cells(); ++i) {
    const auto [low, high] = std::minmax({grid.node_height[i], grid.face_height[i], grid.node_height[i + 1]});
    EXPECT_LE(high - low, 0.5 * (kThinnest + low)) << i;
  }
  // 14 powers of e between 0.1 nm and 100 um, on two sides, and cells that are halved rather than fitted.
  EXPECT_GT(grid.n_cells(), 50);
  EXPECT_LT(grid.n_cells(), 200);
}

TEST(GradedGrid, IsUniformWhereTheGapHardlyChanges) {
  const auto level = [](double x) { return 1e-6 * x; };
  const FilmGrid graded = graded_grid(40, kWidth, level, kThinnest), uniform = uniform_grid(40, kWidth, level);
  EXPECT_EQ(graded.n_cells(), uniform.n_cells());
  for (std::size_t i = 0; i < uniform.x.size(); ++i) EXPECT_DOUBLE_EQ(graded.x[i], uniform.x[i]);
}

TEST(GradedGrid, ThatMayTurnHasNodesInMirroredPlaces) {
  const auto slope = [](double x) { return 0.01 * x; };
  const FilmGrid grid = graded_grid(20, kWidth, slope, kThinnest, Turning::kPossible);
  EXPECT_GT(grid.n_cells(), graded_grid(20, kWidth, slope, kThinnest).n_cells());
  const std::size_t last = grid.x.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) EXPECT_NEAR(grid.x[i] + grid.x[last - i], kWidth, 1e-17) << i;
}

TEST(GradedGrid, ValleysBetweenTheFirstNodesAreSeen) {
  const auto valley = [](double x) { return std::min(1e-6, 0.1 * std::abs(x - 0.3337 * kWidth)); };  // 20 um wide
  const FilmGrid grid = graded_grid(20, kWidth, valley, kThinnest);
  EXPECT_LT(*std::min_element(grid.face_height.begin(), grid.face_height.end()), kThinnest);
}

TEST(GradedGrid, SharesAddUpToTheWidth) {
  const FilmGrid grid = graded_grid(
      20, kWidth, [](double x) { return x > kWidth / 3 ? x - kWidth / 3 : 0; }, kThinnest);
  double sum = 0, length = 0;
  for (const double share : grid.share) sum += share;
  for (const double spacing : grid.spacing) length += spacing;
  EXPECT_NEAR(sum, kWidth, 1e-15);
  EXPECT_NEAR(length, kWidth, 1e-15);
  EXPECT_EQ(grid.x.back(), kWidth);
}

TEST(GridByGap, CellsFollowTheRootOfTheGap) {
  const double width = 1.2e-3, reference = 0.5e-6;
  const auto height = [&](double x) { return 25e-6 * std::pow(2 * x / width - 1, 2); };
  const FilmGrid grid = grid_by_gap(100, width, height, reference);
  ASSERT_EQ(grid.n_cells(), 100);
  EXPECT_DOUBLE_EQ(grid.x.back(), width);
  EXPECT_EQ(std::min_element(grid.node_height.begin(), grid.node_height.end()) - grid.node_height.begin(), 50);
  double length = 0;
  for (int i = 0; i < 100; ++i) {
    length += grid.spacing[i];
    const double root = std::sqrt(reference + height(0.5 * (grid.x[i] + grid.x[i + 1])));
    EXPECT_NEAR(grid.spacing[i] / grid.spacing[49] * std::sqrt(reference), root, 0.02 * root) << i;
  }
  EXPECT_NEAR(length, width, 1e-15);
}

TEST(GridByGap, SuitsAFaceThatTurnsOver) {
  const auto height = [](double x) { return 30e-6 * x / 1e-3; };  // lowest at x = 0
  const FilmGrid grid = grid_by_gap(40, 1e-3, height, 1e-6, Turning::kPossible);
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(grid.spacing[i], grid.spacing[39 - i], 1e-9 * 1e-3);
}

}  // namespace
}  // namespace ringfilm::film
