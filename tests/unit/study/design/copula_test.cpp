#include "ringfilm/study/design/copula.hpp"

#include <cmath>

#include "../study_example.hpp"

namespace ringfilm::study {
namespace {

using namespace testing;

/// x1, x3 and x4 are correlated, x2 and x5 are not.
Study correlated_study(std::uint64_t points) {
  Study study =
      formula_study({normal(1, 2), uniform(0, 1), normal(-3, 0.5), lognormal(2, 0.3), normal(0, 1)}, points, 5);
  study.correlations = {{0, 2, -0.6, {}}, {0, 3, 0.3, {}}, {3, 2, 0.4, {}}};
  return study;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ma += a[i] / n;
    mb += b[i] / n;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - ma) * (a[i] - ma);
    bb += (b[i] - mb) * (b[i] - mb);
    ab += (a[i] - ma) * (b[i] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

std::vector<std::vector<double>> columns(const Plan& plan) {
  std::vector<std::vector<double>> all(plan.study().factors.size());
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    const auto x = numbers(plan.point(i));
    for (std::size_t j = 0; j < x.size(); ++j) all[j].push_back(x[j]);
  }
  return all;
}

TEST(Copula, GroupsAreWhatHangsTogether) {
  const auto groups = factor_groups(correlated_study(16));
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].name, "x1 and x3 and x4");
  EXPECT_EQ(groups[0].factors, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(groups[1].factors, (std::vector<std::size_t>{1}));
  EXPECT_EQ(groups[2].name, "x5");
  // Through others, too.
  Study chain = correlated_study(16);
  chain.correlations = {{3, 4, 0.1, {}}, {1, 2, 0.1, {}}, {2, 3, 0.1, {}}};
  ASSERT_EQ(factor_groups(chain).size(), 2u);
  EXPECT_EQ(factor_groups(chain)[1].factors, (std::vector<std::size_t>{1, 2, 3, 4}));
}

TEST(Copula, TriangleTimesItselfIsTheMatrix) {
  const std::vector<double> matrix = {1, -0.6, 0.3, -0.6, 1, 0.4, 0.3, 0.4, 1};
  const Triangle t = triangle(3, matrix);
  ASSERT_FALSE(t.failed_row);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += t.entries[3 * i + k] * t.entries[3 * j + k];
      EXPECT_NEAR(sum, matrix[3 * i + j], 1e-15);
    }
  }
  EXPECT_EQ(triangle(3, {1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1}).failed_row, 2u);
  EXPECT_EQ(triangle(2, {1, 1, 1, 1}).failed_row, 1u);
}

TEST(Copula, DrawsHaveTheCorrelationsAskedFor) {
  const Plan plan(correlated_study(4096));
  auto x = columns(plan);
  for (double& value : x[3]) value = std::log(value / 2) / 0.3;  // its normal score
  // A correlation r of n independent draws is certain to (1 - r^2)/sqrt(n) = 0.016 at most; Sobol points are better.
  EXPECT_NEAR(correlation(x[0], x[2]), -0.6, 0.01);
  EXPECT_NEAR(correlation(x[0], x[3]), 0.3, 0.01);
  EXPECT_NEAR(correlation(x[2], x[3]), 0.4, 0.01);
  for (const std::size_t other : {0u, 2u, 3u, 4u}) EXPECT_NEAR(correlation(x[1], x[other]), 0, 0.01);
}

TEST(Copula, EachFactorKeepsItsDistribution) {
  const Plan plan(correlated_study(1024));
  auto x = columns(plan);
  for (const std::size_t j : {0u, 2u, 3u}) {
    const auto& d = std::get<Distribution>(plan.study().factors[j].variation);
    std::sort(x[j].begin(), x[j].end());
    double worst = 0;
    for (std::size_t i = 0; i < x[j].size(); ++i)
      worst = std::max(worst, std::abs(probability(d, x[j][i]) - (static_cast<double>(i) + 0.5) / 1024));
    // Kolmogorov's distance of independent draws exceeds 1.95/sqrt(n) once in 1000.
    EXPECT_LT(worst, 1.95 / 32) << j;
  }
}

TEST(Copula, FactorsWithoutCorrelationAreLeftBitByBit) {
  Study with = correlated_study(64), without = with;
  without.correlations.clear();
  const Plan a(with), b(without);
  for (std::uint64_t i = 0; i < 64; ++i) {
    const auto x = numbers(a.point(i)), y = numbers(b.point(i));
    EXPECT_EQ(x[1], y[1]);
    EXPECT_EQ(x[4], y[4]);
    EXPECT_NE(x[2], y[2]);
  }
}

}  // namespace
}  // namespace ringfilm::study
