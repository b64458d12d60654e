#include "ringfilm/surface/synthetic/synthetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/random_numbers.hpp"
#include "ringfilm/surface/topography/grid_transform.hpp"
#include "ringfilm/surface/topography/material_ratio.hpp"
#include "ringfilm/surface/topography/roughness.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

TEST(RandomNumbers, AreEvenNormalAndTheSameForASeed) {
  RandomNumbers random(42), again(42), other(43);
  const int count = 200000;
  double sum = 0, squares = 0, fourths = 0, even = 0;
  for (int i = 0; i < count; ++i) {
    const double z = random.normal();
    EXPECT_EQ(z, again.normal());
    sum += z;
    squares += z * z;
    fourths += z * z * z * z;
    even += other.uniform();
  }
  // 5 sigma: variances 1, 2, 96 and 1/12 over the count.
  EXPECT_NEAR(sum / count, 0, 5 * std::sqrt(1.0 / count));
  EXPECT_NEAR(squares / count, 1, 5 * std::sqrt(2.0 / count));
  EXPECT_NEAR(fourths / count, 3, 5 * std::sqrt(96.0 / count));
  EXPECT_NEAR(even / count, 0.5, 5 * std::sqrt(1.0 / 12 / count));
}

TEST(GridTransform, GoesThereAndBackForEvenAndOddSizes) {
  for (const auto& [nx, ny] : {std::pair<std::size_t, std::size_t>{12, 10}, {15, 9}, {10, 1}, {9, 4}, {6, 5}}) {
    std::vector<double> values(nx * ny);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<double>(i * i));
    const auto waves = waves_of(values, nx, ny);
    const std::vector<double> back = values_of(waves, nx, ny);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(back[i], values[i], 1e-14);
    // One wave by its plain sum.
    const std::size_t m = 2, k = ny > 1 ? 3 : 0;
    std::complex<double> sum = 0;
    for (std::size_t j = 0; j < ny; ++j) {
      for (std::size_t i = 0; i < nx; ++i) {
        sum += values[j * nx + i] * std::polar(1.0, -2 * std::numbers::pi *
                                                        (static_cast<double>(m * i) / static_cast<double>(nx) +
                                                         static_cast<double>(k * j) / static_cast<double>(ny)));
      }
    }
    EXPECT_NEAR(std::abs(waves[k * (nx / 2 + 1) + m] - sum), 0, 1e-12);
  }
  EXPECT_EQ(wave_number(3, 8), 3);
  EXPECT_EQ(wave_number(7, 8), -1);
}

TEST(Synthetic, ASeedGivesTheSameSurfaceAndAnotherSeedAnother) {
  const SurfaceGrid grid{60, 48, 1e-6, 1e-6};
  const PowerSpectrum spectrum = self_affine(0.7, 20e-6, 3e-6);
  const HeightMap a = gaussian_surface(grid, spectrum, 1e-6, 5), b = gaussian_surface(grid, spectrum, 1e-6, 5);
  EXPECT_EQ(a.height_m, b.height_m);
  EXPECT_NE(a.height_m, gaussian_surface(grid, spectrum, 1e-6, 6).height_m);
}

TEST(Synthetic, ExactRmsIsExactAndExpectedRmsHoldsOverSeeds) {
  const SurfaceGrid grid{97, 64, 1e-6, 2e-6};  // 97 is cut out of 100
  const PowerSpectrum spectrum = gaussian_correlation(4e-6, 6e-6);
  const HeightStatistics exact = height_statistics(gaussian_surface(grid, spectrum, 0.3e-6, 1, RmsDefinition::exact));
  EXPECT_NEAR(exact.Sq_m, 0.3e-6, 1e-20);
  EXPECT_NEAR(exact.mean_m, 0, 1e-20);
  double squares = 0;
  const int seeds = 40;
  for (int seed = 0; seed < seeds; ++seed) {
    const HeightMap map = gaussian_surface(grid, spectrum, 0.3e-6, static_cast<std::uint64_t>(seed));
    for (const double height : map.height_m) squares += height * height / 0.09e-12;
  }
  // Independent patches: area over pi l_x l_y, of relative variance 1 each with the factor of a squared Gaussian.
  const double area = 97e-6 * 128e-6, spread = std::sqrt(std::numbers::pi * 24e-12 / area / seeds);
  EXPECT_NEAR(squares / seeds / (97 * 64), 1, 5 * spread);
}

