#include "ringfilm/surface/topography/material_ratio.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kCurvePoints = 20000;

std::vector<double> curve(const std::function<double(double)>& z, std::size_t points = kCurvePoints) {
  std::vector<double> heights(points);
  for (std::size_t i = 0; i < points; ++i) heights[i] = z((static_cast<double>(i) + 0.5) / static_cast<double>(points));
  return heights;
}

TEST(Bearing, ThreeStraightPartsGiveTheirClosedForm) {
  // A core falling by F over the whole, peaks of P over the first 10 %, valleys of V over the last 20 %.
  const double F = 1e-6, P = 0.8e-6, V = 2.5e-6;
  const CoreRoughness of = core_roughness(curve([&](double m) {
    if (m < 0.1) return -0.1 * F + P * (1 - m / 0.1);
    if (m > 0.8) return -0.8 * F - V * (m - 0.8) / 0.2;
    return -F * m;
  }));
  const double step = 1.0 / kCurvePoints;  // the curve is known at its points only
  EXPECT_NEAR(of.Rk_m, F, 1e-9 * F);
  EXPECT_NEAR(of.upper_m, 0, 1e-9 * F);
  EXPECT_NEAR(of.Mr1, 0.1 * (1 - 0.1 * F / P), step);
  EXPECT_NEAR(of.Mr2, 0.8 + 0.2 * (0.2 * F / V), step);
  EXPECT_NEAR(of.Rpk_m, P - 0.1 * F, 20 * step * P);
  EXPECT_NEAR(of.Rvk_m, V - 0.2 * F, 20 * step * V);
}

TEST(Bearing, AStraightCurveIsAllCore) {
  const CoreRoughness of = core_roughness(curve([](double m) { return 1 - m; }));
  EXPECT_NEAR(of.Rk_m, 1, 1e-12);
  EXPECT_NEAR(of.Rpk_m, 0, 1e-12);
  EXPECT_NEAR(of.Rvk_m, 0, 1e-12);
  EXPECT_NEAR(of.Mr1, 0, 1.0 / kCurvePoints);
  EXPECT_NEAR(of.Mr2, 1, 1.0 / kCurvePoints);
}

TEST(Bearing, TheLineFollowsTheLeastSquaresOfTheFlattestPart) {
  // z = (1/2 - m)^3: flattest over 0.3 to 0.7; least squares of t^3 over -w..w have the slope 3 w^2/5, here w = 0.2.
  const CoreRoughness of = core_roughness(curve([](double m) { return std::pow(0.5 - m, 3); }));
  const double fall = 3 * 0.04 / 5;
  EXPECT_NEAR(of.Rk_m, fall, 1e-5);
  // Peaks above fall/2: t^3 > fall/2 from t1 on.
  const double t1 = std::cbrt(fall / 2), area = (0.0625 - std::pow(t1, 4)) / 4 - fall / 2 * (0.5 - t1);
  EXPECT_NEAR(of.Mr1, 0.5 - t1, 1e-4);
  EXPECT_NEAR(of.Rpk_m, 2 * area / (0.5 - t1), 1e-4);
  EXPECT_NEAR(of.Rvk_m, of.Rpk_m, 1e-4);
}

double quantile(double m) { return -std::sqrt(2.0) * boost::math::erfc_inv(2 * m); }

TEST(Bearing, TwoLinesOverProbabilityAreFoundAgain) {
  const double plateau = 0.1e-6, valley = 1.2e-6, meet = 0.9;
  const auto of = probability_roughness(curve([&](double m) {
    const double s = quantile(m);
    return m < meet ? -plateau * s : -plateau * quantile(meet) - valley * (s - quantile(meet));
  }));
  ASSERT_TRUE(of);
  // Sampled at steps of 0.01 standard deviations, interpolated between points of the curve.
  EXPECT_NEAR(of->Rpq_m, plateau, 0.002 * plateau);
  EXPECT_NEAR(of->Rvq_m, valley, 0.002 * valley);
  EXPECT_NEAR(of->Rmq, meet, 0.002);
  // The line of the plateau is 0 at one half, and both meet on it.
  EXPECT_NEAR(of->plateau_m, 0, 0.01 * plateau);
  EXPECT_NEAR(of->meet_m, -plateau * quantile(meet), 0.03 * plateau);
}

TEST(Bearing, ASurfaceMadeInOneStepHasNoSecondLine) {
  EXPECT_FALSE(probability_roughness(curve([](double m) { return -1e-7 * quantile(m); })));
  // Steep peaks over a flat rest are not a plateau with valleys.
  EXPECT_FALSE(probability_roughness(curve([](double m) {
    const double s = quantile(m);
    return s < -1 ? -5 * (s + 1) + 1 : -s;
  })));
  // Two levels of nearly the same roughness: their lines meet far beyond the curve.
  EXPECT_FALSE(probability_roughness(curve([](double m) {
    const double s = quantile(m);
    return m < 0.7 ? -s : -5 - 1.1 * s;
  })));
}

