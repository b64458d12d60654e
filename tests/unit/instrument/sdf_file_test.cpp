#include "ringfilm/instrument/formats/sdf_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using handmade::Bytes;
using handmade::sdf_header;
using handmade::sdf_text;
using testing::HasSubstr;

constexpr int kSizes[] = {1, 2, 4, 4, 1, 2, 4, 8};

/// Six heights of one type, written as the standard numbers the types.
std::string binary_sdf(int type, const std::vector<double>& heights) {
  Bytes out = sdf_header(type, 3, 2);
  for (const double height : heights) {
    if (type == 3) {
      out.f32(static_cast<float>(height));
    } else if (type == 7) {
      out.f64(height);
    } else {
      out.whole(static_cast<std::uint64_t>(static_cast<std::int64_t>(height)), kSizes[type]);
    }
  }
  return out;
}

class EveryTypeOfSdf : public testing::TestWithParam<int> {};

TEST_P(EveryTypeOfSdf, IsReadPointByPoint) {
  const SurfaceFile file = read_bytes("a.sdf", binary_sdf(GetParam(), {1, 2, 3, 4, 5, 100}));
  ASSERT_EQ(file.map.points_x, 3u);
  ASSERT_EQ(file.map.points_y, 2u);
  EXPECT_EQ(file.map.step_x_m, 2e-6);
  EXPECT_EQ(file.map.step_y_m, 3e-6);
  EXPECT_DOUBLE_EQ(file.map.height_m[2], 3e-9);
  EXPECT_DOUBLE_EQ(file.map.height_m[5], 100e-9);
  EXPECT_TRUE(file.map.missing.empty());
  EXPECT_EQ(file.origin.instrument, "MAKER");
}

TEST_P(EveryTypeOfSdf, ReadsItsMissingPoint) {
  const int type = GetParam();
  const double marks[] = {-1,     65535,    4294967295.0,  -std::numeric_limits<float>::max(),
                          -128.0, -32768.0, -2147483648.0, -std::numeric_limits<double>::max()};
  const SurfaceFile file = read_bytes("a.sdf", binary_sdf(type, {1, 2, marks[type], 4, 5, 6}));
  if (type == 0) {
    EXPECT_TRUE(file.map.missing.empty()) << "all 256 numbers of a byte are heights";
    return;
  }
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 0}));
  if (type == 3 || type == 7) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(read_bytes("a.sdf", binary_sdf(type, {1, nan, 3, 4, 5, 6})).map.missing[1], 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, EveryTypeOfSdf, testing::Range(0, 8));

TEST(Sdf, TextWithBadPoints) {
  const SurfaceFile file = read_bytes("a.sdf", sdf_text("1 2 BAD\n4.5 +5 -6e1", 3, 2));
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 0}));
  EXPECT_DOUBLE_EQ(file.map.height_m[3], 4.5e-9);
  EXPECT_DOUBLE_EQ(file.map.height_m[5], -60e-9);
}

TEST(Sdf, OneRowIsAProfile) {
  const SurfaceFile file = read_bytes("a.sdf", sdf_text("1 2 3", 3, 1));
  EXPECT_TRUE(file.map.is_profile());
  EXPECT_EQ(file.map.step_y_m, 0);
}

TEST(Sdf, WhatIsNotReadIsNamed) {
  EXPECT_THAT(refusal("a.sdf", sdf_header(7, 3, 2, 1e-9, 1).zeros(48)), HasSubstr("compressed (Compression = 1)"));
  EXPECT_THAT(refusal("a.sdf", sdf_header(9, 3, 2).zeros(48)), HasSubstr("DataType = 9"));
  EXPECT_THAT(refusal("a.sdf", sdf_header(7, 3, 2).zeros(47)), HasSubstr("byte 81: the map of 3 x 2 points needs 48"));
  EXPECT_THAT(refusal("a.sdf", sdf_header(7, 3, 2, 0.0).zeros(48)), HasSubstr("Zscale = 0"));
  EXPECT_THAT(refusal("a.sdf", sdf_header(7, 3, 2, -1e-9).zeros(48)), HasSubstr("Zscale = -1e-09 gives no heights"));
  EXPECT_THAT(refusal("a.sdf", sdf_text("1 2 3 4 5", 3, 2)), HasSubstr("the heights end after 5 of 6"));
  EXPECT_THAT(refusal("a.sdf", sdf_text("1 2 3 4 5x 6", 3, 2)), HasSubstr("height 5 is not a number"));
  EXPECT_THAT(refusal("a.sdf", sdf_text("1 2 3", 3000, 2000)), HasSubstr("have no place in the"));
}

TEST(Sdf, AHeaderSmallerThanTheDataIsRefused) {
  Bytes half = sdf_header(7, 3, 2), narrow = sdf_header(3, 3, 2);
  for (int i = 0; i < 12; ++i) half.f64(1.5 * i);
  for (int i = 0; i < 6; ++i) narrow.f64(1.5 * i);
  EXPECT_THAT(refusal("a.sdf", half),
              HasSubstr("byte 129: the map of 3 x 2 points ends here, and 48 more bytes follow"));
  EXPECT_THAT(refusal("a.sdf", narrow),
              HasSubstr("byte 105: the map of 3 x 2 points ends here, and 24 more bytes follow"));
  EXPECT_THAT(refusal("a.sdf", binary_sdf(0, {1, 2, 3, 4, 5, 6}) + "abc"), HasSubstr("and 3 more bytes follow"));
  EXPECT_THAT(refusal("a.sdf", sdf_text("1 2 3 4 5 6 7 8 9", 3, 2)),
              HasSubstr("the map of 3 x 2 points ends here, and more follows"));
}

TEST(Sdf, TextCutWithinItsLastHeightIsRefused) {
  const std::string whole = sdf_text("1 2 3 4 5 6.25", 3, 2);
  const std::size_t end = whole.rfind("6.25") + 4;
  EXPECT_THAT(refusal("a.sdf", whole.substr(0, end - 1)),
              HasSubstr("byte " + std::to_string(end - 1) + ": the file ends within its last height"));
  EXPECT_THAT(refusal("a.sdf", whole.substr(0, end)), HasSubstr("the file ends within its last height"));
  for (const std::string& complete : {whole.substr(0, end) + "*", whole}) {
    EXPECT_TRUE(read_bytes("a.sdf", complete).origin.notes.empty());
  }
  EXPECT_THAT(read_bytes("a.sdf", whole.substr(0, end) + "\n").origin.notes,
              testing::Contains(HasSubstr("the line \"*\" that ends the heights is missing")));
}

TEST(Sdf, ATrailerBehindTheHeightsIsNotData) {
  const std::string trailer = "\r\n<PartName> a liner </PartName>\r\n*\r\n";
  EXPECT_EQ(refusal("a.sdf", binary_sdf(5, {1, 2, 3, 4, 5, 6}) + trailer), "");
  EXPECT_EQ(refusal("a.sdf", sdf_text("1 2 3 4 5 6", 3, 2) + trailer), "");
}

TEST(Sdf, TheExtraFieldsOfOneMakerAreSkipped) {
  Bytes out = sdf_header(5, 3, 1);
  out.i32(5).i32(1).i16(7).i16(8).i16(9);
  EXPECT_DOUBLE_EQ(read_bytes("a.sdf", out).map.height_m[0], 7e-9);
}

}  // namespace
}  // namespace ringfilm::instrument
