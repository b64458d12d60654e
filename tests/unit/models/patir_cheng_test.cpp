#include "ringfilm/models/patir_cheng.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ringfilm::models {
namespace {

TEST(PatirCheng, HasThePublishedRows) {
  struct Row {
    double gamma, C, r;
  };
  // patir1978, Table 1
  for (const Row& row :
       {Row{1.0 / 9, 1.48, 0.42}, Row{1.0 / 6, 1.38, 0.42}, Row{0.3333333333333333, 1.18, 0.42}, Row{1, 0.90, 0.56}}) {
    EXPECT_EQ(PatirCheng(row.gamma).pressure_flow(3), 1 - row.C * std::exp(-row.r * 3)) << row.gamma;
  }
  for (const Row& row : {Row{3, 0.225, 1.5}, Row{6, 0.520, 1.5}, Row{9, 0.870, 1.5}}) {
    EXPECT_EQ(PatirCheng(row.gamma).pressure_flow(3), 1 + row.C * std::pow(3, -row.r)) << row.gamma;
  }
  // patir1979, Tables 1 to 3
  const PatirCheng isotropic(1), across(1.0 / 9);
  EXPECT_EQ(isotropic.shear_flow(2), 1.899 * std::pow(2, 0.98) * std::exp(2 * (0.05 * 2 - 0.92)));
  EXPECT_EQ(isotropic.shear_flow(6), 1.126 * std::exp(-1.5));
  EXPECT_EQ(isotropic.shear_stress(2), 11.1 * std::pow(2, 2.31) * std::exp(2 * (0.11 * 2 - 2.38)));
  EXPECT_EQ(isotropic.pressure_stress(2), 1 - 1.40 * std::exp(-0.66 * 2));
  EXPECT_EQ(across.shear_flow(2), 2.046 * std::pow(2, 1.12) * std::exp(2 * (0.03 * 2 - 0.78)));
  EXPECT_EQ(across.pressure_stress(2), 1 - 1.51 * std::exp(-0.52 * 2));
}

TEST(PatirCheng, IsLinearInTheLogarithmOfTheOrientationBetweenRows) {
  const double between = PatirCheng(std::sqrt(3.0)).pressure_flow(2);
  EXPECT_NEAR(between, 0.5 * (PatirCheng(1).pressure_flow(2) + PatirCheng(3).pressure_flow(2)), 1e-14);
  EXPECT_EQ(PatirCheng(1e-3).pressure_flow(2), PatirCheng(1.0 / 9).pressure_flow(2));
  EXPECT_EQ(PatirCheng(100).pressure_flow(2), PatirCheng(9).pressure_flow(2));
}

TEST(PatirCheng, VanishesInThickFilms) {
  for (const double gamma : {1.0 / 9, 1.0 / 3, 1.0}) EXPECT_NEAR(PatirCheng(gamma).pressure_flow(20), 1, 1e-3 * 1.5);
  const PatirCheng isotropic(1);
  EXPECT_NEAR(isotropic.pressure_flow(12.2), 1, 1e-3);
  EXPECT_NEAR(isotropic.pressure_stress(12.2), 1, 1e-3);
  EXPECT_EQ(isotropic.shear_stress(7), 0);
  EXPECT_LT(isotropic.shear_flow(30), 1e-3);
}

TEST(PatirCheng, FilmsBelowATableHaveTheValuesAtItsEnd) {
  EXPECT_EQ(PatirCheng(1.0 / 9).pressure_flow(0.2), PatirCheng(1.0 / 9).pressure_flow(1));
  EXPECT_EQ(PatirCheng(1).shear_flow(0.2), PatirCheng(1).shear_flow(0.5));
  EXPECT_GT(PatirCheng(1.0 / 9).pressure_flow(0.2), 0);
}

/// The mean that the closed form stands for, by the midpoint rule over heights of density 35/96 (1 - (s/3)^2)^3.
double mean_of_inverse(double H) {
  constexpr int n = 2'000'000;
  const double from = std::max(-3.0, 0.01 - H), width = (3 - from) / n;
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    const double s = from + (k + 0.5) * width, base = 1 - s * s / 9;
    sum += base * base * base / (H + s);
  }
  return 35.0 / 96 * H * sum * width;
}

TEST(PatirCheng, MeanInverseFilmIsThatOfItsHeights) {
  // Where films end at sigma/100, the closed form omits terms of that size.
  for (const double H : {0.5, 1.0, 2.0, 2.9}) EXPECT_NEAR(mean_inverse_film(H), mean_of_inverse(H), 5e-3) << H;
  for (const double H : {3.1, 5.0, 8.9, 9.1, 20.0}) EXPECT_NEAR(mean_inverse_film(H), mean_of_inverse(H), 1e-9) << H;
  EXPECT_NEAR(mean_inverse_film(50), 1 + 1.0 / 2500, 1e-6);  // 1 + sigma^2/h^2
}

TEST(PatirCheng, AverageGapIsThatOfGaussianHeights) {
  EXPECT_NEAR(average_gap_excess(0), 1 / std::sqrt(2 * std::numbers::pi), 1e-15);
  EXPECT_NEAR(average_gap_excess(-4) - 4, average_gap_excess(4), 1e-14);  // <max(0, H + s)> - <max(0, -H - s)> = H
  EXPECT_LT(average_gap_excess(3), 4e-4);
  EXPECT_GT(average_gap_excess(3), 3e-4);
}

}  // namespace
}  // namespace ringfilm::models
