#include "ringfilm/study/statistics/shares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace ringfilm::study {
namespace {

using Shares = std::vector<std::vector<std::size_t>>;

cycle::Case of_cells(int cells) {
  cycle::Case c;
  c.solver.cells = cells;
  return c;
}

std::vector<std::size_t> sorted_members(const Shares& shares) {
  std::vector<std::size_t> all;
  for (const auto& share : shares) all.insert(all.end(), share.begin(), share.end());
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Shares, EveryCaseIsInOneShare) {
  std::vector<cycle::Case> cases;
  for (int i = 0; i < 61; ++i) cases.push_back(of_cells(50 + 37 * (i % 9)));
  std::vector<std::size_t> all(cases.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const int n_threads : {1, 2, 3, 16, 100}) {
    const Shares given = shares(cases, n_threads, 8);
    EXPECT_LE(given.size(), static_cast<std::size_t>(n_threads));
    EXPECT_EQ(sorted_members(given), all);
    for (const auto& share : given) EXPECT_FALSE(share.empty());
  }
}

TEST(Shares, UnrolledFilmsFillNoLanesAndCountAsAllOfTheirStrips) {
  // Two unrolled films of as many nodes as 100 films across the face each: one for each thread.
  std::vector<cycle::Case> cases(2, of_cells(40));
  for (cycle::Case& c : cases) {
    c.film.dimension = cycle::FilmDimension::kUnrolled;
    c.solver.cells_y = 100;
  }
  const Shares given = shares(cases, 2, 8);
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].size(), 1u);
  // With eight films across the face beside one of them: these are the lighter load, and stay together.
  cases.pop_back();
  for (int i = 0; i < 8; ++i) cases.push_back(of_cells(40));
  const Shares mixed = shares(cases, 2, 8);
  ASSERT_EQ(mixed.size(), 2u);
  EXPECT_EQ(mixed[0], std::vector<std::size_t>{0});
  EXPECT_EQ(mixed[1].size(), 8u);
}

TEST(Shares, FewAlikeAreSharedEvenly) {
  const std::vector<cycle::Case> cases(10, of_cells(200));
  const Shares two = shares(cases, 2, 8);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].size(), 5u);
  EXPECT_EQ(two[1].size(), 5u);
  EXPECT_EQ(shares(cases, 16, 8).size(), 10u);
  EXPECT_TRUE(shares({}, 4, 8).empty());
}

TEST(Shares, MoreThanTheLanesKeepLikeBesideLike) {
  std::vector<cycle::Case> cases;
  for (int i = 0; i < 8; ++i) {
    cases.push_back(of_cells(100));
    cases.push_back(of_cells(400));
  }
  const Shares two = shares(cases, 2, 8);
  ASSERT_EQ(two.size(), 2u);
  for (const auto& share : two) {
    for (const std::size_t i : share) EXPECT_EQ(i % 2, share.front() % 2);
  }
}

TEST(Shares, LikeAreThoseWithTheSameNextPowerOfTwo) {
  std::vector<cycle::Case> cases(8, of_cells(128));
  for (int i = 0; i < 4; ++i) {
    cases.push_back(of_cells(129));
    cases.push_back(of_cells(256));
  }
  const Shares two = shares(cases, 2, 8);
  ASSERT_EQ(two.size(), 2u);
  for (const auto& share : two) {
    EXPECT_EQ(share.size(), 8u);
    for (const std::size_t i : share) EXPECT_EQ(i < 8, share.front() < 8);
  }
}

TEST(Shares, TheLongestIntegrationKeepsAThreadToItself) {
  std::vector<cycle::Case> cases(4, of_cells(100));
  cases.push_back(of_cells(1600));
  const Shares two = shares(cases, 2, 8);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0], (std::vector<std::size_t>{4}));
}

}  // namespace
}  // namespace ringfilm::study
