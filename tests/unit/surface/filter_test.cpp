#include "ringfilm/surface/topography/filter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/gaussian_kernel.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

FilterChoice short_filter(double cutoff_m) { return {FilterKind::gaussian, FilterSide::short_cutoff, cutoff_m}; }
FilterChoice long_filter(double cutoff_m) { return {FilterKind::gaussian, FilterSide::long_cutoff, cutoff_m}; }

/// The law of the standard, written as it is there.
double law(double wavelength, double cutoff) {
  const double alpha = 0.469718639;
  return std::exp(-std::numbers::pi * (alpha * cutoff / wavelength) * (alpha * cutoff / wavelength));
}

/// Amplitude of a filtered wave in the middle of a row, where its crest is.
double passed(double wavelength_steps, double cutoff_steps) {
  const std::size_t points = 4001, middle = 2000;
  HeightMap map = map_of(points, 1, 1e-6, 0, [&](double x, double) {
    return 1e-6 * std::cos(2 * std::numbers::pi * (x - middle * 1e-6) / (wavelength_steps * 1e-6));
  });
  apply_filter(map, short_filter(cutoff_steps * 1e-6));
  return map.height_m[middle] / 1e-6;
}

TEST(Filter, HalfOfAWaveOfTheCutOffPasses) {
  for (const double cutoff_steps : {2.0, 2.5, 3.0, 5.0, 8.0, 25.0, 60.0, 333.0}) {
    EXPECT_NEAR(passed(cutoff_steps, cutoff_steps), 0.5, 1e-9) << cutoff_steps;
  }
}

TEST(Filter, OtherWavesPassAsTheLawOfTheStandardStates) {
  for (const double cutoff_steps : {8.0, 40.0, 200.0}) {
    for (const double ratio : {0.4, 0.5, 0.8, 1.0, 1.3, 2.0, 3.0, 5.0}) {
      // 8 steps: the nearest alias passes law(1/(8 - 2.5)) = 8e-10; the tail beyond 1.3 cut-offs holds 1e-9.
      EXPECT_NEAR(passed(ratio * cutoff_steps, cutoff_steps), law(ratio, 1), 1e-8) << cutoff_steps << " " << ratio;
      EXPECT_NEAR(gaussian_transmission(ratio, 1), law(ratio, 1), 1e-8);
    }
  }
}

TEST(Filter, NoWaveAndNoCutOffAreRefused) {
  EXPECT_THROW(gaussian_transmission(-1, 1), ringfilm::InputError);
  EXPECT_THROW(gaussian_transmission(0, 1), ringfilm::InputError);
  EXPECT_THROW(gaussian_transmission(1, 0), ringfilm::InputError);
  EXPECT_THROW(gaussian_transmission(1, INFINITY), ringfilm::InputError);
}

TEST(Filter, ShortAndLongSideAddUpToTheMap) {
  HeightMap map = map_of(70, 50, 1e-6, 2e-6, [](double x, double y) { return std::sin(x * 3e5) + std::cos(y * 2e5); });
  lose_points(map, 0.2, 8);
  HeightMap smooth = map, rough = map;
  apply_filter(smooth, short_filter(20e-6));
  apply_filter(rough, long_filter(20e-6));
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (!map.measured(i)) continue;
    EXPECT_NEAR(smooth.height_m[i] + rough.height_m[i], map.height_m[i], 1e-14);
  }
}

/// A plain double sum over the neighbourhood, with the weights of the standard.
double smooth_at(const HeightMap& map, std::size_t column, std::size_t row, double cutoff_m) {
  double sum = 0, weights = 0;
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      if (!map.measured(map.index(i, j))) continue;
      const double x = (static_cast<double>(i) - static_cast<double>(column)) * map.step_x_m;
      const double y = (static_cast<double>(j) - static_cast<double>(row)) * map.step_y_m;
      const double weight = std::exp(-std::numbers::pi * (x * x + y * y) / std::pow(0.469718639 * cutoff_m, 2));
      sum += weight * map.height_m[map.index(i, j)];
      weights += weight;
    }
  }
  return sum / weights;
}

TEST(Filter, EndsAndMissingPointsWeighNothing) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  for (const double share_missing : {0.0, 0.4}) {
    for (const double cutoff_steps : {9.0, 60.0}) {  // summed, and through the transform
      HeightMap map = map_of(81, 67, 1e-6, 1e-6, [&](double, double) { return 5 + normal(generator); });
      if (share_missing > 0) lose_points(map, share_missing, 6);
      const HeightMap before = map;
      apply_filter(map, short_filter(cutoff_steps * 1e-6));
      for (const auto& [column, row] : {std::pair{0, 0}, {80, 66}, {40, 33}, {3, 60}, {80, 10}}) {
        if (!map.measured(map.index(column, row))) continue;
        EXPECT_NEAR(map.height_m[map.index(column, row)], smooth_at(before, column, row, cutoff_steps * 1e-6), 2e-8)
            << cutoff_steps << " " << column << " " << row;
      }
    }
  }
}