TEST(Bearing, CavitiesAreCountedByTheirRule) {
  // 15 % of the area 3 um to 5 um below a plateau of even heights over 0.2 um.
  const std::vector<double> z =
      curve([](double m) { return m < 0.85 ? 0.2e-6 * (0.5 - m / 0.85) : -3e-6 - 2e-6 * (m - 0.85) / 0.15; });
  for (const auto& [rule, depth] : {std::pair{CavityRule::below_plateau, 0.0}, {CavityRule::below_depth, 1e-6}}) {
    const Cavities of = cavities(z, rule, depth);
    const double median = 0.2e-6 * (0.5 - 0.5 / 0.85);
    EXPECT_NEAR(of.area_share, 0.15, 1.0 / kCurvePoints);
    EXPECT_NEAR(of.mean_depth_m, 4e-6 + median, 1e-9);
    EXPECT_NEAR(of.volume_m, 0.15 * (4e-6 + of.threshold_m), 1e-11);
  }
  EXPECT_NEAR(cavities(z, CavityRule::below_core).area_share, 1 - core_roughness(z).Mr2, 2.0 / kCurvePoints);
  // The plateau's edge is 0.2 um 0.35/0.85 below the median: the 3 sigma rule does not reach into it.
  EXPECT_LT(cavities(z, CavityRule::below_plateau).threshold_m, -0.1e-6);
  EXPECT_THROW(cavities(z, CavityRule::below_depth, 0), InputError);
  EXPECT_EQ(cavities(z, CavityRule::below_depth, 1e-3).area_share, 0);
}

TEST(Bearing, CurvesThatAreNoneAreRefused) {
  EXPECT_THROW(core_roughness(std::vector<double>(100, 1e-6)), InputError);
  EXPECT_THROW(core_roughness(curve([](double m) { return m; })), InputError);
  EXPECT_THROW(core_roughness(curve([](double m) { return -m; }, 19)), InputError);
  EXPECT_THROW(probability_roughness(curve([](double m) { return -m; }, 99)), InputError);
}

/// Falling heights of a triangle wave of this height: their material ratio curve is a straight line.
std::vector<double> straight_curve(std::size_t points, double height_m) {
  std::vector<double> z(points);
  for (std::size_t i = 0; i < points; ++i) {
    z[i] = height_m * (1 - (static_cast<double>(i) + 0.5) / static_cast<double>(points));
  }
  return z;
}

TEST(MaterialRatio, AStraightCurveHasTheVolumesOfItsTriangles) {
  const double H = 2e-6;
  const VolumeParameters of = volume_parameters(straight_curve(10000, H));
  // Triangles with the sides p and H p; sums of 10000 points for the integrals.
  EXPECT_NEAR(of.Vmp_m, H * 0.1 * 0.1 / 2, 1e-6 * H);
  EXPECT_NEAR(of.Vmc_m, H * (0.8 * 0.8 - 0.1 * 0.1) / 2, 1e-6 * H);
  EXPECT_NEAR(of.Vvc_m, H * (0.9 * 0.9 - 0.2 * 0.2) / 2, 1e-6 * H);
  EXPECT_NEAR(of.Vvv_m, H * 0.2 * 0.2 / 2, 1e-6 * H);
  EXPECT_NEAR(material_ratio_at_depth(straight_curve(10000, H), 0.05, 0.5e-6), 0.05 + 0.25, 1e-9);
  EXPECT_THROW(volume_parameters(straight_curve(100, H), 0.8, 0.1), InputError);
}

TEST(MaterialRatio, TheOilOfValleysIsTheirTriangle) {
  // A plateau of a tenth of the height over 80 % of the area, and valleys that fall straight to the full depth.
  std::vector<double> z;
  for (int i = 0; i < 10000; ++i) {
    const double ratio = (i + 0.5) / 10000;
    z.push_back(ratio < 0.8 ? -1e-7 * ratio / 0.8 : -1e-7 - 9e-7 * (ratio - 0.8) / 0.2);
  }
  const CoreRoughness core = core_roughness(z);
  // The core line continues the plateau to 100 %, at -1.25e-7; below it the valleys hold the triangle to -1e-6.
  EXPECT_NEAR(core.lower_m, -1.25e-7, 1e-10);
  const double area = (1e-6 - 1.25e-7) / 2 * (1 - core.Mr2);
  EXPECT_NEAR(oil_retention_volume(core), area, 1e-3 * area);
}

}  // namespace
}  // namespace ringfilm::surface
