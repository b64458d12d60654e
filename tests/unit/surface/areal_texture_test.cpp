#include "ringfilm/surface/topography/areal_texture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kDegreeInRad = std::numbers::pi / 180;

TEST(ArealTexture, ATiltedPlaneHasTheAreaOfItsSlope) {
  const HeightMap plane = map_of(20, 16, 1e-6, 2e-6, [](double x, double y) { return 0.3 * x - 0.4 * y; });
  EXPECT_NEAR(developed_area_ratio(plane), std::sqrt(1.25) - 1, 1e-13);  // rounding of 300 cells
  HeightMap holes = plane;
  lose_points(holes, 0.2, 3);
  EXPECT_NEAR(developed_area_ratio(holes), std::sqrt(1.25) - 1, 1e-13);
}

TEST(ArealTexture, AFlatWaveHasHalfTheMeanSquareSlope) {
  const double k = 2 * std::numbers::pi / 64e-6, a = 1e-8;
  const HeightMap wave = map_of(129, 64, 1e-6, 1e-6, [&](double x, double) { return a * std::sin(k * x); });
  // sqrt(1 + s2) - 1 = s2/2 to 1e-6 of it; differences of neighbours miss (k h)^2/12 = 8e-4.
  EXPECT_NEAR(developed_area_ratio(wave) / (a * a * k * k / 4), 1, 1e-3);
}

TEST(ArealTexture, CrossedWavesHaveTheirClosedLengths) {
  const double wavelength = 16e-6, k = 2 * std::numbers::pi / wavelength;
  const HeightMap map =
      map_of(256, 256, 1e-6, 1e-6, [&](double x, double y) { return 1e-7 * (std::sin(k * x) + std::cos(k * y)); });
  // r = (cos k x + cos k y)/2 falls to 0.2 first along the diagonal, at sqrt(2) acos(0.2)/k, last along the axes, at
  // acos(-0.6)/k. 2 %: pairs of points apart by other than whole waves, and straight lines between shifts of a step.
  const AutocorrelationLengths lengths = autocorrelation_lengths(map);
  const double shortest = std::numbers::sqrt2 * std::acos(0.2) / k, longest = std::acos(-0.6) / k;
  EXPECT_NEAR(lengths.Sal_m / shortest, 1, 0.02);
  ASSERT_TRUE(lengths.Str.has_value());
  EXPECT_NEAR(*lengths.Str / (shortest / longest), 1, 0.03);
}

TEST(ArealTexture, GroovesOfOneLayHaveALengthAndNoAspectRatio) {
  const double k = 2 * std::numbers::pi / 16e-6;
  const HeightMap map = map_of(128, 128, 1e-6, 1e-6, [&](double x, double) { return 1e-7 * std::sin(k * x); });
  const AutocorrelationLengths lengths = autocorrelation_lengths(map);
  EXPECT_NEAR(lengths.Sal_m / (std::acos(0.2) / k), 1, 0.02);  // across the grooves
  EXPECT_FALSE(lengths.Str.has_value());                       // along them it stays at 1
}

/// Grooves of half the angle to both sides of x, and a second wavelength that leaves no beat.
HeightMap cross_hatch(double angle_deg, double turn_deg = 0) {
  return map_of(256, 256, 1e-6, 1e-6, [=](double x, double y) {
    double z = 0;
    for (const double side : {-1.0, 1.0}) {
      const double lay = (turn_deg + side * angle_deg / 2) * kDegreeInRad;
      const double across = -x * std::sin(lay) + y * std::cos(lay);
      for (const double wavelength : {9e-6, 13e-6}) z += 1e-7 * std::sin(2 * std::numbers::pi * across / wavelength);
    }
    return z;
  });
}

TEST(ArealTexture, TheAngleOfACrossHatch) {
  for (const double angle : {20.0, 35.0, 50.0, 90.0}) {
    const auto found = honing_angle(cross_hatch(angle, 10));
    ASSERT_TRUE(found.has_value()) << angle;
    EXPECT_NEAR(found->angle_rad / kDegreeInRad, angle, 1) << "a step of the angular spectrum";
    EXPECT_LT(found->scatter_rad / kDegreeInRad, 3) << "waves of one direction, under the window";
    const double middle = (found->first_rad + found->second_rad) / 2 / kDegreeInRad;
    EXPECT_NEAR(std::remainder(middle - 10, 90), 0, 1) << angle;
  }
  const auto obtuse = honing_angle(cross_hatch(130));
  ASSERT_TRUE(obtuse.has_value());
  EXPECT_NEAR(obtuse->angle_rad / kDegreeInRad, 50, 1);
}

TEST(ArealTexture, OneLayIsNotACrossHatch) { EXPECT_FALSE(honing_angle(cross_hatch(0, 30)).has_value()); }

TEST(ArealTexture, TwoPeaksOfOneBroadLobeAreNotACrossHatch) {
  const HeightMap fan = map_of(96, 96, 1e-6, 1e-6, [](double x, double y) {
    double z = 0;
    for (int k = -5; k <= 5; k += 2) {  // lays from -9 to 9 degree
      const double lay_deg = 1.8 * k, lay = lay_deg * kDegreeInRad;
      const double across = -x * std::sin(lay) + y * std::cos(lay);
      z += 1e-7 * std::sin(2 * std::numbers::pi * across / 9e-6 + 3 * lay_deg * lay_deg);
    }
    return z;
  });
  EXPECT_FALSE(honing_angle(fan).has_value());  // the middles of the lobes are 6 degree apart
}

TEST(ArealTexture, ProfilesAndFlatMapsAreRefused) {
  const HeightMap profile = map_of(64, 1, 1e-6, 1e-6, [](double x, double) { return std::sin(1e6 * x) * 1e-7; });
  EXPECT_THROW(developed_area_ratio(profile), InputError);
  EXPECT_THROW(autocorrelation_lengths(profile), InputError);
  EXPECT_THROW(honing_angle(profile), InputError);
  EXPECT_THROW(autocorrelation_lengths(map_of(32, 32, 1e-6, 1e-6, [](double, double) { return 0; })), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
