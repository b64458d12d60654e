#include "ringfilm/surface/asperity/asperities.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/asperity/summits.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "ringfilm/surface/synthetic/target_surface.hpp"
#include "ringfilm/surface/topography/form.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Asperities, OfAPairFollowTheEquationsOfThePaper) {
  const SurfaceMeasures ring{0.41e-6, 0.52e-6, {0.27e-12, 0.03, 1.1e11}},
      liner{0.26e-6, 0.33e-6, {0.11e-12, 0.02, 0.7e11}};
  const AsperityParameters by_ra = pair_parameters(ring, liner, SigmaRule::ra);
  // (1) as corrected, (2), with the sums of (3) and (4), by hand: 1.8e11/0.05/32.6484 and 3 sqrt(pi)/8/sqrt(1.8e11).
  EXPECT_NEAR(by_ra.density_per_m2, 1.102654e11, 1e6);
  EXPECT_NEAR(by_ra.beta_m, 1.566643e-6, 1e-12);
  EXPECT_NEAR(by_ra.sigma_m, std::sqrt(0.41 * 0.41 + 0.26 * 0.26) * 1e-6, 1e-20);
  EXPECT_NEAR(pair_parameters(ring, liner, SigmaRule::rq).sigma_m, std::sqrt(0.52 * 0.52 + 0.33 * 0.33) * 1e-6, 1e-20);
  EXPECT_DOUBLE_EQ(by_ra.roughness_parameter(), by_ra.density_per_m2 * by_ra.beta_m * by_ra.sigma_m);
  EXPECT_DOUBLE_EQ(by_ra.slope(), by_ra.sigma_m / by_ra.beta_m);
  EXPECT_THAT(sigma_text(SigmaRule::ra), HasSubstr("Ra"));
  const SpectralMoments back = moments_of(by_ra.density_per_m2, by_ra.beta_m);
  EXPECT_NEAR(back.m2, 0.05, 1e-15);
  EXPECT_NEAR(back.m4_per_m2, 1.8e11, 1e-3);
}

TEST(Asperities, OfFlatSurfacesAreRefused) {
  EXPECT_THAT(
      [] {
        asperity_parameters({1e-12, 0.01, 0}, 1e-6);
      },
      ThrowsMessage<InputError>(HasSubstr("the radius of its asperities infinite")));
  EXPECT_THROW(asperity_parameters({1e-12, 0, 1e11}, 1e-6), InputError);
  EXPECT_THROW(asperity_parameters({1e-12, 0.01, INFINITY}, 1e-6), InputError);
  EXPECT_THROW(asperity_parameters({1e-12, 0.01, 1e11}, 0), InputError);
  EXPECT_THROW(moments_of(0, 1e-6), InputError);
  EXPECT_THROW(surface_measures(map_of(40, 40, 1e-6, 1e-6, [](double, double) { return 0.0; })), InputError);
}

TEST(Summits, OfAnEggBoxAreCountedOneByOne) {
  // Crests on every tenth point: 10 x 8 of them inside, each of curvature a k^2.
  const double a = 1e-6, k = 2 * std::numbers::pi / 10e-6;
  const HeightMap map = map_of(101, 81, 1e-6, 1e-6, [&](double x, double y) {
    return a * (std::cos(k * (x - 5e-6)) + std::cos(k * (y - 5e-6)));
  });
  const Summits of = count_summits(map);
  EXPECT_EQ(of.count, 80u);
  EXPECT_NEAR(of.density_per_m2, 80 / (99e-6 * 79e-6), 1);
  EXPECT_NEAR(of.mean_curvature_per_m, a * 2 * (1 - std::cos(k * 1e-6)) / 1e-12, 1e-6);
  EXPECT_NEAR(of.mean_height_m, 2 * a, 0.1 * a);  // the mean of the map holds half a wave too much
  EXPECT_NEAR(of.rms_height_m, 0, 1e-13);
}

TEST(Summits, OnLevelTopsAndBesideMissingPointsAreNone) {
  HeightMap map = map_of(9, 9, 1e-6, 1e-6, [](double, double) { return 0.0; });
  map.height_m[map.index(2, 2)] = 1e-6;
  map.height_m[map.index(6, 6)] = map.height_m[map.index(7, 6)] = 1e-6;  // a level top
  EXPECT_EQ(count_summits(map).count, 1u);
  map.height_m[map.index(4, 4)] = 1e-6;
  map.missing.assign(81, 0);
  map.missing[map.index(3, 3)] = 1;
  map.missing[map.index(1, 1)] = 1;
  EXPECT_EQ(count_summits(map).count, 0u);
  EXPECT_EQ(count_summits(map).mean_radius_m, 0);
  EXPECT_THROW(count_summits(map_of(50, 1, 1e-6, 0, [](double x, double) { return std::sin(x * 1e6); })), InputError);
}

TEST(Summits, AreHigherThanEachOfTheEightNeighbours) {
  for (const int dx : {-1, 0, 1}) {
    for (const int dy : {-1, 0, 1}) {
      if (dx == 0 && dy == 0) continue;
      HeightMap map = map_of(9, 9, 1e-6, 1e-6, [](double, double) { return 0.0; });
      map.height_m[map.index(4, 4)] = 1e-6;
      map.height_m[map.index(4 + dx, 4 + dy)] = 2e-6;  // the only summit
      EXPECT_EQ(count_summits(map).count, 1u) << dx << " " << dy;
    }
  }
}

