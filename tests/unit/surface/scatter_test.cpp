#include "ringfilm/surface/asperity/scatter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "ringfilm/surface/topography/regions.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Regions, OfAGridFillTheMap) {
  const HeightMap map = map_of(100, 62, 1e-6, 1e-6, [](double x, double y) { return x + y; });
  const std::vector<Region> regions = grid_regions(map, 4, 3);
  ASSERT_EQ(regions.size(), 12u);
  EXPECT_EQ(regions[5].column, 25u);
  EXPECT_EQ(regions[5].row, 20u);
  EXPECT_EQ(regions[5].columns, 25u);
  EXPECT_EQ(regions[5].rows, 20u);
  const HeightMap part = part_of_map(map, regions[5]);
  EXPECT_DOUBLE_EQ(part.height_m[0], 45e-6);
  EXPECT_DOUBLE_EQ(part.height_m.back(), (49 + 39) * 1e-6);
  EXPECT_THROW(grid_regions(map, 13, 1), InputError);
  EXPECT_THROW(grid_regions(map, 0, 1), InputError);
}

TEST(Regions, InMetresLieOnThePointsInside) {
  const HeightMap map = map_of(100, 50, 2e-6, 1e-6, [](double x, double y) { return x + y; });
  const Region region = region_in_metres(map, 20e-6, 5e-6, 100e-6, 45e-6);
  EXPECT_EQ(region.column, 10u);
  EXPECT_EQ(region.columns, 50u);
  EXPECT_EQ(region.row, 5u);
  EXPECT_EQ(region.rows, 45u);
  EXPECT_THAT([&] { region_in_metres(map, 20e-6, 5e-6, 100e-6, 46e-6); },
              ThrowsMessage<InputError>(HasSubstr("does not lie on the map")));
  EXPECT_THROW(region_in_metres(map, -2e-6, 0, 10e-6, 10e-6), InputError);
  EXPECT_THROW(region_in_metres(map, NAN, 0, 10e-6, 10e-6), InputError);
  EXPECT_THROW(part_of_map(map, {90, 0, 11, 1, 0}), InputError);
}

TEST(Regions, TheMostProminentAreProposedFirstAndApart) {
  HeightMap map = map_of(200, 120, 1e-6, 1e-6, [](double x, double y) {
    const auto hill = [&](double at_x, double at_y, double height) {
      return height * std::exp(-(std::pow(x - at_x, 2) + std::pow(y - at_y, 2)) / 50e-12);
    };
    return hill(150e-6, 30e-6, 3e-6) + hill(40e-6, 90e-6, 2e-6) + hill(100e-6, 60e-6, 1e-6);
  });
  const std::vector<Region> regions = prominent_regions(map, 3, 40, 40);
  ASSERT_EQ(regions.size(), 3u);
  const double expected[3][2] = {{150, 30}, {40, 90}, {100, 60}};
  for (std::size_t n = 0; n < 3; ++n) {
    // The hill lies inside its region, at the 10 points of the grid of places from the middle at most.
    EXPECT_NEAR(static_cast<double>(regions[n].column) + 20, expected[n][0], 10) << n;
    EXPECT_NEAR(static_cast<double>(regions[n].row) + 20, expected[n][1], 10) << n;
    if (n == 0) continue;
    EXPECT_LT(regions[n].prominence_m, regions[n - 1].prominence_m);
  }
  const std::vector<Region> all = prominent_regions(map, 1000, 40, 40);
  EXPECT_GE(all.size(), 6u);
  EXPECT_LE(all.size(), 15u);  // no more have room
  std::vector<int> taken(map.points(), 0);
  for (const Region& of : all) {
    for (std::size_t j = of.row; j < of.row + 40; ++j) {
      for (std::size_t i = of.column; i < of.column + 40; ++i) EXPECT_EQ(++taken.at(map.index(i, j)), 1);
    }
  }
  map.missing.assign(map.points(), 0);
  for (std::size_t j = 0; j < 60; ++j) {
    for (std::size_t i = 120; i < 200; ++i) map.missing[map.index(i, j)] = 1;
  }
  EXPECT_NEAR(static_cast<double>(prominent_regions(map, 1, 40, 40)[0].column) + 20, 40, 10);
  EXPECT_THROW(prominent_regions(map, 1, 201, 40), InputError);
}

