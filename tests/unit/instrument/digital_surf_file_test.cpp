#include "ringfilm/instrument/formats/digital_surf_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>

#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using handmade::Sur;
using testing::HasSubstr;

// Heights are whole numbers times 0.25 nm and 5 nm more; these are exact in single precision.
double height_m(std::int64_t whole) { return (static_cast<double>(whole) * 0.25 + 5) * 1e-9; }

class EveryKindOfSur : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(EveryKindOfSur, IsReadPointByPoint) {
  Sur sur;
  std::tie(sur.bits, sur.high_byte_first) = GetParam();
  sur.heights = {-10, 20, 30, 40, 50, 32000};
  const SurfaceFile file = read_bytes("a.sur", sur.bytes());
  ASSERT_EQ(file.map.points_x, 3u);
  ASSERT_EQ(file.map.points_y, 2u);
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 3e-6);
  EXPECT_TRUE(file.map.missing.empty());
  for (std::size_t i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(file.map.height_m[i], height_m(sur.heights[i])) << i;
  EXPECT_EQ(file.origin.date, "2019-03-07");
  EXPECT_EQ(file.origin.channel, "a scratch");
}

INSTANTIATE_TEST_SUITE_P(WidthAndOrder, EveryKindOfSur, testing::Combine(testing::Values(16, 32), testing::Bool()));

TEST(DigitalSurf, PointsTwoBelowTheSmallestAreMissing) {
  Sur sur;
  sur.special_points = 1;
  sur.smallest = 10;
  sur.heights = {10, 8, 30, 40, 50, 8};
  const SurfaceFile file = read_bytes("a.sur", sur.bytes());
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(file.map.height_m[1], 0);
  EXPECT_THAT(file.plausibility_line, HasSubstr("33.3 % missing"));
  EXPECT_TRUE(file.origin.doubts.empty());
  sur.special_points = 0;
  EXPECT_TRUE(read_bytes("a.sur", sur.bytes()).map.missing.empty());
  EXPECT_THAT(read_bytes("a.sur", sur.bytes()).origin.doubts,
              testing::ElementsAre(HasSubstr("2 points hold 8, two below the smallest height of the header, the first "
                                             "of them in row 1, column 2")));
  sur.smallest = 0;  // not two below anything
  EXPECT_TRUE(read_bytes("a.sur", sur.bytes()).origin.doubts.empty());
}

TEST(DigitalSurf, ACommentIsSkippedAndLatinUnitsAreRead) {
  Sur sur;
  sur.comment_size = 77;
  sur.unit_z = "\xB5m";
  const SurfaceFile file = read_bytes("a.sur", sur.bytes());
  EXPECT_DOUBLE_EQ(file.map.height_m[0], 7.5e-6);
  EXPECT_EQ(file.origin.channels[0].unit, "\u00B5m");
}

TEST(DigitalSurf, AnInvertedSurfaceIsTurnedBack) {
  Sur sur;
  sur.inverted = 2;
  sur.heights = {10, 20, 70, 45, 50, 90};  // mean 47.5
  const SurfaceFile file = read_bytes("a.sur", sur.bytes());
  // Each height mirrored about the mean, each row turned: as gwyddion 2.62 gives the same bytes.
  const std::vector<double> expected = {25, 75, 85, 5, 45, 50};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(file.map.height_m[i], (expected[i] * 0.25 + 5) * 1e-9, 1e-22) << i;  // rounding of the mean
  }
}

TEST(DigitalSurf, OtherKindsAreRefusedByName) {
  Sur sur;
  sur.type = 5;
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("byte 18: the file holds a series of surfaces (kind 5)"));
  sur.type = 2;
  sur.objects = 3;
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("the file holds 3 objects"));
  sur.objects = 1;
  sur.bits = 8;
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("a height has 8 bits; 16 or 32 are known"));
}

TEST(DigitalSurf, AFileCutByOneByteReportsFromWhereItCounts) {
  Sur sur;
  sur.comment_size = 77;
  std::string bytes = sur.bytes();
  bytes.pop_back();
  EXPECT_THAT(refusal("a.sur", bytes),
              HasSubstr("byte 589: the map of 3 x 2 points needs 24 bytes from byte 589 on, and there are 23: the file "
                        "ends after 612"));
}

TEST(DigitalSurf, AHeaderSmallerThanTheDataIsRefused) {
  Sur sur;
  sur.comment_size = 77;
  sur.points_y = 1;
  EXPECT_THAT(refusal("a.sur", sur.bytes()),
              HasSubstr("byte 601: the map of 3 x 1 points ends here, and 12 more bytes follow"));
  sur.points_y = 2;
  EXPECT_EQ(refusal("a.sur", sur.bytes()), "");
}

TEST(DigitalSurf, BytesBehindTheHeightsAreNoted) {
  const SurfaceFile file = read_bytes("a.sur", Sur().bytes() + std::string(5, 'x'));  // no whole row of 12 bytes
  EXPECT_DOUBLE_EQ(file.map.height_m[5], height_m(60));
  EXPECT_THAT(
      file.origin.doubts,
      testing::ElementsAre(HasSubstr("byte 536: the map of 3 x 2 points ends here, and the 5 bytes behind it")));
}

