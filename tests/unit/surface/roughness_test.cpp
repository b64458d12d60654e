#include "ringfilm/surface/topography/roughness.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "ringfilm/base/error.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Roughness, OfASineAgreesWithTheTextbook) {
  const std::size_t points = 100000;  // whole waves: the mean of |sin| is right to (pi/points)^2
  const double a = 0.7e-6;
  const HeightMap map = map_of(points, 1, 1e-6, 0, [&](double x, double) {
    return 3.0 + a * std::sin(2 * std::numbers::pi * (x + 0.5e-6) / (1e-6 * static_cast<double>(points) / 10));
  });
  const HeightStatistics of = height_statistics(map);
  EXPECT_NEAR(of.mean_m, 3.0, 1e-15);
  EXPECT_NEAR(of.Sa_m / a, 2 / std::numbers::pi, 1e-7);
  EXPECT_NEAR(of.Sq_m / a, std::sqrt(0.5), 1e-9);  // heights at 3 m keep 1e-16/1e-6 of a micrometre
  EXPECT_NEAR(of.Ssk, 0, 1e-9);
  EXPECT_NEAR(of.Sku, 1.5, 1e-8);
  EXPECT_NEAR(of.Sz_m / a, 2, 1e-7);
}

TEST(Roughness, OfFewHeightsIsWhatAHandComputes) {
  HeightMap map{3, 2, 1e-6, 1e-6, {0, 1, 2, 5, 99, 2}, {0, 0, 0, 0, 1, 0}};
  const HeightStatistics of = height_statistics(map);
  EXPECT_EQ(of.points, 5u);
  EXPECT_EQ(of.missing, 1u);
  EXPECT_DOUBLE_EQ(of.mean_m, 2);
  EXPECT_DOUBLE_EQ(of.Sa_m, 6.0 / 5);
  EXPECT_DOUBLE_EQ(of.Sq_m, std::sqrt(14.0 / 5));
  EXPECT_NEAR(of.Ssk, (-8 - 1 + 27) / 5.0 / std::pow(14.0 / 5, 1.5), 1e-14);
  EXPECT_NEAR(of.Sku, (16 + 1 + 81) / 5.0 / std::pow(14.0 / 5, 2), 1e-14);
  EXPECT_DOUBLE_EQ(of.Sp_m, 3);
  EXPECT_DOUBLE_EQ(of.Sv_m, 2);
  EXPECT_DOUBLE_EQ(of.Sz_m, 5);
  EXPECT_EQ(material_ratio_curve(map), (std::vector<double>{5, 2, 2, 1, 0}));
}

/// Five sampling lengths of 8 points about 0, each with its own peak and pit.
HeightMap five_lengths() {
  HeightMap profile{40, 1, 1e-6, 0, std::vector<double>(40, 0.0), {}};
  const double peaks[] = {1e-6, 5e-6, 2e-6, 1e-6, 1e-6}, pits[] = {-2e-6, -1e-6, -1e-6, -4e-6, -2e-6};
  for (std::size_t k = 0; k < 5; ++k) {
    profile.height_m[8 * k + 1] = peaks[k];
    profile.height_m[8 * k + 6] = pits[k];
  }
  return profile;
}

TEST(Roughness, RzOfAProfileIsAMeanOverSamplingLengthsAndRtIsNot) {
  const SampledHeights of = sampled_heights(five_lengths());  // the heights add up to 0
  EXPECT_EQ(of.count, 5u);
  EXPECT_DOUBLE_EQ(of.sampling_length_m, 8e-6);
  EXPECT_NEAR(of.Rp_m, 2e-6, 1e-20);
  EXPECT_NEAR(of.Rv_m, 2e-6, 1e-20);
  EXPECT_NEAR(of.Rz_m, 4e-6, 1e-20);
  EXPECT_NEAR(height_statistics(five_lengths()).Sz_m, 9e-6, 1e-20);
}

TEST(Roughness, AsManySamplingLengthsAreUsedAsFitIntoTheMiddle) {
  HeightMap profile = five_lengths();
  const SampledHeights of = sampled_heights(profile, 19e-6);  // two of 19 points, one point is left at each end
  EXPECT_EQ(of.count, 2u);
  EXPECT_NEAR(of.Rz_m, (7e-6 + 5e-6) / 2, 1e-20);
  profile.height_m.front() = profile.height_m.back() = 1e-3;
  EXPECT_NEAR(sampled_heights(profile, 19e-6).Rz_m, (7e-6 + 5e-6) / 2, 1e-18);
  EXPECT_EQ(sampled_heights(profile, 40e-6).count, 1u);
  EXPECT_THAT([&] { sampled_heights(profile, 41e-6); }, ThrowsMessage<InputError>(HasSubstr("does not fit")));
  EXPECT_THAT([&] { sampled_heights(profile, 1e-6); }, ThrowsMessage<InputError>(HasSubstr("fewer than 2")));
  EXPECT_THAT([&] { sampled_heights(profile, 0.0); }, ThrowsMessage<InputError>(HasSubstr("does not fit")));
  profile.missing.assign(40, 0);
  for (std::size_t i = 8; i < 15; ++i) profile.missing[i] = 1;  // one point is left of the second
  EXPECT_THAT([&] { sampled_heights(profile); }, ThrowsMessage<InputError>(HasSubstr("fewer than 2 measured")));
  const HeightMap map = map_of(10, 4, 1e-6, 1e-6, [](double x, double) { return x; });
  EXPECT_THAT([&] { sampled_heights(map); }, ThrowsMessage<InputError>(HasSubstr("no sampling lengths")));
}

TEST(Roughness, OfRowsIsTakenAboutTheirOwnMeans) {
  const HeightMap map = map_of(10, 4, 1e-6, 1e-6, [](double x, double y) {
    return 1e6 * y + (std::lround(x / 1e-6) % 2 == 0 ? 0.25 : -0.25);  // steps of 1 between rows of +-1/4
  });
  EXPECT_DOUBLE_EQ(row_roughness(map).Ra_m, 0.25);
  EXPECT_DOUBLE_EQ(row_roughness(map).Rq_m, 0.25);
  EXPECT_EQ(row_roughness(map).rows, 4u);
  HeightMap holes = map;
  holes.missing.assign(40, 0);
  for (std::size_t i = 0; i < 3; ++i) holes.missing[i] = 1;  // seven are left in the first row
  EXPECT_EQ(row_roughness(holes).rows, 3u);
}

TEST(Roughness, FlatShortAndUnmeasuredMapsAreRefused) {
  const HeightMap flat = map_of(10, 10, 1e-6, 1e-6, [](double, double) { return 2e-6; });
  EXPECT_THAT([&] { height_statistics(flat); }, ThrowsMessage<InputError>(HasSubstr("it has no roughness")));
  const HeightMap few = map_of(3, 1, 1e-6, 0, [](double x, double) { return x; });
  EXPECT_THAT([&] { height_statistics(few); }, ThrowsMessage<InputError>(HasSubstr("fewer than 4")));
  EXPECT_THROW(row_roughness(few), InputError);
  HeightMap bad = few;
  bad.height_m[1] = NAN;
  EXPECT_THROW(material_ratio_curve(bad), InputError);
}

}  // namespace
}  // namespace ringfilm::surface
