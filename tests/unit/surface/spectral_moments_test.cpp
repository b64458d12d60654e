#include "ringfilm/surface/asperity/spectral_moments.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "../../traps/floating_point_traps.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "ringfilm/surface/topography/roughness.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kLength_m = 100e-6;

struct Sine {
  double amplitude_m;
  int waves;
  double phase;
};

const Sine kSines[] = {{1e-6, 2, 0.3}, {0.4e-6, 5, 1.1}, {0.1e-6, 11, 2.0}};

/// A profile over whole waves, with so many points beyond them that each difference is taken once on every place.
HeightMap sines(std::size_t steps, std::size_t beyond) {
  const double h = kLength_m / static_cast<double>(steps);
  return map_of(steps + beyond, 1, h, 0, [](double x, double) {
    double z = 0;
    for (const Sine& of : kSines)
      z += of.amplitude_m * std::sin(2 * std::numbers::pi * of.waves * x / kLength_m + of.phase);
    return z;
  });
}

/// Sum of a^2 k^(2n)/2 times what a difference passes of a wave.
double exact(int n, const std::function<double(double)>& passed) {
  double sum = 0;
  for (const Sine& of : kSines) {
    const double k = 2 * std::numbers::pi * of.waves / kLength_m;
    sum += 0.5 * of.amplitude_m * of.amplitude_m * std::pow(k, 2 * n) * passed(k);
  }
  return sum;
}

double sinc(double t) { return std::sin(t) / t; }

TEST(SpectralMoments, OfSinesAreWhatTheDifferencesPass) {
  const std::size_t steps = 120;
  const double h = kLength_m / steps;
  // Neighbours: a wave passes with (sin(kh/2)/(kh/2))^2 in m2, to the fourth power in m4.
  EXPECT_NEAR(moment_table(sines(steps, 1)).m2_x, exact(1, [&](double k) { return std::pow(sinc(k * h / 2), 2); }),
              1e-12 * exact(1, [](double) { return 1; }));
  EXPECT_NEAR(moment_table(sines(steps, 2)).m4_x_per_m2,
              exact(2, [&](double k) { return std::pow(sinc(k * h / 2), 4); }),
              1e-12 * exact(2, [](double) { return 1; }));
  EXPECT_NEAR(moment_table(sines(steps, 0)).m0_m2, exact(0, [](double) { return 1; }), 1e-24);
  // Seven points, from the Taylor series of their weights.
  const MomentTable seven = moment_table(sines(steps, 6), DifferenceScheme::seven_point);
  EXPECT_NEAR(seven.m2_x,
              exact(1,
                    [&](double k) {
                      const double t = k * h;
                      return std::pow((45 * std::sin(t) - 9 * std::sin(2 * t) + std::sin(3 * t)) / 30 / t, 2);
                    }),
              1e-12 * exact(1, [](double) { return 1; }));
}

TEST(SpectralMoments, ConvergeWithTheOrderOfTheirScheme) {
  const double m2 = exact(1, [](double) { return 1; }), m4 = exact(2, [](double) { return 1; });
  const auto errors = [&](std::size_t steps, DifferenceScheme scheme) {
    const bool near = scheme == DifferenceScheme::neighbours;
    return std::pair{m2 - moment_table(sines(steps, near ? 1 : 6), scheme).m2_x,
                     m4 - moment_table(sines(steps, near ? 2 : 6), scheme).m4_x_per_m2};
  };
  const auto coarse = errors(400, DifferenceScheme::neighbours), fine = errors(800, DifferenceScheme::neighbours);
  EXPECT_NEAR(coarse.first / fine.first, 4, 0.01);  // the next order is (kh)^2/30 of it
  EXPECT_NEAR(coarse.second / fine.second, 4, 0.02);
  // The leading error itself: (kh)^2/12 and (kh)^2/6.
  const double h = kLength_m / 800;
  EXPECT_NEAR(fine.first / exact(1, [&](double k) { return k * k * h * h / 12; }), 1, 0.01);
  EXPECT_NEAR(fine.second / exact(2, [&](double k) { return k * k * h * h / 6; }), 1, 0.01);
  const auto coarse_7 = errors(150, DifferenceScheme::seven_point), fine_7 = errors(300, DifferenceScheme::seven_point);
  EXPECT_NEAR(coarse_7.first / fine_7.first, 64, 3);
  EXPECT_NEAR(coarse_7.second / fine_7.second, 64, 3);
}

