#include "ringfilm/surface/asperity/scale.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

TEST(Scale, CutOffsDoubleFromTwoAndAHalfStepsToATenthOfTheMap) {
  const HeightMap map = map_of(400, 300, 1e-6, 2e-6, [](double x, double y) { return x * y; });
  const std::vector<double> cutoffs = short_cutoffs(map);
  ASSERT_EQ(cutoffs.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(cutoffs[i], std::ldexp(5e-6, static_cast<int>(i)));
}

TEST(Scale, AFilteredGaussianFieldHasTheMomentsOfItsSmoothedAutocorrelation) {
  // A Gaussian spectrum under a Gaussian filter stays one: l^2 grows by 2 ln 2 (cutoff/pi)^2, and m0 falls as 1/l^2.
  const double l = 10e-6;
  const HeightMap map = gaussian_surface({600, 600, 1e-6, 1e-6}, gaussian_correlation(l, l), 1e-6, 2);
  const std::vector<ScaleRow> rows = scale_table(map, {20e-6, 40e-6});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].short_cutoff_m, 0);
  for (const ScaleRow& row : rows) {
    const double c = row.short_cutoff_m, l2 = l * l + 2 * std::log(2.0) * c * c / (std::numbers::pi * std::numbers::pi);
    const double m0 = 1e-12 * l * l / l2, patches = std::sqrt(std::numbers::pi * l2) / 600e-6;
    // 5 sigma of the map, differences of (h/l)^2 and what the ends of the filter add along the edge.
    const double tolerance = 5 * patches + 1e-12 / l2 + c / 600e-6;
    EXPECT_NEAR(row.Sq_m * row.Sq_m / m0, 1, tolerance) << c;
    EXPECT_NEAR(row.moments.m2 / (2 * m0 / l2), 1, tolerance) << c;
    EXPECT_NEAR(row.moments.m4_per_m2 / (12 * m0 / (l2 * l2)), 1, tolerance) << c;
    EXPECT_NEAR(row.density_per_m2 / (6 / l2 / (6 * std::numbers::pi * std::sqrt(3.0))), 1, tolerance) << c;
    EXPECT_GT(row.summit_density_per_m2 / row.density_per_m2, 1 - 2 * tolerance);
    EXPECT_NEAR(row.Sdq, std::sqrt(2 * row.moments.m2), 1e-12);
  }
  EXPECT_LT(rows[2].density_per_m2, 0.5 * rows[0].density_per_m2);
  EXPECT_GT(rows[2].beta_m, 2 * rows[0].beta_m);
}

TEST(Scale, WorksOnAProfileAndRefusesCutOffsBeyondIt) {
  const HeightMap profile = gaussian_surface({1000, 1, 1e-6, 1e-6}, gaussian_correlation(5e-6, 1e-6), 1e-6, 2);
  EXPECT_EQ(scale_table(profile, short_cutoffs(profile)).size(), 1 + short_cutoffs(profile).size());
  EXPECT_EQ(scale_table(profile, {}).front().summit_density_per_m2, 0);
  EXPECT_THROW(scale_table(profile, {1e-6}), InputError);
  EXPECT_THROW(scale_table(profile, {2e-3}), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
