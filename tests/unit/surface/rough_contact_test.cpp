#include "ringfilm/surface/contact/rough_contact.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/contact/contact_law.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using std::numbers::pi;

// E* = 1 Pa, wave length 1 m, amplitude 1: heights of D cos(2 pi x) have the mean pressure p* = pi E* D at full
// contact.
constexpr double kAmplitude = 0.01;
constexpr double kFull = pi * kAmplitude;

HeightMap wave(std::size_t points, double offset = 0) {
  const double step = 1 / static_cast<double>(points);
  return map_of(points, 1, step, step,
                [&](double x, double) { return kAmplitude * std::cos(2 * pi * (x + offset * step)); });
}

/// Mean pressure of a wave in contact with this share P of p* is at the separation D (1 - P + P ln P)
/// (@cite johnson1985, section 13.2, from Westergaard 1939).
double westergaard_separation(double P) { return kAmplitude * (1 - P + P * std::log(P)); }
double westergaard_area(double P) { return 2 / pi * std::asin(std::sqrt(P)); }

TEST(RoughContact, AWaveCarriesWhatWestergaardFound) {
  for (const MapEdges edges : {MapEdges::periodic, MapEdges::mirrored}) {
    for (const double P : {0.05, 0.2, 0.5}) {
      // Of mirror images the wave is even about both ends when it begins half a step after its crest.
      RoughContact contact(wave(1024, edges == MapEdges::mirrored ? 0.5 : 0), edges, {1, {}});
      const ContactAtSeparation found = contact.solve(westergaard_separation(P));
      EXPECT_NEAR(found.pressure / (P * kFull), 1, 2e-5);
      EXPECT_NEAR(found.area_share, westergaard_area(P), 1.0 / 1024);  // half a step at both edges of the spot
      const double peak = *std::max_element(contact.pressure().begin(), contact.pressure().end());
      EXPECT_NEAR(peak / kFull, 2 * std::sqrt(P), 1e-3);
      EXPECT_LT(found.residual, 1e-6);
    }
  }
}

TEST(RoughContact, ThePressureOfAWaveConvergesWithTheStep) {
  double former = 0;
  for (const std::size_t points : {64, 128, 256, 512}) {
    // The mean over places of the wave between the points: the error of one depends on where the spot ends.
    double error = 0;
    constexpr int kPlaces = 16;
    for (int k = 0; k < kPlaces; ++k) {
      RoughContact contact(wave(points, k / static_cast<double>(kPlaces)), MapEdges::periodic, {1, {}});
      error += std::abs(contact.solve(westergaard_separation(0.2)).pressure / (0.2 * kFull) - 1) / kPlaces;
    }
    if (former > 0) {
      EXPECT_GT(std::log2(former / error), 1.5) << points;
    }
    former = error;
  }
  EXPECT_LT(former, 2e-4);
}

/// Clausen's function sum sin(k x)/k^2.
double clausen(double x) {
  double sum = 0;
  for (int k = 1; k < 20000; ++k) sum += std::sin(k * x) / (static_cast<double>(k) * k);
  return sum;
}

TEST(RoughContact, AWaveOfSoftMaterialIsPlasticAllOver) {
  // Where |x| < a the pressure is H; the displacement there ends at the separation: h/D - cos 2 pi a + (H/p*)/pi
  // Cl2(4 pi a) = 0, of which h/D = 0.5, H/p* = 0.1 has 2 a = 0.3250226.
  const double a = 0.3250226 / 2;
  ASSERT_NEAR(0.5 - std::cos(2 * pi * a) + 0.1 / pi * clausen(4 * pi * a), 0, 1e-6);
  RoughContact contact(wave(2048), MapEdges::periodic, {1, 0.1 * kFull});
  const ContactAtSeparation found = contact.solve(0.5 * kAmplitude);
  EXPECT_NEAR(found.pressure / (0.1 * kFull), 2 * a, 1.0 / 2048);  // half a step at both edges
  EXPECT_NEAR(found.area_share, 2 * a, 1.0 / 2048);
  EXPECT_GT(found.share_at_cap, 0.99);
}

