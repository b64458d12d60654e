#include "ringfilm/study/sampling/sobol_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "ringfilm/study/sampling/hash.hpp"

namespace ringfilm::study {
namespace {

/// A line of the table that Joe and Kuo published (new-joe-kuo-6): degree s of the primitive polynomial, its inner
/// coefficients a as one number, and the first s odd numbers m.
struct Published {
  unsigned s, a;
  std::vector<std::uint64_t> m;
};

const std::vector<Published>& published() {  // dimensions 2 to 10
  static const std::vector<Published> lines = {{1, 0, {1}},
                                               {2, 1, {1, 3}},
                                               {3, 1, {1, 3, 1}},
                                               {3, 2, {1, 1, 1}},
                                               {4, 1, {1, 1, 3, 3}},
                                               {4, 4, {1, 3, 5, 13}},
                                               {5, 2, {1, 1, 5, 5, 17}},
                                               {5, 4, {1, 1, 5, 5, 5}},
                                               {5, 7, {1, 1, 7, 11, 19}}};
  return lines;
}

/// Numbers m_1 ... m_32 of a dimension by the recurrence of the published notes:
/// m_k = 2 a_1 m_{k-1} + ... + 2^{s-1} a_{s-1} m_{k-s+1} + 2^s m_{k-s} + m_{k-s}, sums without carry.
std::vector<std::uint64_t> all_m(const Published& line) {
  std::vector<std::uint64_t> m = line.m;
  while (m.size() < 32) {
    const std::size_t k = m.size();
    std::uint64_t next = m[k - line.s] ^ (m[k - line.s] << line.s);
    for (unsigned j = 1; j < line.s; ++j) {
      if ((line.a >> (line.s - 1 - j)) & 1u) next ^= m[k - j] << j;
    }
    m.push_back(next);
  }
  return m;
}

double coordinate(const SobolPoints& points, std::uint64_t i, std::size_t j) {
  return static_cast<double>(points.digits(i, j)) * 0x1.0p-32;
}

TEST(SobolPoints, FirstPointsAreThoseThatJoeAndKuoPrint) {
  const SobolPoints points(3, 1);
  const std::array<std::array<double, 3>, 10> first = {{{0, 0, 0},
                                                        {0.5, 0.5, 0.5},
                                                        {0.75, 0.25, 0.25},
                                                        {0.25, 0.75, 0.75},
                                                        {0.375, 0.375, 0.625},
                                                        {0.875, 0.875, 0.125},
                                                        {0.625, 0.125, 0.875},
                                                        {0.125, 0.625, 0.375},
                                                        {0.1875, 0.3125, 0.9375},
                                                        {0.6875, 0.8125, 0.4375}}};
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) EXPECT_EQ(coordinate(points, i, j), first[i][j]) << i << ", " << j;
  }
}

TEST(SobolPoints, FollowThePublishedDirectionNumbers) {
  const std::size_t n_dimensions = published().size() + 1;
  const SobolPoints points(n_dimensions, 1);
  for (std::size_t j = 0; j < n_dimensions; ++j) {
    const std::vector<std::uint64_t> m = j == 0 ? std::vector<std::uint64_t>(32, 1) : all_m(published()[j - 1]);
    // One step after the other, as the sequence is defined in Gray code order: digit of the lowest zero of the counter.
    std::uint64_t x = 0;
    for (std::uint64_t i = 0; i < 5000; ++i) {
      ASSERT_EQ(points.digits(i, j), x) << "point " << i << ", dimension " << j + 1;
      unsigned zero = 0;
      while ((i >> zero) & 1u) ++zero;
      x ^= m[zero] << (31 - zero);
    }
    // And far out, at once.
    for (const std::uint64_t i : {std::uint64_t{123456789}, std::uint64_t{4294967295}}) {
      std::uint64_t far = 0;
      for (unsigned k = 0; k < 32; ++k) {
        if (((i ^ (i >> 1)) >> k) & 1u) far ^= m[k] << (31 - k);
      }
      EXPECT_EQ(points.digits(i, j), far) << "point " << i << ", dimension " << j + 1;
    }
  }
}

/// Do 2^m points from `first` on put one into each of the 2^m boxes of every shape?
void expect_net(const SobolPoints& points, std::uint64_t first, unsigned m) {
  for (unsigned k = 0; k <= m; ++k) {
    std::set<std::pair<long, long>> boxes;
    for (std::uint64_t i = first; i < first + (1u << m); ++i) {
      boxes.insert({static_cast<long>(std::ldexp(points.share(i, 0), static_cast<int>(k))),
                    static_cast<long>(std::ldexp(points.share(i, 1), static_cast<int>(m - k)))});
    }
    EXPECT_EQ(boxes.size(), std::size_t{1} << m) << "from " << first << ", 2^" << k << " by 2^" << m - k;
  }
}