TEST(Summits, OfAGaussianFieldFollowNayak) {
  // l = 14 steps: summits lie some 7 l^2 steps apart, so that eight neighbours see nearly all of them.
  const double l = 14, points = 1500;
  const SurfaceGrid grid{1500, 1500, 1e-6, 1e-6};
  const HeightMap map = gaussian_surface(grid, gaussian_correlation(l * 1e-6, l * 1e-6), 1e-6, 5);
  const Summits of = count_summits(map);
  // m0, m2, m4 of the autocorrelation itself: 1, 2/l^2, 12/l^4.
  const SummitTheory theory = summit_theory(1e-12, 2 / (l * l), 12 / (l * l * l * l) * 1e12);
  EXPECT_NEAR(theory.bandwidth, 3, 1e-12);
  EXPECT_NEAR(theory.density_per_m2, 6 / (l * l) * 1e12 / (6 * std::numbers::pi * std::sqrt(3.0)), 1);
  // Some 2100 summits: 5 sigma of counting (they repel each other: less than Poisson's), 2 % of discreteness.
  const double counting = 5 / std::sqrt(points * points * 0.1838 / (l * l));
  EXPECT_NEAR(of.density_per_m2 / theory.density_per_m2, 1, counting + 0.02);
  EXPECT_NEAR(of.mean_curvature_per_m / theory.mean_curvature_per_m, 1, 0.5 * counting + 0.02);
  EXPECT_NEAR(of.mean_height_m / theory.mean_height_m, 1, counting);
  EXPECT_NEAR(of.rms_height_m / theory.rms_height_m, 1, counting);
  // N and beta of the moments state the same of an isotropic Gaussian surface.
  const AsperityParameters parameters = single_parameters(surface_measures(map), SigmaRule::rq);
  EXPECT_NEAR(parameters.density_per_m2 / theory.density_per_m2, 1, 0.05);
  EXPECT_NEAR(parameters.beta_m * theory.mean_curvature_per_m, 1, 0.05);
}

TEST(Summits, OfAPairAreThoseOfTheSum) {
  const SurfaceGrid grid{300, 280, 1e-6, 1e-6};
  const HeightMap first = gaussian_surface(grid, gaussian_correlation(8e-6, 8e-6), 1e-6, 1);
  HeightMap second = gaussian_surface({290, 300, 1e-6, 1e-6}, gaussian_correlation(6e-6, 6e-6), 1e-6, 2);
  const Summits of = count_summits_of_pair(first, second);
  HeightMap sum = map_of(290, 280, 1e-6, 1e-6, [](double, double) { return 0.0; });
  for (std::size_t j = 0; j < 280; ++j) {
    for (std::size_t i = 0; i < 290; ++i)
      sum.height_m[j * 290 + i] = first.height_m[j * 300 + i] + second.height_m[j * 290 + i];
  }
  EXPECT_EQ(of.count, count_summits(sum).count);
  second.step_x_m = 2e-6;
  EXPECT_THAT([&] { count_summits_of_pair(first, second); },
              ThrowsMessage<InputError>(HasSubstr("steps of the two maps differ")));
}

struct Row {
  const char* name;
  AsperityParameters pair;
};

/// Table 1 of styles2014.
const Row kTable[] = {{"new", {0.097e12, 1.56e-6, 0.48e-6}},
                      {"run-in", {0.100e12, 1.34e-6, 0.50e-6}},
                      {"embedded", {0.101e12, 1.82e-6, 0.35e-6}}};

TEST(TargetSurface, RingsAndALinerGiveTheTableOfThePaperBack) {
  const SurfaceGrid grid{256, 256, 0.2e-6, 0.2e-6};
  for (const SigmaRule rule : {SigmaRule::ra, SigmaRule::rq}) {
    // The liner has its own Ra of 0.26 um; the moments of all pairs leave it half of the smallest.
    const TargetSurface liner{rule, 0.26e-6, 0.02, 0.66e11};
    const auto measuring = [](const HeightMap& made) {
      HeightMap map = made;
      remove_form(map, {FormKind::tilt, 1});
      return surface_measures(map);
    };
    const SurfaceMeasures of_liner = measuring(surface_with(liner, grid, 10, measuring));
    for (const Row& row : kTable) {
      const HeightMap ring = surface_with(counterpart(row.pair, liner), grid, 11, measuring);
      const AsperityParameters found = pair_parameters(measuring(ring), of_liner, rule);
      EXPECT_NEAR(found.density_per_m2 / row.pair.density_per_m2, 1, 1e-9) << row.name;
      EXPECT_NEAR(found.beta_m / row.pair.beta_m, 1, 1e-9) << row.name;
      EXPECT_NEAR(found.sigma_m / row.pair.sigma_m, 1, 1e-9) << row.name;
    }
  }
}

TEST(TargetSurface, WhatNoSpectrumHasIsRefused) {
  const SurfaceGrid grid{64, 64, 0.2e-6, 0.2e-6};
  // rms^2 m4/m2^2 = 2: narrower than any self-affine band.
  EXPECT_THAT(
      [&] {
        surface_with({SigmaRule::rq, 0.1e-6, 0.05, 2 * 0.0025 / 1e-14}, grid, 1);
      },
      ThrowsMessage<InputError>(HasSubstr("no surface with the target")));
  EXPECT_THROW(surface_with({SigmaRule::rq, 0.1e-6, 0, 1e11}, grid, 1), InputError);
  EXPECT_THROW(counterpart({1e11, 1e-6, 0.2e-6}, {SigmaRule::ra, 0.3e-6, 0.01, 1e10}), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