TEST(Filter, SummedAndTransformedKernelsAgree) {
  // 37 cut-off steps reach 50 to a side and go through the transform; the same kernel summed here.
  const std::vector<double> kernel = gaussian_kernel(37);
  ASSERT_GT(kernel.size(), 49u);
  std::mt19937 generator(2);
  std::normal_distribution<double> normal;
  std::vector<double> line(300), other(300);
  for (double& value : line) value = normal(generator);
  for (double& value : other) value = normal(generator);
  const std::vector<double> before = line;
  LineConvolution(kernel, line.size()).apply(line, other);
  for (int i = 0; i < 300; ++i) {
    double sum = 0;
    for (int k = -static_cast<int>(kernel.size()) + 1; k < static_cast<int>(kernel.size()); ++k) {
      if (i + k >= 0 && i + k < 300) sum += kernel[std::abs(k)] * before[i + k];
    }
    EXPECT_NEAR(line[i], sum, 1e-14);
  }
}

TEST(Filter, RobustFilterIsNotPulledDownByGrooves) {
  // A gentle wave with grooves: the robust line keeps to the wave, the linear one sinks.
  const auto wave = [](double x) { return 1e-7 * std::cos(2 * std::numbers::pi * x / 2e-3); };
  HeightMap map = map_of(2000, 1, 1e-6, 0, [&](double x, double) {
    const int step = static_cast<int>(std::lround(x / 1e-6));
    return wave(x) + 2e-9 * std::cos(step * 1.7) - (step % 100 < 15 ? 3e-6 : 0.0);
  });
  HeightMap linear = map;
  const FilterApplied applied = apply_filter(map, {FilterKind::robust_gaussian, FilterSide::short_cutoff, 200e-6});
  apply_filter(linear, short_filter(200e-6));
  EXPECT_THAT(applied.text, HasSubstr("robust Gaussian regression of order 0"));
  EXPECT_GT(applied.iterations, 1);
  EXPECT_EQ(applied.points_without_support, 0u);
  for (std::size_t i = 300; i < 1700; ++i) {
    const double x = static_cast<double>(i) * 1e-6;
    // Order 0: the wave itself is passed to law(10) = 0.9931, and the uneven weights cost a little.
    EXPECT_NEAR(map.height_m[i], wave(x), 4e-9);
    EXPECT_LT(linear.height_m[i], wave(x) - 0.35e-6);  // 15 % of 3 um are 0.45 um
  }
}

TEST(Filter, CutOffsBeyondTheMapAreRefused) {
  HeightMap map = map_of(50, 40, 1e-6, 2e-6, [](double x, double y) { return x * y; });
  const auto refused = [&](double cutoff_m, const char* why) {
    EXPECT_THAT([&] { apply_filter(map, short_filter(cutoff_m)); }, ThrowsMessage<InputError>(HasSubstr(why)));
  };
  refused(3.9e-6, "below two steps of 2 um along y");
  refused(60e-6, "longer than the map, 50 um along x");
  refused(0, "not a positive length");
  refused(-1e-6, "not a positive length");
  refused(NAN, "not a positive length");
  refused(INFINITY, "not a positive length");
  EXPECT_NO_THROW(apply_filter(map, short_filter(4e-6)));
  map.height_m[3] = NAN;
  EXPECT_THROW(apply_filter(map, short_filter(4e-6)), InputError);
}

TEST(Filter, ValleySuppressionLeavesThePlateauWhereDeepValleysPullTheLinearFilterDown) {
  const auto valleys = [](double x, double) { return std::fmod(x, 100e-6) < 20e-6 ? -5e-6 : 0.0; };
  const HeightMap profile = map_of(2000, 1, 1e-6, 1e-6, valleys);
  const auto plateau_after = [&](FilterKind kind) {
    HeightMap map = profile;
    apply_filter(map, {kind, FilterSide::long_cutoff, 400e-6});
    return map.height_m[1060];  // in the middle of a plateau
  };
  // The cut-off is four valleys apart: the linear mean line lies at their mean, 1 um deep. Cut off there they are 1 um
  // deep over a fifth of the length, and the second line lies at 0.2 um. 10 %: what passes of a wave of 100 um.
  EXPECT_NEAR(plateau_after(FilterKind::gaussian), 1e-6, 0.1e-6);
  EXPECT_NEAR(plateau_after(FilterKind::valley_suppression), 0.2e-6, 0.02e-6);
  HeightMap map = map_of(64, 64, 1e-6, 1e-6, valleys);
  EXPECT_THROW(apply_filter(map, {FilterKind::valley_suppression, FilterSide::long_cutoff, 20e-6}), InputError);
}

TEST(Filter, ValleySuppressionHasTheLinearSFilter) {
  const HeightMap profile = map_of(400, 1, 1e-6, 1e-6, [](double x, double) { return 1e-7 * std::sin(2e5 * x); });
  HeightMap linear = profile, two_step = profile;
  apply_filter(linear, {FilterKind::gaussian, FilterSide::short_cutoff, 8e-6});
  apply_filter(two_step, {FilterKind::valley_suppression, FilterSide::short_cutoff, 8e-6});
  EXPECT_EQ(linear.height_m, two_step.height_m);
}

}  // namespace
}  // namespace ringfilm::surface
