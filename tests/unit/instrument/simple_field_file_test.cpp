#include "ringfilm/instrument/formats/simple_field_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using handmade::Bytes;
using testing::HasSubstr;

std::string field(const std::string& lines, const std::vector<float>& heights) {
  Bytes out;
  out.text("Gwyddion Simple Field 1.0\n" + lines);
  out.zeros(4 - out.str().size() % 4);
  for (const float height : heights) out.f32(height);
  return out;
}

constexpr char kLines[] = "XRes = 3\nYRes = 2\nXReal = 6e-6\nYReal = 6e-6\nXYUnits = m\nZUnits = m\nTitle = a map\n";

TEST(SimpleField, IsReadPointByPoint) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const SurfaceFile file = read_bytes("a.gsf", field(kLines, {1e-6f, 2e-6f, nan, 4e-6f, 5e-6f, 6e-6f}));
  ASSERT_EQ(file.map.points_x, 3u);
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 3e-6);
  EXPECT_EQ(file.map.height_m[3], 4e-6f);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(file.origin.channel, "a map");
}

TEST(SimpleField, WhatItOmitsIsAskedFor) {
  const std::string bare = field("XRes = 3\nYRes = 2\n", {1, 2, 3, 4, 5, 6});
  EXPECT_THAT(refusal("a.gsf", bare), HasSubstr("--unit um"));
  SurfaceOptions options;
  options.height_unit = "um";
  EXPECT_THAT(refusal("a.gsf", bare, options), HasSubstr("--step-x"));
  options.step_x = "0.5 um";
  options.step_y = "1 um";
  const SurfaceFile file = read_bytes("a.gsf", bare, options);
  EXPECT_DOUBLE_EQ(file.map.height_m[5], 6e-6);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 1e-6);
  EXPECT_THAT(file.origin.notes, testing::Contains(HasSubstr("unit of heights: um as the user states")));
}

TEST(SimpleField, FaultsNameTheirByte) {
  EXPECT_THAT(refusal("a.gsf", field("XRes = 3\n", {1})), HasSubstr("the header has no YRes"));
  EXPECT_THAT(refusal("a.gsf", field("XRes = three\nYRes = 2\n", {1})),
              HasSubstr("byte 26: XRes = three is not a number"));
  EXPECT_THAT(refusal("a.gsf", field(kLines, {1, 2, 3})), HasSubstr("the map of 3 x 2 points needs 24 bytes"));
  EXPECT_THAT(refusal("a.gsf", "Gwyddion Simple Field 1.0\nXRes = 3\n"), HasSubstr("no zero byte ends the header"));
}

TEST(SimpleField, AHeaderSmallerThanTheDataIsRefused) {
  EXPECT_THAT(refusal("a.gsf", field(kLines, std::vector<float>(9, 1.0f))),
              HasSubstr("byte 132: the map of 3 x 2 points ends here, and 12 more bytes follow"));
  EXPECT_THAT(refusal("a.gsf", field(kLines, std::vector<float>(6, 1.0f)) + std::string(400, '\0')),
              HasSubstr("and 400 more bytes follow"));
}

TEST(SimpleField, WhatIsWrittenIsReadBack) {
  surface::HeightMap map;
  map.points_x = 3;
  map.points_y = 3;
  map.step_x_m = 1e-6 / 3;
  map.step_y_m = 2e-6;
  for (int i = 0; i < 9; ++i) map.height_m.push_back(1e-7 * i);
  map.missing.assign(9, 0);
  map.missing[4] = 1;
  const surface::HeightMap back = read_bytes("a.gsf", simple_field_bytes(map, "made")).map;
  EXPECT_EQ(back.missing, map.missing);
  EXPECT_DOUBLE_EQ(back.step_x_m, map.step_x_m);
  for (std::size_t i : {0, 1, 2, 3, 5, 8}) EXPECT_EQ(back.height_m[i], static_cast<float>(map.height_m[i]));
}

}  // namespace
}  // namespace ringfilm::instrument
