#include "ringfilm/study/statistics/histogram.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace ringfilm::study {
namespace {

std::uint64_t sum(const std::vector<std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

std::vector<double> even(std::size_t n, double low, double high) {
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i)
    values.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(n - 1));
  return values;
}

TEST(Histogram, CountsEveryValueOnceInBinsThatSamplesShare) {
  const Histogram found = histogram({even(400, 0, 1), even(100, 0.5, 2)});
  ASSERT_EQ(found.edges.size(), 21u);  // square root of the larger sample
  EXPECT_DOUBLE_EQ(found.edges.front(), 0);
  EXPECT_DOUBLE_EQ(found.edges.back(), 2);
  EXPECT_EQ(sum(found.counts[0]), 400u);
  EXPECT_EQ(sum(found.counts[1]), 100u);
  EXPECT_EQ(found.counts[0].back(), 0u);
  EXPECT_GT(found.counts[1].back(), 0u);  // the largest value lies in the last bin, not beyond it
}

TEST(Histogram, OmitsFarTailsAndCountsThem) {
  std::vector<double> values = even(1000, 0, 1);
  values.push_back(1e6);
  const Histogram found = histogram({values});
  EXPECT_LT(found.edges.back(), 1.1);
  EXPECT_GE(found.above[0], 1u);
  EXPECT_EQ(sum(found.counts[0]) + found.above[0] + found.below[0], values.size());
}

TEST(Histogram, TakesValuesThatAreAllAlikeAndSamplesWithoutAny) {
  const Histogram alike = histogram({{3, 3, 3}, {}});
  EXPECT_EQ(sum(alike.counts[0]), 3u);
  EXPECT_EQ(sum(alike.counts[1]), 0u);
  EXPECT_LT(alike.edges.front(), 3);
  EXPECT_GT(alike.edges.back(), 3);
  EXPECT_TRUE(histogram({{}}).edges.empty());
}

}  // namespace
}  // namespace ringfilm::study