TEST(SpectralMoments, OfAWaveAtAnAngleFollowTheCosine) {
  const double lay = 0.4, a = 1e-6, k = 2 * std::numbers::pi / 40e-6, h = 0.25e-6;
  const HeightMap map = map_of(800, 600, h, 1.2 * h, [&](double x, double y) {
    return a * std::cos(k * (x * std::cos(lay) + y * std::sin(lay)));
  });
  const MomentTable table = moment_table(map);
  // The map holds some waves only: the mean of cos^2 over L is 1/2 to 1/(2 k L).
  const double ends = 1 / (k * 600 * 1.2 * h), differences = 1.5 * (k * h) * (k * h);
  for (const double angle : {0.0, 0.4, 1.0, std::numbers::pi / 2, 2.5}) {
    const double c = std::cos(angle - lay);
    const SpectralMoments of = moments_at_angle(table, angle);
    EXPECT_NEAR(of.m2 / (a * a * k * k / 2), c * c, ends + differences) << angle;
    EXPECT_NEAR(of.m4_per_m2 / (a * a * k * k * k * k / 2), c * c * c * c, ends + differences) << angle;
  }
  EXPECT_DOUBLE_EQ(moments_at_angle(table, 0).m4_per_m2, moments(table, MomentDirection::x).m4_per_m2);
  EXPECT_DOUBLE_EQ(moments(table, MomentDirection::mean).m2, 0.5 * (table.m2_x + table.m2_y));
  EXPECT_DOUBLE_EQ(moments(table, MomentDirection::geometric).m2, std::sqrt(table.m2_x * table.m2_y));
  EXPECT_DOUBLE_EQ(rms_slope(table), std::sqrt(table.m2_x + table.m2_y));
}

/// A Gaussian autocorrelation R = exp(-r^2/l^2): what differences show, and how far one map may stray (5 sigma).
struct GaussianField {
  std::size_t points;
  double l;  // in steps
  double mean_share() const { return std::numbers::pi * l * l / static_cast<double>(points * points); }
  /// Without the mean of the map, which is removed; of rms 1.
  double R(double steps) const { return (std::exp(-steps * steps / (l * l)) - mean_share()) / (1 - mean_share()); }
  double m2() const { return 2 * (R(0) - R(1)); }
  double m4() const { return 6 * R(0) - 8 * R(1) + 2 * R(2); }
  /// sqrt(2 integral of the squared correlation/area); the integrals are 1, 3/4 and 0.7292 of pi l^2/2.
  double spread(double integral) const { return std::sqrt(integral * mean_share()); }
};

TEST(SpectralMoments, OfAGaussianFieldLieWithinTheSamplingError) {
  const GaussianField field{600, 8};
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const HeightMap map = gaussian_surface({600, 600, 1e-6, 1e-6}, gaussian_correlation(8e-6, 8e-6), 1e-6, seed);
    const MomentTable table = moment_table(map);
    EXPECT_NEAR(table.m0_m2 / 1e-12, 1, 5 * field.spread(1)) << seed;
    for (const double m2 : {table.m2_x, table.m2_y}) EXPECT_NEAR(m2 / field.m2(), 1, 5 * field.spread(0.75)) << seed;
    for (const double m4 : {table.m4_x_per_m2, table.m4_y_per_m2}) {
      EXPECT_NEAR(m4 * 1e-12 / field.m4(), 1, 5 * field.spread(0.7292)) << seed;
    }
  }
}

TEST(SpectralMoments, AreTheSameWithPointsMissing) {
  const GaussianField field{600, 8};
  HeightMap map = gaussian_surface({600, 600, 1e-6, 1e-6}, gaussian_correlation(8e-6, 8e-6), 1e-6, 7);
  lose_points(map, 0.2, 9);
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) map.height_m[i] = 1;  // a metre: no stencil may touch it
  }
  for (const DifferenceScheme scheme : {DifferenceScheme::neighbours, DifferenceScheme::seven_point}) {
    const MomentTable table = moment_table(map, scheme);
    EXPECT_NEAR(table.m2_x * 32, 1, 5 * field.spread(0.75) + 1.0 / 128);  // 2/l^2, differences (h/l)^2/2
    EXPECT_NEAR(table.m4_y_per_m2 * 1e-12 * 4096 / 12, 1, 5 * field.spread(0.7292) + 5.0 / 192);
  }
  const MomentTable table = moment_table(map);
  EXPECT_NEAR(moments_at_angle(table, 0.6).m2 * 32, 1, 5 * field.spread(0.75) + 1.0 / 64);
}

TEST(SpectralMoments, AboveAHeightAreThoseOfThePartThatLiesThere) {
  const auto height = [](double x, double y) {
    return x < 32e-6 ? 0.1e-6 * std::sin(1e6 * x) * std::cos(0.7e6 * y) : -5e-6 + 1e-6 * std::sin(2e6 * y);
  };
  const HeightMap map = map_of(64, 48, 1e-6, 1e-6, height), part = map_of(32, 48, 1e-6, 1e-6, height);
  const SpectralMoments above = moments(moment_table_above(map, -1e-6), MomentDirection::mean),
                        alone = moments(moment_table(part), MomentDirection::mean);
  EXPECT_NEAR(above.m0_m2 / alone.m0_m2, 1, 1e-12);
  EXPECT_NEAR(above.m2 / alone.m2, 1, 1e-12);
  EXPECT_NEAR(above.m4_per_m2 / alone.m4_per_m2, 1, 1e-12);
}