TEST(Scatter, OfThreeSamplesIsWhatAHandComputes) {
  const std::vector<AsperityParameters> samples{{1e11, 1e-6, 0.4e-6}, {2e11, 2e-6, 0.4e-6}, {4e11, 1e-6, 0.4e-6}};
  const ParameterScatter of = scatter_of(samples);
  EXPECT_EQ(of.count, 3u);
  EXPECT_NEAR(of.mean[0], 7e11 / 3, 1);
  EXPECT_NEAR(of.covariance[0][0] / 1e22, 7.0 / 3, 1e-12);  // of 1, 2, 4
  EXPECT_NEAR(of.covariance[0][1] / 1e5, -1.0 / 6, 1e-12);
  const double log2 = std::log(2.0);
  EXPECT_NEAR(of.covariance_log[0][0], log2 * log2, 1e-12);
  EXPECT_NEAR(of.covariance_log[1][1], log2 * log2 / 3, 1e-12);
  EXPECT_NEAR(of.covariance_log[0][1], 0, 1e-12);
  EXPECT_NEAR(of.mean_log[0], std::log(2e11), 1e-12);
  EXPECT_NEAR(of.relative_standard_error(0), log2 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ(of.correlation(0, 2), 0);
  EXPECT_NEAR(of.correlation(1, 1), 1, 1e-12);
  EXPECT_THROW(scatter_of(std::vector<AsperityParameters>(1, samples[0])), InputError);
  EXPECT_THROW(scatter_of(std::vector<AsperityParameters>(2, {1e11, 0, 1e-6})), InputError);
}

TEST(Scatter, OfAPairAddsUpWhatEachSurfaceBrings) {
  const SurfaceMeasures a{1, 2, {1, 0.01, 1e10}}, b{1, 2, {1, 0.03, 3e10}}, c{2, 3, {1, 0.02, 2e10}};
  const std::vector<SurfaceMeasures> ring{a, b}, liner{c};
  const PairScatter of = scatter_of_pair(ring, liner, SigmaRule::ra);
  EXPECT_EQ(of.without_scatter, "second");
  // Mean of the ring: m2 0.02, m4 2e10: the pair 0.04 and 4e10, N the same in all, beta as m4 to the power -1/2.
  EXPECT_NEAR(of.central.density_per_m2, 1e12 / 32.6483886, 1e3);
  EXPECT_NEAR(of.central.sigma_m, std::sqrt(5.0), 1e-12);
  const double half = 0.5 * std::log(3e10 / 5e10) / 2;  // distance of log beta from its mean
  EXPECT_NEAR(of.covariance_log[1][1], 2 * half * half, 1e-12);
  EXPECT_NEAR(of.mean_covariance_log[1][1], half * half, 1e-12);
  EXPECT_NEAR(of.covariance_log[0][0], 0, 1e-12);
  const PairScatter turned = scatter_of_pair(liner, ring, SigmaRule::ra);
  EXPECT_NEAR(turned.covariance_log[1][1], of.covariance_log[1][1], 1e-15);
  EXPECT_EQ(turned.without_scatter, "first");
  EXPECT_THROW(scatter_of_pair({}, liner, SigmaRule::ra), InputError);
}

TEST(Scatter, OfRegionsOfAGaussianFieldIsTheSamplingErrorOfTheory) {
  // 64 regions of 100 x 100 points, l = 5: sd(m0)/m0 = sqrt(pi l^2/area), half of it for Sq; m4: sqrt(0.7292) of it,
  // half for beta.
  const double l = 5;
  const HeightMap map = gaussian_surface({800, 800, 1e-6, 1e-6}, gaussian_correlation(l * 1e-6, l * 1e-6), 1e-6, 12);
  std::vector<AsperityParameters> samples;
  for (const Region& region : grid_regions(map, 8, 8)) {
    samples.push_back(single_parameters(surface_measures(part_of_map(map, region), MomentDirection::x), SigmaRule::rq));
  }
  const ParameterScatter of = scatter_of(samples);
  const double patches = std::sqrt(std::numbers::pi * l * l / 1e4);
  // A standard deviation from 64 samples is known to 1/sqrt(126): 9 %; 5 sigma of it would pass 45 %, taken are 4.
  EXPECT_NEAR(std::sqrt(of.covariance_log[2][2]) / (0.5 * patches), 1, 0.36);
  EXPECT_NEAR(std::sqrt(of.covariance_log[1][1]) / (0.5 * std::sqrt(0.7292) * patches), 1, 0.36);
  EXPECT_LT(of.correlation(1, 2), 0);  // rougher regions have sharper summits
}

}  // namespace
}  // namespace ringfilm::surface
