#include "ringfilm/study/sampling/latin_hypercube.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace ringfilm::study {
namespace {

TEST(LatinHypercube, ShuffledIsOneToOne) {
  for (const std::uint64_t n : {1u, 2u, 3u, 5u, 16u, 17u, 100u, 1000u, 4097u}) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < n; ++i) seen.insert(shuffled(i, n, 42));
    EXPECT_EQ(seen.size(), n);
    EXPECT_EQ(*seen.rbegin(), n - 1);
    EXPECT_THROW(shuffled(n, n, 42), std::out_of_range);
  }
  const std::uint64_t many = std::uint64_t{1} << 32;
  EXPECT_LT(shuffled(many - 1, many, 3), many);
}

TEST(LatinHypercube, EveryPlaceIsAsLikely) {
  // The place of 0 among 5, over 5000 seeds: 1000 each, give or take 4.5 standard deviations of 28.
  std::array<std::array<int, 5>, 5> counts{};
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    for (std::uint64_t i = 0; i < 5; ++i) ++counts[i][shuffled(i, 5, seed)];
  }
  for (const auto& row : counts) {
    for (const int count : row) EXPECT_NEAR(count, 1000, 4.5 * std::sqrt(5000 * 0.2 * 0.8));
  }
}

TEST(LatinHypercube, EachPartOfEachDimensionHoldsOnePoint) {
  for (const std::uint64_t n : {1u, 2u, 7u, 64u, 1000u}) {
    const LatinHypercube points(n, 9);
    for (const std::size_t j : {0u, 1u, 30u}) {
      std::set<std::uint64_t> parts;
      for (std::uint64_t i = 0; i < n; ++i) {
        const double share = points.share(i, j);
        ASSERT_GT(share, 0);
        ASSERT_LT(share, 1);
        parts.insert(static_cast<std::uint64_t>(share * static_cast<double>(n)));
      }
      EXPECT_EQ(parts.size(), n);
    }
  }
}

TEST(LatinHypercube, DimensionsAreIndependent) {
  // The correlation of two random orders of n has the standard deviation 1/sqrt(n - 1).
  constexpr int kSeeds = 300, kPoints = 20;
  double square = 0, sum = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    double product = 0;
    for (std::uint64_t i = 0; i < kPoints; ++i) {
      const double a = static_cast<double>(shuffled(i, kPoints, 2 * seed)) - (kPoints - 1) / 2.0;
      const double b = static_cast<double>(shuffled(i, kPoints, 2 * seed + 1)) - (kPoints - 1) / 2.0;
      product += a * b;
    }
    const double correlation = product / (kPoints * (kPoints * kPoints - 1) / 12.0);
    sum += correlation / kSeeds;
    square += correlation * correlation / kSeeds;
  }
  const double deviation = 1 / std::sqrt(kPoints - 1.0);
  EXPECT_NEAR(sum, 0, 4.5 * deviation / std::sqrt(kSeeds));
  EXPECT_NEAR(std::sqrt(square), deviation, 4.5 * deviation / std::sqrt(2.0 * kSeeds));
}

TEST(LatinHypercube, PlaceWithinAPartIsEven) {
  const LatinHypercube points(5000, 4);
  double sum = 0, square = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const double within = std::fmod(points.share(i, 3) * 5000, 1.0);
    sum += within / 5000;
    square += within * within / 5000;
  }
  EXPECT_NEAR(sum, 0.5, 4.5 / std::sqrt(12.0 * 5000));
  EXPECT_NEAR(square, 1.0 / 3, 4.5 * std::sqrt(4.0 / 45 / 5000));
}

}  // namespace
}  // namespace ringfilm::study
