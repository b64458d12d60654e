#include "ringfilm/surface/topography/spectrum.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

double area(const LineSpectrum& of) {
  double sum = 0;
  for (const double density : of.density_m3) sum += density * (of.frequency_per_m[1] - of.frequency_per_m[0]);
  return sum;
}

TEST(Spectrum, ASineIsFoundAtItsFrequencyWithHalfItsSquaredAmplitude) {
  const double a = 0.3e-6, wavelength = 12.5e-6;
  const HeightMap map = map_of(500, 40, 1e-6, 2e-6, [&](double x, double y) {
    return 5e-6 + a * std::sin(2 * std::numbers::pi * x / wavelength + y * 1e5);
  });
  const LineSpectrum of = line_spectrum(map, LineDirection::x);
  EXPECT_EQ(of.lines, 40u);
  // The wave has 40 periods; its image beyond the window falls with the cube of that.
  EXPECT_NEAR(area(of), a * a / 2, 1e-4 * a * a);
  std::size_t highest = 0;
  for (std::size_t k = 0; k < of.density_m3.size(); ++k) {
    if (of.density_m3[k] > of.density_m3[highest]) highest = k;
  }
  EXPECT_NEAR(of.frequency_per_m[highest], 1 / wavelength, 1e-6 / wavelength);
  EXPECT_NEAR(
      area(line_spectrum(map_of(40, 500, 2e-6, 1e-6,
                                [&](double, double y) { return a * std::sin(2 * std::numbers::pi * y / wavelength); }),
                         LineDirection::y)),
      a * a / 2, 1e-4 * a * a);
}

TEST(Spectrum, OfWhiteNoiseIsLevelWithAndWithoutMissingPoints) {
  for (const double share : {0.0, 0.3}) {
    HeightMap map = gaussian_surface(
        {487, 300, 1e-6, 2e-6}, [](double, double) { return 1.0; }, 1e-6, 3);
    if (share > 0) lose_points(map, share, 2);
    const LineSpectrum of = line_spectrum(map, LineDirection::x);
    // Mean square over the band: 2 h s^2; 300 lines leave 1/sqrt(300) a frequency, the whole band 1/sqrt(75000).
    double mean = 0;
    for (std::size_t k = 5; k + 5 < of.density_m3.size(); ++k) mean += of.density_m3[k];
    mean /= static_cast<double>(of.density_m3.size() - 10);
    EXPECT_NEAR(mean / 2e-18, 1, 5 * 1.5 / std::sqrt(75000.0));
    const RadialSpectrum radial = radial_spectrum(map);
    double sum = 0, waves = 0;
    for (std::size_t k = 3; k < radial.waves.size(); ++k) {
      sum += radial.density_m4[k] * static_cast<double>(radial.waves[k]);
      waves += static_cast<double>(radial.waves[k]);
    }
    EXPECT_NEAR(sum / waves / 2e-24, 1, 5 * 2 / std::sqrt(0.5 * waves));  // hx hy s^2
  }
}

TEST(Spectrum, OfAGaussianFieldFollowsItsLaw) {
  const double l = 8e-6, s = 1e-6;
  const HeightMap map = gaussian_surface({600, 500, 1e-6, 1e-6}, gaussian_correlation(l, l), s, 1);
  const RadialSpectrum of = radial_spectrum(map);
  for (std::size_t k = 10; k < of.waves.size() && of.frequency_per_m[k] < 0.1e6; k += 5) {
    const double f = of.frequency_per_m[k];
    const double law = s * s * std::numbers::pi * l * l * std::exp(-std::pow(std::numbers::pi * f * l, 2));
    // Half of the waves of a ring are independent, the window ties some 2.25 together; 1 % for the ring's width.
    EXPECT_NEAR(of.density_m4[k] / law, 1, 5 * std::sqrt(2 * 2.25 / static_cast<double>(of.waves[k])) + 0.03) << f;
  }
}

TEST(Spectrum, OfALongProfileTakesASmallMultipleOfItsHeights) {
  constexpr std::size_t kPoints = 2000000;
  const HeightMap map = map_of(kPoints, 1, 1e-6, 1e-6, [](double x, double) { return std::sin(1e5 * x); });
  const auto most_kib = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const long before = most_kib();
  EXPECT_EQ(line_spectrum(map, LineDirection::x).lines, 1u);
  // Heights, mask, window, sums, waves and what the transform holds: 9 times the heights, 16 MB.
  EXPECT_LT(most_kib() - before, 12 * 8 * static_cast<long>(kPoints) / 1024);
}

TEST(Spectrum, TooFewPointsAreRefused) {
  const auto wave = [](double x, double y) { return std::sin(1e6 * x) + std::cos(1e6 * y); };
  EXPECT_THROW(line_spectrum(map_of(15, 30, 1e-6, 1e-6, wave), LineDirection::x), InputError);
  EXPECT_THROW(line_spectrum(map_of(30, 1, 1e-6, 1e-6, wave), LineDirection::y), InputError);
  EXPECT_THROW(radial_spectrum(map_of(30, 1, 1e-6, 1e-6, wave)), InputError);
  HeightMap holes = map_of(40, 40, 1e-6, 1e-6, wave);
  lose_points(holes, 0.7, 1);
  EXPECT_THROW(radial_spectrum(holes), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