TEST(SpectralMoments, OfTheFlatsNoiseAreRemoved) {
  const SpectralMoments surface{4, 3, 2}, flat{1, 1, 0.5};
  EXPECT_DOUBLE_EQ(without_noise(surface, flat).m0_m2, 3);
  EXPECT_DOUBLE_EQ(without_noise(surface, flat).m2, 2);
  EXPECT_DOUBLE_EQ(without_noise(surface, flat).m4_per_m2, 1.5);
  EXPECT_THAT([&] { without_noise(surface, {1, 3, 0.5}); }, ThrowsMessage<InputError>(HasSubstr("leaves no m2")));
  EXPECT_THAT([&] { without_noise(surface, {1, 1, 3}); }, ThrowsMessage<InputError>(HasSubstr("leaves no m4")));
}

TEST(SpectralMoments, NoiseOfAFlatMeasuredLikewiseLeavesTheSurface) {
  const SurfaceGrid grid{400, 400, 1e-6, 1e-6};
  const HeightMap surface = gaussian_surface(grid, gaussian_correlation(10e-6, 10e-6), 1e-6, 1);
  const auto white = [](double, double) { return 1.0; };
  const HeightMap noise = gaussian_surface(grid, white, 5e-9, 2), flat = gaussian_surface(grid, white, 5e-9, 3);
  HeightMap measured = surface;
  for (std::size_t i = 0; i < measured.points(); ++i) measured.height_m[i] += noise.height_m[i];
  const SpectralMoments with = moments(moment_table(measured), MomentDirection::mean);
  const SpectralMoments true_ones = moments(moment_table(surface), MomentDirection::mean);
  const SpectralMoments rest = without_noise(with, moments(moment_table(flat), MomentDirection::mean));
  // White noise adds 6 s^2/h^4 to m4: 12.5 % here; what is left is its sampling error, 5 sqrt(2 * 3/160000) of it, and
  // the chance product with the surface, 5 * 2 sqrt(m4 noise/160000).
  EXPECT_GT(with.m4_per_m2 / true_ones.m4_per_m2, 1.1);
  EXPECT_NEAR(rest.m4_per_m2 / true_ones.m4_per_m2, 1, 0.125 * 5 * 0.0061 + 5 * 2 * std::sqrt(0.125 / 160000));
}

TEST(SpectralMoments, OfHeightsBeyondAllMeasureAreRefused) {
  const ringfilm::traps::NoTraps no_traps;  // squares that overflow on purpose
  const HeightMap map = map_of(40, 30, 1e-6, 1e-6, [](double x, double y) { return 1e200 * std::sin(3e5 * x + y); });
  EXPECT_THAT([&] { moment_table(map); }, ThrowsMessage<InputError>(HasSubstr("so large")));
  EXPECT_THAT([&] { row_roughness(map); }, ThrowsMessage<InputError>(HasSubstr("so large")));
}

TEST(SpectralMoments, OfSurfacesWithoutCurvatureAreRefused) {
  const auto refused = [](const HeightMap& map, const char* why) {
    EXPECT_THAT([&] { moment_table(map); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  refused(map_of(30, 30, 1e-6, 1e-6, [](double x, double y) { return 0.1 * x - 0.3 * y; }),
          "the surface has no curvature");
  refused(map_of(30, 30, 1e-6, 1e-6, [](double, double) { return 1e-6; }), "no roughness");
  refused(map_of(17, 1, 1e-6, 0, [](double x, double) { return x * x; }), "15 complete sets");
  refused(map_of(30, 2, 1e-6, 1e-6, [](double x, double y) { return std::sin(x * 1e6) * y; }), "along y there are 0");
  const HeightMap profile = map_of(40, 1, 1e-6, 0, [](double x, double) { return x * x; });
  EXPECT_NO_THROW(moments(moment_table(profile), MomentDirection::mean));
  EXPECT_THROW(moments(moment_table(profile), MomentDirection::y), InputError);
  EXPECT_THROW(moments_at_angle(moment_table(profile), 0.1), InputError);
  // Grooves along y have none in that direction, and no asperities.
  const MomentTable grooves = moment_table(map_of(30, 30, 1e-6, 1e-6, [](double x, double) { return 2 + x * x; }));
  EXPECT_GT(grooves.m4_x_per_m2, 0);
  EXPECT_EQ(moments(grooves, MomentDirection::y).m4_per_m2, 0);
  EXPECT_EQ(moments(grooves, MomentDirection::geometric).m4_per_m2, 0);
  HeightMap checkered = map_of(60, 60, 1e-6, 1e-6, [](double x, double y) { return std::sin(3e5 * x + 1e5 * y); });
  checkered.missing.assign(3600, 0);
  for (std::size_t i = 0; i < 3600; i += 2) checkered.missing[i] = 1;
  refused(checkered, "0 complete sets");
}

}  // namespace
}  // namespace ringfilm::surface