TEST(RoughContact, ARowOfFlatPunchesHasItsPressureAndDepth) {
  // Punches of half width a with the period 1: p(0) = p_mean/sin(pi a), flat faces below the mean plane by
  // -(2/(pi E*)) p_mean ln sin(pi a) (@cite johnson1985).
  constexpr double kHalfWidth = 0.2;
  for (const std::size_t points : {500, 2000}) {
    const double step = 1 / static_cast<double>(points);
    const HeightMap map =
        map_of(points, 1, step, step, [&](double x, double) { return std::min(x, 1 - x) < kHalfWidth ? 1e-3 : -1.0; });
    RoughContact contact(map, MapEdges::periodic, {1, {}});
    const double h = contact.highest_m() - 1e-4;
    const ContactAtSeparation found = contact.solve(h);
    // Effective edges lie half a step beyond the last point: the order of the step.
    const double a = kHalfWidth;
    EXPECT_NEAR(1e-4 / found.pressure / (-2 / pi * std::log(std::sin(pi * a))), 1, 3.0 / static_cast<double>(points));
    EXPECT_NEAR(contact.pressure()[0] / found.pressure * std::sin(pi * a), 1, 3.0 / static_cast<double>(points));
  }
}

TEST(RoughContact, ASphereTouchesAsHertzFound) {
  // R 10 um, E* 67.4 GPa, 0.1 mN: a 0.2232546 um, p0 0.9579448 GPa, approach 4.984263 nm. In a cell of 16 a the images
  // carry their share of the displacement, which is measured from the mean plane.
  constexpr double kRadius = 10e-6, kModulus = 67.4e9, kLoad = 1e-4, a = 0.2232546e-6;
  constexpr std::size_t kPoints = 512;
  const double cell = 16 * a, step = cell / kPoints, half = cell / 2;
  const HeightMap map = map_of(kPoints, kPoints, step, step, [&](double x, double y) {
    return -((x - half) * (x - half) + (y - half) * (y - half)) / (2 * kRadius);
  });
  RoughContact contact(map, MapEdges::periodic, {kModulus, {}});
  double low = contact.highest_m() * 0.5, high = contact.highest_m();
  for (int k = 0; k < 40; ++k) {  // the separation of this load
    const double h = (low + high) / 2;
    (contact.solve(h).pressure * cell * cell > kLoad ? low : high) = h;
  }
  const ContactAtSeparation found = contact.solve(low);
  const double peak = *std::max_element(contact.pressure().begin(), contact.pressure().end());
  EXPECT_NEAR(peak / 0.9579448e9, 1, 2e-3);
  EXPECT_NEAR(found.area_share * cell * cell / (pi * a * a), 1, 1e-2);
}

HeightMap rough_map(std::size_t points, std::uint64_t seed) {
  const double step = 0.4e-6;
  return gaussian_surface({points, points, step, step}, gaussian_correlation(5e-6, 5e-6), 0.48e-6, seed);
}

TEST(RoughContact, MirrorImagesAreTheTileOfAllFour) {
  const HeightMap map = rough_map(45, 3);
  const std::size_t n = map.points_x;
  HeightMap tile{2 * n, 2 * n, map.step_x_m, map.step_y_m, std::vector<double>(4 * n * n), {}};
  for (std::size_t j = 0; j < 2 * n; ++j) {
    for (std::size_t i = 0; i < 2 * n; ++i) {
      tile.height_m[tile.index(i, j)] = map.height_m[map.index(i < n ? i : 2 * n - 1 - i, j < n ? j : 2 * n - 1 - j)];
    }
  }
  const ContactGrid small{n, n, map.step_x_m, map.step_y_m, MapEdges::mirrored};
  const ContactGrid large{2 * n, 2 * n, map.step_x_m, map.step_y_m, MapEdges::periodic};
  std::vector<double> u(n * n), of_tile(4 * n * n);
  HalfSpace(small, 1e9).displace(map.height_m, u);
  HalfSpace(large, 1e9).displace(tile.height_m, of_tile);
  const double scale = *std::max_element(u.begin(), u.end());
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(u[j * n + i], of_tile[j * 2 * n + i], 1e-12 * scale);
  }
  const ContactMaterial material{67.4e9, 2.5e9};
  RoughContact once(map, MapEdges::mirrored, material), four(tile, MapEdges::periodic, material);
  EXPECT_NEAR(once.solve(0.5e-6).pressure / four.solve(0.5e-6).pressure, 1, 1e-6);
}