TEST(DigitalSurf, TheFirstOfSeveralLayersIsTheTopography) {
  Sur sur;
  for (const int type : {8, 11, 16}) {
    sur.type = type;
    sur.objects = 2;
    EXPECT_TRUE(read_bytes("a.sur", sur.bytes()).origin.doubts.empty()) << type;
    const SurfaceFile file = read_bytes("a.sur", sur.bytes() + sur.bytes());
    EXPECT_EQ(file.map.points_y, 2u);
    EXPECT_DOUBLE_EQ(file.map.height_m[5], height_m(60));
    EXPECT_THAT(file.origin.doubts, testing::ElementsAre(HasSubstr("536 bytes of further layers were not"))) << type;
  }
}

TEST(DigitalSurf, XAndYMayHaveUnlikeUnits) {
  Sur sur;
  sur.unit_y = "mm";
  const SurfaceFile file = read_bytes("a.sur", sur.bytes());
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 3e-3);
  sur.unit_y = "V";
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("y is in \"V\", which is not a unit of length"));
  SurfaceOptions options;
  options.lateral_unit = "nm";
  EXPECT_DOUBLE_EQ(read_bytes("a.sur", sur.bytes(), options).map.step_y_m, 3e-9);
}

std::string packed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return result.substr(0, size);
}

TEST(DigitalSurf, CompressedHeightsAreThoseThatWerePacked) {
  Sur sur;
  sur.comment_size = 9;
  for (const bool high_byte_first : {false, true}) {
    sur.high_byte_first = high_byte_first;
    const SurfaceFile plain = read_bytes("a.sur", sur.bytes());
    for (const std::size_t each : {24u, 8u, 7u}) {  // one stream, three, and streams that end within a height
      const SurfaceFile file = read_bytes("a.sur", sur.compressed(each, packed));
      EXPECT_EQ(file.map.height_m, plain.map.height_m) << each;
      EXPECT_EQ(file.map.step_y_m, plain.map.step_y_m);
      EXPECT_THAT(file.origin.format, HasSubstr("compressed"));
    }
  }
}

TEST(DigitalSurf, DamagedStreamsAreRefused) {
  const std::string whole = Sur().compressed(8, packed);
  const std::vector<double> heights = read_bytes("a.sur", whole).map.height_m;
  for (std::size_t length = 512; length < whole.size(); ++length) {
    EXPECT_THAT(refusal("a.sur", whole.substr(0, length)), HasSubstr("copy it again")) << length;
  }
  for (std::size_t i = 512; i < whole.size(); ++i) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x40);
    if (refusal("a.sur", bytes).empty()) {  // bits that fill the last byte of a stream up
      EXPECT_EQ(read_bytes("a.sur", bytes).map.height_m, heights) << "byte " << i;
    }
  }
  Sur sur;
  sur.points_x = sur.points_y = 10000;
  std::string bomb = sur.compressed(24, packed);
  bomb.replace(516, 4, handmade::Bytes().i32(400000000).str());
  EXPECT_THAT(refusal("a.sur", bomb), HasSubstr("more than any can hold"));
}

TEST(DigitalSurf, AStepBelowZeroIsRefused) {
  Sur sur;
  sur.step_x = -2.0f;
  EXPECT_THAT(refusal("a.sur", sur.bytes()),
              HasSubstr("byte 120: the step along x is -2; a number above zero is expected"));
  sur.step_x = 2.0f;
  sur.step_y = -3.0f;
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("byte 124: the step along y is -3"));
  sur.step_y = std::nanf("");
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("byte 124: the step along y is nan"));
  sur.step_y = 3.0f;
  sur.step_z = -0.25f;
  EXPECT_THAT(refusal("a.sur", sur.bytes()), HasSubstr("byte 128: the step of the heights is -0.25"));
}

TEST(DigitalSurf, ATotalThatContradictsRowsAndColumnsIsRefused) {
  Sur sur;
  for (const int total : {5, 7, -6}) {
    sur.points = total;
    EXPECT_THAT(refusal("a.sur", sur.bytes()),
                HasSubstr("byte 116: the header states " + std::to_string(total) + " points in all, and 3 x 2 are 6"));
  }
  sur.points = 0;  // not stated
  EXPECT_EQ(refusal("a.sur", sur.bytes()), "");
}

TEST(DigitalSurf, WhatIsWrittenIsReadBack) {
  surface::HeightMap map;
  map.points_x = 4;
  map.points_y = 3;
  map.step_x_m = 0.5e-6;
  map.step_y_m = 1.25e-6;
  for (int i = 0; i < 12; ++i) map.height_m.push_back(1e-6 * std::sin(1.7 * i));
  map.missing.assign(12, 0);
  map.missing[5] = 1;
  map.height_m[5] = 0;
  const std::string bytes = digital_surf_bytes(map, 1e-10, "made");
  EXPECT_EQ(bytes, digital_surf_bytes(map, 1e-10, "made"));
  const surface::HeightMap back = read_bytes("a.sur", bytes).map;
  EXPECT_EQ(back.missing, map.missing);
  EXPECT_DOUBLE_EQ(back.step_y_m, 1.25e-6);
  // Half a step of the resolution, and the step itself is kept in single precision.
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(back.height_m[i], map.height_m[i], 0.51e-10) << i;
  map.height_m[0] = 0.9;
  EXPECT_THROW(digital_surf_bytes(map, 1e-10, "made"), InputError);
}

}  // namespace
}  // namespace ringfilm::instrument