TEST(SobolPoints, ScramblingKeepsTheNetOfTheFirstTwoDimensions) {
  for (const std::uint64_t seed : {1u, 2u, 77u}) {
    const SobolPoints points(2, seed);
    for (unsigned m = 1; m <= 9; ++m) expect_net(points, 0, m);
    expect_net(points, 3 * 256, 8);
    expect_net(points, std::uint64_t{1} << 31, 8);
  }
}

TEST(SobolPoints, EveryPointIsEvenOverTheSeeds) {
  // Share of the unit interval below x, over many seeds: the largest difference D of 4000 independent even numbers
  // exceeds 1.95/sqrt(4000) once in 1000 (Kolmogorov).
  constexpr int kSeeds = 4000;
  for (const std::uint64_t i : {0u, 1u, 1000u}) {
    std::multiset<double> seen;
    for (int seed = 0; seed < kSeeds; ++seed) seen.insert(SobolPoints(3, static_cast<unsigned>(seed)).share(i, 2));
    double worst = 0, n = 0;
    for (const double x : seen) {
      worst = std::max({worst, std::abs(x - n / kSeeds), std::abs(x - (n + 1) / kSeeds)});
      ++n;
    }
    EXPECT_LT(worst, 1.95 / std::sqrt(kSeeds)) << i;
  }
}

TEST(SobolPoints, DigitsAreFlippedByThePrecedingDigits) {
  // Nested scrambling, not one flip for a digit wherever it is: among points with equal first digits a flip is
  // common, between others it is not.
  int common = 0, other = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const auto second = [seed](std::uint32_t digits) {
      return static_cast<int>(std::ldexp(scrambled(digits, seed), 2)) & 1;
    };
    common += second(0x00000000u) == (second(0x40000000u) ^ 1);
    other += second(0x00000000u) == second(0x80000000u);
  }
  EXPECT_EQ(common, 400);
  EXPECT_NEAR(other, 200, 40) << "four standard deviations of 400 throws";
}

TEST(SobolPoints, AreMuchEvenerThanChance) {
  // f = product of 4 (1 + (x - 1/2)): mean 1, variance (1 + 1/12)^4 - 1. Scrambled, the error of the mean of a smooth f
  // falls nearly as n^-1.5; a tenth of chance at n = 1024 would already show that something is broken.
  constexpr int kSeeds = 50, kPoints = 1024;
  double square = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const SobolPoints points(4, static_cast<unsigned>(seed));
    double sum = 0;
    for (int i = 0; i < kPoints; ++i) {
      double f = 1;
      for (std::size_t j = 0; j < 4; ++j) f *= 0.5 + points.share(i, j);
      sum += f;
    }
    square += (sum / kPoints - 1) * (sum / kPoints - 1) / kSeeds;
  }
  const double chance = std::sqrt((std::pow(1 + 1.0 / 12, 4) - 1) / kPoints);
  EXPECT_LT(std::sqrt(square), 0.05 * chance);
}

TEST(SobolPoints, NeverTouchTheEnds) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    for (const std::uint32_t digits : {0u, 0xffffffffu, 0x80000000u}) {
      EXPECT_GT(scrambled(digits, seed), 0.0);
      EXPECT_LT(scrambled(digits, seed), 1.0);
    }
  }
  EXPECT_EQ(share_of(0), 0x1.0p-53);
  EXPECT_EQ(share_of(~std::uint64_t{0}), 1 - 0x1.0p-53);
}

TEST(SobolPoints, ReportsWhatItCannotGive) {
  EXPECT_NO_THROW(SobolPoints(SobolPoints::kMaxDimensions, 1));
  EXPECT_THROW(SobolPoints(SobolPoints::kMaxDimensions + 1, 1), std::invalid_argument);
  const SobolPoints points(2, 1);
  EXPECT_NO_THROW(points.share(SobolPoints::kMaxPoints - 1, 1));
  EXPECT_THROW(points.share(SobolPoints::kMaxPoints, 1), std::out_of_range);
  EXPECT_THROW(points.share(0, 2), std::out_of_range);
}

TEST(Hash, BitsAreTheSameOnEveryMachine) {
  // splitmix64 from the state 0: its first output as published with the reference implementation.
  EXPECT_EQ(hash(0), 0xe220a8397b1dcdafu);
  EXPECT_NE(hash(1, 2, 3), hash(1, 3, 2));
  static_assert(hash(0) == mixed(0x9e3779b97f4a7c15u));
}

TEST(Hash, BelowIsEven) {
  std::array<int, 7> counts{};
  for (std::uint64_t i = 0; i < 70000; ++i) ++counts[below(7, hash(5, i))];
  for (const int count : counts) EXPECT_NEAR(count, 10000, 4.5 * std::sqrt(10000.0 * 6 / 7));
}

}  // namespace
}  // namespace ringfilm::study
