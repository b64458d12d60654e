#include "ringfilm/report/payload/map_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace ringfilm;
using report::MapPicture;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

io::MeasuredMap map_of(std::size_t points_x, std::size_t points_y, std::vector<double> values) {
  io::MeasuredMap map;
  map.name = "map";
  map.points_x = points_x;
  map.points_y = points_y;
  map.step_x = 2e-6;
  map.step_y = 3e-6;
  map.values = std::move(values);
  return map;
}

double value_of(const MapPicture& picture, std::size_t at) {
  return picture.low + (picture.high - picture.low) * picture.values[at] / 65534.0;
}

TEST(MapPicture, KeepsASmallMapToAStepOfItsRange) {
  const MapPicture picture = report::map_picture(map_of(3, 2, {1, -2, 0.123456, 4, kNone, 2}), 512);
  EXPECT_EQ(picture.columns, 3u);
  EXPECT_EQ(picture.rows, 2u);
  EXPECT_EQ(picture.block_x * picture.block_y, 1u);
  EXPECT_EQ(picture.values[4], MapPicture::kMissing);
  EXPECT_EQ(picture.values[1], 0);
  EXPECT_EQ(picture.values[3], 65534);
  EXPECT_NEAR(value_of(picture, 2), 0.123456, 6.0 / 65534 / 2 * 1.001);  // rounded to the nearest step
}

TEST(MapPicture, TakesMeansOverBlocksAndFewerPointsAtTheFarEdges) {
  // Five columns in blocks of two: the last block has one column.
  const MapPicture picture = report::map_picture(map_of(5, 2, {1, 3, 0, 0, 7, 5, 7, 0, 0, 9}), 3);
  EXPECT_EQ(picture.columns, 3u);
  EXPECT_EQ(picture.block_x, 2u);
  EXPECT_EQ(picture.block_y, 1u);
  const double half_a_step = 9.0 / 65534 / 2 * 1.001;
  EXPECT_NEAR(value_of(picture, 0), 2, half_a_step);
  EXPECT_NEAR(value_of(picture, 2), 7, half_a_step);
  EXPECT_DOUBLE_EQ(value_of(picture, 5), 9);
}

TEST(MapPicture, IsMissingWhereMostOfABlockIs) {
  const MapPicture picture = report::map_picture(map_of(4, 2, {kNone, kNone, kNone, kNone, kNone, 5, 2, 4}), 2);
  ASSERT_EQ(picture.values.size(), 4u);
  EXPECT_EQ(picture.values[0], MapPicture::kMissing);
  EXPECT_EQ(picture.values[1], MapPicture::kMissing);
  EXPECT_DOUBLE_EQ(value_of(picture, 2), 5);
  EXPECT_DOUBLE_EQ(value_of(picture, 3), 3);
  EXPECT_EQ(picture.missing_points, 5u);
}

TEST(MapPicture, ReportsThePeakThatItsMeansHide) {
  std::vector<double> values(64 * 64, 0.0);
  values[10 * 64 + 20] = 50;
  values[30 * 64 + 40] = -7;
  const MapPicture picture = report::map_picture(map_of(64, 64, values), 8);
  EXPECT_EQ(picture.highest.value, 50);
  EXPECT_DOUBLE_EQ(picture.highest.x, 20 * 2e-6);
  EXPECT_DOUBLE_EQ(picture.highest.y, 10 * 3e-6);
  EXPECT_EQ(picture.lowest.value, -7);
  EXPECT_LT(picture.high, 1);
}

TEST(MapPicture, LeavesOneInAThousandBeyondItsColoursAtEitherEnd) {
  std::vector<double> values;
  for (int i = 0; i < 10000; ++i) values.push_back((i * 7919) % 10000);  // each whole number once
  const MapPicture picture = report::map_picture(map_of(100, 100, values), 512);
  EXPECT_NEAR(picture.colour_low, 10, 1);
  EXPECT_NEAR(picture.colour_high, 9989, 1);
}

TEST(MapPicture, TakesAFlatMapAndOneWithoutHeights) {
  const MapPicture flat = report::map_picture(map_of(2, 2, {3, 3, 3, 3}), 512);
  EXPECT_EQ(flat.low, 3);
  EXPECT_EQ(flat.values, std::vector<std::uint16_t>(4, 0));
  EXPECT_FALSE(flat.empty());
  EXPECT_TRUE(report::map_picture(map_of(2, 1, {kNone, kNone}), 512).empty());
}

TEST(MapPicture, IsPackedLowByteFirst) {
  EXPECT_EQ(report::packed({}), "");
  EXPECT_EQ(report::packed({0x4241, 0x0043}), "QUJDAA==");  // the bytes "ABC" and 0
  EXPECT_EQ(report::packed({0x6261, 0x6463, 0x6665}), "YWJjZGVm");
}

}  // namespace