TEST(RoughContact, ManyWavesTouchAsRandomSurfacesDo) {
  // kappa = A E* h'/p of a random surface with the area corrected for pixels: 2.1 to 2.4 (Yastrebov et al. 2017;
  // sqrt(8/pi) = 1.6 of Persson, sqrt(2 pi) = 2.5 of Bush, Gibson and Thomas).
  const HeightMap map = rough_map(512, 1);
  double squares = 0;
  for (std::size_t j = 0; j < 512; ++j) {
    for (std::size_t i = 0; i < 512; ++i) {
      const double z = map.height_m[map.index(i, j)];
      squares += std::pow((map.height_m[map.index((i + 1) % 512, j)] - z) / map.step_x_m, 2) +
                 std::pow((map.height_m[map.index(i, (j + 1) % 512)] - z) / map.step_y_m, 2);
    }
  }
  const double slope = std::sqrt(squares / (512.0 * 512));
  RoughContact contact(map, MapEdges::periodic, {67.4e9, {}});
  const ContactAtSeparation found = contact.solve(1.5 * contact.rms_m());
  const double kappa = found.area_share * 67.4e9 * slope / found.pressure;
  EXPECT_GT(kappa, 2.1);
  EXPECT_LT(kappa, 2.4);
}

TEST(RoughContact, SoftMaterialCarriesItsHardnessTimesTheArea) {
  const HeightMap map = rough_map(256, 2);
  constexpr double kHardness = 1e6;
  RoughContact contact(map, MapEdges::periodic, {67.4e9, kHardness});
  for (const double lambda : {0.7, 1.0, 1.5, 2.0}) {
    const double h = lambda * contact.rms_m();
    const ContactAtSeparation found = contact.solve(h);
    double above = 0;
    for (const double z : map.height_m) above += z > h ? 1 : 0;
    EXPECT_NEAR(found.pressure / (kHardness * above / 65536), 1, 2e-3) << lambda;
    EXPECT_NEAR(found.pressure / (kHardness * found.pixel_share), 1, 2e-3) << lambda;
  }
}

TEST(RoughContact, PressureFallsWithTheSeparationAndDoesNotDependOnTheStart) {
  const HeightMap map = rough_map(128, 4);
  RoughContact one(map, MapEdges::mirrored, {67.4e9, 2.5e9});
  double former = 1e300;
  for (double lambda = 0.6; lambda < 2.2; lambda += 0.2) {
    const double h = lambda * one.rms_m();
    const double p = one.solve(h).pressure;
    EXPECT_LT(p, former);
    RoughContact fresh(map, MapEdges::mirrored, {67.4e9, 2.5e9});
    EXPECT_NEAR(fresh.solve(h).pressure / p, 1, 3e-6) << lambda;
    former = p;
  }
}

TEST(RoughContact, MissingPointsNeverTouch) {
  HeightMap map = rough_map(128, 5);
  lose_points(map, 0.3, 1);
  RoughContact contact(map, MapEdges::mirrored, {67.4e9, 2.5e9});
  const ContactAtSeparation found = contact.solve(contact.rms_m());
  EXPECT_NEAR(contact.missing_share(), 0.3, 0.02);
  EXPECT_GT(found.load_next_to_missing, 0.3);
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) {
      ASSERT_EQ(contact.pressure()[i], 0.0);
    }
  }
  lose_points(map, 0.6, 1);
  EXPECT_THROW(RoughContact(map, MapEdges::mirrored, {67.4e9, 2.5e9}), InputError);
}

