#include "ringfilm/report/payload/unrolled_picture.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace {

using namespace ringfilm;
using report::PictureLimits;

/// Every value reports its place: 100 x angle + 10 x strip + node.
cycle::UnrolledFields fields(int n_angles, int n_strips, int n_nodes) {
  cycle::UnrolledFields f;
  f.circumference = 1;
  for (int k = 0; k < n_angles; ++k) f.crank_angle_deg.push_back(10.0 * k);
  for (int j = 0; j < n_strips; ++j) f.y.push_back(0.1 * j);
  for (int i = 0; i < n_nodes; ++i) f.x.push_back(0.01 * i);
  for (int k = 0; k < n_angles; ++k) {
    for (int j = 0; j < n_strips; ++j) {
      for (int i = 0; i < n_nodes; ++i) f.film_pressure.push_back(static_cast<float>(100 * k + 10 * j + i));
    }
  }
  f.film_content.assign(f.film_pressure.size(), 1);
  f.film_thickness.assign(f.film_pressure.size(), 1e-6F);
  return f;
}

double value(const report::PackedField& field, std::size_t at) {
  return field.low + (field.high - field.low) * field.values[at] / 65534.0;
}

TEST(Spread, KeepsFirstAndLastAndNoMoreThanAsked) {
  EXPECT_EQ(report::spread(4, 5), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(report::spread(7, 3), (std::vector<std::size_t>{0, 3, 6}));
  EXPECT_EQ(report::spread(8, 3), (std::vector<std::size_t>{0, 4, 7}));
  EXPECT_TRUE(report::spread(0, 3).empty());
  for (std::size_t n = 1; n < 400; ++n) {
    const auto kept = report::spread(n, 24);
    EXPECT_LE(kept.size(), 24u) << n;
    EXPECT_EQ(kept.front(), 0u);
    EXPECT_EQ(kept.back(), n - 1);
  }
}

TEST(UnrolledPicture, TakesNodesAndNotMeans) {
  const auto picture =
      report::unrolled_picture(fields(5, 7, 9), {.angles = 3, .strips = 4, .nodes = 3, .strip_angles = 2});
  EXPECT_EQ(picture.crank_angle_deg, (std::vector<double>{0, 20, 40}));
  ASSERT_EQ(picture.y.size(), 4u);
  ASSERT_EQ(picture.x.size(), 3u);
  EXPECT_EQ(picture.y[1], 0.2);
  EXPECT_EQ(picture.x[2], 0.08);
  ASSERT_EQ(picture.fields[0].name, "film_pressure");
  // Angle 2 of 5, strip 4 of 7, node 8 of 9; half a step of the range 468.
  EXPECT_NEAR(value(picture.fields[0], (1 * 4 + 2) * 3 + 2), 248, 468.0 / 65534 / 2 * 1.001);
}

TEST(UnrolledPicture, KeepsTheAngleOfTheHighestPressureAndReportsItsTruePlace) {
  auto all = fields(9, 7, 9);
  all.film_pressure[(3 * 7 + 5) * 9 + 7] = 5000;
  all.film_content[(3 * 7 + 1) * 9 + 1] = 0.25F;
  const auto picture = report::unrolled_picture(all, {.angles = 3, .strips = 3, .nodes = 3, .strip_angles = 2});
  EXPECT_EQ(picture.crank_angle_deg, (std::vector<double>{0, 30, 40, 80}));
  EXPECT_EQ(picture.highest_pressure[1].value, 5000);
  EXPECT_DOUBLE_EQ(picture.highest_pressure[1].y, 0.5);
  EXPECT_DOUBLE_EQ(picture.highest_pressure[1].x, 0.07);
  EXPECT_EQ(picture.lowest_film_content[1].value, 0.25);
}

TEST(UnrolledPicture, CarriesNoNumberWhereThereIsNone) {
  auto all = fields(2, 3, 3);
  all.film_pressure[4] = std::numeric_limits<float>::quiet_NaN();
  const auto picture = report::unrolled_picture(all);
  EXPECT_EQ(picture.fields[0].values[4], report::MapPicture::kMissing);
  EXPECT_EQ(picture.fields[0].high, 122);
}

TEST(UnrolledPicture, IsEmptyWithoutFieldsOrWithFieldsOfAnotherSize) {
  EXPECT_TRUE(report::unrolled_picture({}).fields.empty());
  auto damaged = fields(2, 3, 3);
  damaged.film_pressure.pop_back();
  EXPECT_TRUE(report::unrolled_picture(damaged).fields.empty());
}

TEST(StripPicture, KeepsAllStrips) {
  cycle::UnrolledFields f;
  f.y.resize(300);
  std::iota(f.y.begin(), f.y.end(), 0.0);
  for (int k = 0; k < 720; ++k) f.crank_angle_deg.push_back(k);
  auto& peak = f.strip_peak_film_pressure;
  for (int k = 0; k < 720; ++k) peak.insert(peak.end(), 300, static_cast<float>(1e5 + k));
  const auto picture = report::strip_picture(f);
  ASSERT_EQ(picture.fields.size(), 1u);
  EXPECT_EQ(picture.fields[0].name, "strip_peak_film_pressure");
  ASSERT_EQ(picture.crank_angle_deg.size(), 361u);
  EXPECT_EQ(picture.crank_angle_deg[1], 2);
  EXPECT_NEAR(value(picture.fields[0], 300), 100002, 719.0 / 65534 / 2 * 1.001);
}

}  // namespace