TEST(Synthetic, TheAutocorrelationIsTheOneAskedFor) {
  const std::size_t n = 512;
  const double l = 10;
  const HeightMap map = gaussian_surface({n, n, 1e-6, 1e-6}, gaussian_correlation(l * 1e-6, 2 * l * 1e-6), 1, 3);
  const double spread = std::sqrt(std::numbers::pi * 2 * l * l / static_cast<double>(n * n));
  for (const auto& [dx, dy] : {std::pair<std::size_t, std::size_t>{5, 0}, {10, 0}, {0, 10}, {0, 20}, {7, 14}}) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        sum += map.height_m[map.index(i, j)] * map.height_m[map.index((i + dx) % n, (j + dy) % n)];
      }
    }
    const double r = static_cast<double>(dx * dx) / (l * l) + static_cast<double>(dy * dy) / (4 * l * l);
    EXPECT_NEAR(sum / static_cast<double>(n * n), std::exp(-r), 5 * spread) << dx << " " << dy;
  }
}

TEST(Synthetic, AHonedSurfaceHasGroovesUnderItsPlateau) {
  HonedSurface of;
  of.plateau_Sq_m = 0.02e-6;
  const HeightMap map = honed_surface({512, 512, 1e-6, 1e-6}, of, 4);
  const std::vector<double> curve = material_ratio_curve(map);
  const auto two = probability_roughness(curve);
  ASSERT_TRUE(two);
  EXPECT_GT(two->Rvq_m, 5 * two->Rpq_m);
  // One family leaves 1 - 12/60 of the area free, two leave its square, 64 %; some 10 grooves of even spacing cross
  // each line of the map, each standing for itself.
  EXPECT_NEAR(cavities(curve, CavityRule::below_depth, 0.08e-6).area_share, 0.36 * (1 - 0.08 / 2), 0.08);
  // Grooves rise by half of the hatch angle along x: a slope across of depth over half width, with both families alike.
  double squares_x = 0, squares_y = 0;
  for (std::size_t j = 0; j + 1 < 512; ++j) {
    for (std::size_t i = 0; i + 1 < 512; ++i) {
      const double z = map.height_m[map.index(i, j)];
      squares_x += std::pow(map.height_m[map.index(i + 1, j)] - z, 2);
      squares_y += std::pow(map.height_m[map.index(i, j + 1)] - z, 2);
    }
  }
  EXPECT_NEAR(std::sqrt(squares_x / squares_y), std::tan(0.4), 0.05);
}

TEST(Synthetic, APorousFaceHasItsShareOfPoresToAPoint) {
  PorousSurface of;
  const PorousMap made = porous_surface({300, 200, 1e-6, 1e-6}, of, 8);
  EXPECT_EQ(std::count(made.pore.begin(), made.pore.end(), 1), 9000);
  // The pores lie 4 um below the face on average.
  double in = 0, out = 0;
  for (std::size_t i = 0; i < made.map.points(); ++i) (made.pore[i] ? in : out) += made.map.height_m[i];
  EXPECT_NEAR(out / 51000 - in / 9000, 4e-6, 5 * 0.3e-6 * std::sqrt(std::numbers::pi * 9 / 9000));
  of.fine_Sq_m = 0.05e-6;
  const PorousMap smooth = porous_surface({300, 200, 1e-6, 1e-6}, of, 8);
  const Cavities found = cavities(material_ratio_curve(smooth.map), CavityRule::below_plateau);
  EXPECT_NEAR(found.area_share, 0.15, 0.01);  // shallow rims of pores, and the 0.1 % beyond 3 sigma
  of.pore_share = 0;
  EXPECT_NO_THROW(porous_surface({30, 20, 1e-6, 1e-6}, of, 8));
}

TEST(Synthetic, WhatIsNotASurfaceIsRefused) {
  const PowerSpectrum spectrum = gaussian_correlation(1e-6, 1e-6);
  EXPECT_THROW(gaussian_surface({1, 10, 1e-6, 1e-6}, spectrum, 1e-6, 1), InputError);
  EXPECT_THROW(gaussian_surface({1u << 20, 1u << 20, 1e-6, 1e-6}, spectrum, 1e-6, 1), InputError);
  EXPECT_THROW(gaussian_surface({10, 10, 0, 1e-6}, spectrum, 1e-6, 1), InputError);
  EXPECT_THROW(gaussian_surface({10, 10, 1e-6, 1e-6}, spectrum, 0, 1), InputError);
  EXPECT_THROW(gaussian_surface(
                   {10, 10, 1e-6, 1e-6}, [](double, double) { return 0.0; }, 1, 1),
               InputError);
  EXPECT_THROW(gaussian_surface(
                   {10, 10, 1e-6, 1e-6}, [](double, double) { return -1.0; }, 1, 1),
               InputError);
  EXPECT_THROW(self_affine(1.5, 1e-5, 1e-6), InputError);
  EXPECT_THROW(gaussian_correlation(0, 1e-6), InputError);
  HonedSurface honed;
  honed.groove_spacing_m = 1e-15;
  EXPECT_THROW(honed_surface({10, 10, 1e-6, 1e-6}, honed, 1), InputError);
  PorousSurface porous;
  porous.pore_share = 0.95;
  EXPECT_THROW(porous_surface({10, 10, 1e-6, 1e-6}, porous, 1), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