TEST(RoughContact, RefusesWhatItCannotSolve) {
  const HeightMap map = rough_map(64, 6);
  EXPECT_THROW(RoughContact(map, MapEdges::mirrored, {0, {}}), InputError);
  EXPECT_THROW(RoughContact(map, MapEdges::mirrored, {67.4e9, -1.0}), InputError);
  RoughContact contact(map, MapEdges::mirrored, {67.4e9, {}});
  EXPECT_THROW(contact.solve(0), InputError);
  EXPECT_EQ(contact.solve(contact.highest_m() * 1.1).pressure, 0.0);
  EXPECT_THROW(check_area(contact.solve(0.01 * contact.rms_m())), InputError);
}

TEST(ContactLaw, DoesNotDependOnWhereAPeriodicPairIsCut) {
  const HeightMap first = rough_map(64, 7), second = rough_map(64, 8);
  const auto moved = [](const HeightMap& map) {
    HeightMap to = map;
    for (std::size_t j = 0; j < 64; ++j) {
      for (std::size_t i = 0; i < 64; ++i) {
        to.height_m[map.index(i, j)] = map.height_m[map.index((i + 11) % 64, (j + 29) % 64)];
      }
    }
    return to;
  };
  const std::vector<double> separations{0.9e-6, 0.7e-6};
  const ContactMaterial material{67.4e9, 2.5e9};
  const ContactLaw one = contact_law({first, second, MapEdges::periodic, material, 1}, separations);
  const ContactLaw other = contact_law({moved(first), moved(second), MapEdges::periodic, material, 1}, separations);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(one.points[k].mean.separation_m, separations[k]);
    EXPECT_NEAR(one.points[k].mean.pressure / other.points[k].mean.pressure, 1, 1e-6);
    EXPECT_EQ(one.points[k].mean.pixel_share, other.points[k].mean.pixel_share);
    // Here p/H, and p is a sum over the points in another order.
    EXPECT_DOUBLE_EQ(one.points[k].mean.area_share, other.points[k].mean.area_share);
  }
}

TEST(ContactLaw, RelativePositionsScatterAboutTheirMean) {
  const SurfacePair pair{rough_map(96, 9), rough_map(96, 10), MapEdges::mirrored, {67.4e9, 2.5e9}, 4};
  const ContactLaw law = contact_law(pair, std::vector<double>{0.8e-6});
  SurfacePair alone = pair;
  alone.shifts = 1;
  const double of_one = contact_law(alone, std::vector<double>{0.8e-6}).points[0].mean.pressure;
  const ContactLawPoint& point = law.points[0];
  EXPECT_GT(point.pressure_deviation, 0);
  EXPECT_LT(point.pressure_deviation, 0.5 * point.mean.pressure);
  EXPECT_NEAR(of_one, point.mean.pressure, 3 * point.pressure_deviation);
}

TEST(ContactLaw, UsualSeparationsEndWhereAThirdTouches) {
  const SurfacePair pair{rough_map(96, 11), {}, MapEdges::mirrored, {67.4e9, 2.5e9}, 1};
  const std::vector<double> separations = usual_separations(pair);
  EXPECT_GE(separations.size(), 8u);
  for (const ContactLawPoint& point : contact_law(pair, separations).points) {
    EXPECT_LE(point.mean.pixel_share, 1.0 / 3);
    EXPECT_GT(point.mean.pressure, 0);
  }
}

TEST(ContactLaw, RefusesMapsThatDoNotBelongTogether) {
  const HeightMap map = rough_map(64, 12);
  HeightMap finer = map;
  finer.step_x_m /= 2;
  EXPECT_THROW(sum_of_surfaces(map, finer, MapEdges::mirrored), InputError);
  const HeightMap smaller = rough_map(60, 13);
  EXPECT_THROW(sum_of_surfaces(map, smaller, MapEdges::periodic), InputError);
  EXPECT_EQ(sum_of_surfaces(map, smaller, MapEdges::mirrored).points_x, 60u);
  const SurfacePair pair{map, {}, MapEdges::mirrored, {67.4e9, {}}, 1};
  EXPECT_THROW(contact_law(pair, std::vector<double>{1e-3}), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
