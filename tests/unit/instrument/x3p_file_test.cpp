#include "ringfilm/instrument/formats/x3p_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ringfilm/instrument/formats/x3p_writer.hpp"
#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using handmade::Bytes;
using handmade::X3p;
using testing::Contains;
using testing::HasSubstr;

constexpr char kMask[] =
    "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><ValidPointsLink>bindata/valid.bin</ValidPointsLink>"
    "</DataLink>";

/// An X3P of six heights of one type.
X3p of_type(char type, const std::vector<double>& heights) {
  X3p x3p;
  x3p.axis_z = std::string("<AxisType>A</AxisType><DataType>") + type + "</DataType>";
  if (type == 'I' || type == 'L') x3p.axis_z += "<Increment>1e-9</Increment><Offset>5e-7</Offset>";
  Bytes points;
  for (const double height : heights) {
    if (type == 'I') points.i16(static_cast<std::int64_t>(height));
    if (type == 'L') points.i32(static_cast<std::int64_t>(height));
    if (type == 'F') points.f32(static_cast<float>(height));
    if (type == 'D') points.f64(height);
  }
  x3p.points = points;
  return x3p;
}

TEST(X3p, HeightsOfDoublePrecision) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SurfaceFile file = read_bytes("a.x3p", x3p_archive(of_type('D', {1e-6, 2e-6, nan, 4e-6, 5e-6, 6e-6})));
  ASSERT_EQ(file.map.points_x, 3u);
  ASSERT_EQ(file.map.points_y, 2u);
  EXPECT_EQ(file.map.step_x_m, 2e-6);
  EXPECT_EQ(file.map.step_y_m, 3e-6);
  EXPECT_EQ(file.map.height_m[4], 5e-6);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 0}));
  EXPECT_EQ(file.origin.instrument, "Maker One");
  EXPECT_EQ(file.origin.date, "2019-03-07T12:00:00");
  EXPECT_TRUE(file.origin.notes.empty());
}

TEST(X3p, HeightsOfTheOtherTypes) {
  const X3p single = of_type('F', {1e-6, 2e-6, 3e-6, 4e-6, 5e-7, 6e-6});
  EXPECT_EQ(read_bytes("a.x3p", x3p_archive(single)).map.height_m[4], 5e-7f);
  for (const char type : {'I', 'L'}) {
    const SurfaceFile file = read_bytes("a.x3p", x3p_archive(of_type(type, {-100, 200, 300, 400, 500, -600})));
    EXPECT_DOUBLE_EQ(file.map.height_m[0], 4e-7) << type;
    EXPECT_NEAR(file.map.height_m[5], -1e-7, 1e-21) << type;  // a sum of -600 nm and 500 nm, rounded
  }
}

TEST(X3p, AnIncrementOfFloatingPointHeightsIsDoubted) {
  X3p x3p = of_type('D', {1, 2, 3, 4, 5, 6});
  x3p.axis_z = "<AxisType>A</AxisType><DataType>D</DataType><Increment>1e-6</Increment><Offset/>";
  const SurfaceFile file = read_bytes("a.x3p", x3p_archive(x3p));
  EXPECT_DOUBLE_EQ(file.map.height_m[4], 5e-6);
  EXPECT_THAT(file.origin.doubts, testing::ElementsAre(HasSubstr("main.xml, CZ/Increment: heights of type D")));
  // In metres already: with the increment their rms height were 1.7 pm.
  x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
  x3p.axis_z = "<AxisType>A</AxisType><DataType>D</DataType><Increment>1e-6</Increment>";
  const SurfaceFile metres = read_bytes("a.x3p", x3p_archive(x3p));
  EXPECT_EQ(metres.map.height_m[4], 5e-6);
  EXPECT_THAT(metres.origin.doubts, testing::ElementsAre(HasSubstr("size of an atom: they were read without it")));
  EXPECT_TRUE(read_bytes("a.x3p", x3p_archive(of_type('I', {1, 2, 3, 4, 5, 6}))).origin.doubts.empty());
}

TEST(X3p, LinksAsWindowsWritesThem) {
  for (const char* link : {"bindata\\data.bin", "./bindata/data.bin"}) {
    X3p x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
    x3p.data = std::string("<DataLink><PointDataLink>") + link + "</PointDataLink></DataLink>";
    EXPECT_EQ(refusal("a.x3p", x3p_archive(x3p)), "") << link;
  }
}

TEST(X3p, ArchivesAsProgramsMakeThem) {
  X3p x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
  const auto zipped = [&](const std::string& before, const std::string& slash) {
    return handmade::zip({{before + "main.xml", x3p.xml()},
                          {before + "md5checksum.hex", md5(x3p.xml())},
                          {before + "bindata" + slash + "data.bin", x3p.points}});
  };
  for (const std::string before : {"", "scan/", "a/b/", "scan\\"}) {
    for (const char* slash : {"/", "\\"}) {
      const SurfaceFile file = read_bytes("a.x3p", zipped(before, slash));
      EXPECT_EQ(file.map.height_m[4], 5e-6) << before << slash;
      EXPECT_TRUE(file.origin.doubts.empty());
    }
  }
  x3p.root = "ISO5436";
  EXPECT_EQ(refusal("a.x3p", x3p_archive(x3p)), "");
  x3p.root = "svg";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("the root is not ISO5436_2"));
}

TEST(X3p, MainXmlInUtf16) {
  const X3p x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
  for (const bool high_byte_first : {false, true}) {
    std::string xml = high_byte_first ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : x3p.xml()) xml += high_byte_first ? std::string{'\0', c} : std::string{c, '\0'};
    const SurfaceFile file = read_bytes("a.x3p", handmade::zip({{"main.xml", xml}, {"bindata/data.bin", x3p.points}}));
    EXPECT_EQ(file.map.height_m[4], 5e-6);
    EXPECT_EQ(file.origin.instrument, "Maker One");
  }
  std::string xml = x3p.xml();
  xml[40] = '\0';
  EXPECT_THAT(refusal("a.x3p", handmade::zip({{"main.xml", xml}, {"bindata/data.bin", x3p.points}})),
              HasSubstr("main.xml, byte 40: a zero byte"));
}

TEST(X3p, DecimalCommasAreReadWithANote) {
  X3p x3p;
  x3p.data =
      "<DataList><Datum>1e-6</Datum><Datum>;;2,5e-6</Datum><Datum/><Datum>4e-6</Datum><Datum>5e-6</Datum><Datum>"
      "6e-6</Datum></DataList>";
  const SurfaceFile file = read_bytes("a.x3p", x3p_archive(x3p));
  EXPECT_DOUBLE_EQ(file.map.height_m[1], 2.5e-6);
  EXPECT_THAT(file.origin.doubts, testing::ElementsAre(HasSubstr("\";;2,5e-6\" has a decimal comma")));
  x3p.data.replace(x3p.data.find("2,5e-6"), 6, "2,500,0");
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("\"2,500,0\" is not a finite number"));
}

TEST(X3p, TheMaskOfValidPoints) {
  X3p x3p = of_type('I', {1, 2, 3, 4, 5, 6});
  x3p.data = kMask;
  x3p.valid = std::string(1, static_cast<char>(0b00111011));  // the first point is the lowest bit
  EXPECT_EQ(read_bytes("a.x3p", x3p_archive(x3p)).map.missing, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 0}));
  x3p.valid = "ab";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("bindata/valid.bin"));
}

TEST(X3p, PointsWithinTheXml) {
  X3p x3p;
  x3p.data =
      "<DataList><Datum>1e-6</Datum><Datum>;;2e-6</Datum><Datum/><Datum>4e-6</Datum><Datum>5e-6</Datum><Datum>"
      "6e-6</Datum></DataList>";
  const SurfaceFile file = read_bytes("a.x3p", x3p_archive(x3p));
  EXPECT_EQ(file.map.height_m[1], 2e-6);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 0}));
  x3p.data = "<DataList><Datum>1e-6</Datum></DataList>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("there are 1 points, and 6 are stated"));
  x3p.data = "<DataList><Datum>one</Datum><Datum/><Datum/><Datum/><Datum/><Datum/></DataList>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("main.xml, Datum 1: \"one\" is not a finite number"));
}

TEST(X3p, AListOfPointsInAnyOrderBecomesAGrid) {
  X3p x3p;
  x3p.axis_x = x3p.axis_y = "<AxisType>A</AxisType><DataType>D</DataType>";
  x3p.dimension = "<ListDimension>4</ListDimension>";
  Bytes points;  // 2 x 2, the last first
  points.f64(1e-6).f64(2e-6).f64(4e-9).f64(0).f64(2e-6).f64(3e-9).f64(1e-6).f64(0).f64(2e-9).f64(0).f64(0).f64(1e-9);
  x3p.points = points;
  const SurfaceFile file = read_bytes("a.x3p", x3p_archive(x3p));
  ASSERT_EQ(file.map.points_x, 2u);
  EXPECT_EQ(file.map.step_y_m, 2e-6);
  EXPECT_EQ(file.map.height_m, (std::vector<double>{1e-9, 2e-9, 3e-9, 4e-9}));
}

TEST(X3p, AProfileWithItsOwnPlaces) {
  X3p x3p;
  x3p.feature = "PRF";
  x3p.axis_x = "<AxisType>A</AxisType><DataType>F</DataType>";
  x3p.dimension = "<MatrixDimension><SizeX>3</SizeX><SizeY>1</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
  Bytes points;
  points.f32(0).f64(1e-9).f32(1e-6f).f64(2e-9).f32(4e-6f).f64(3e-9);
  x3p.points = points;
  const ScratchFolder folder;
  const TraceFile file = read_trace_file(folder.write("a.x3p", x3p_archive(x3p)), {}, units());
  EXPECT_EQ(file.trace.x_m[2], 4e-6f);
  EXPECT_EQ(file.trace.height_m, (std::vector<double>{1e-9, 2e-9, 3e-9}));
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("the places of the profile are not even"));
}

TEST(X3p, LayersAreChannels) {
  X3p x3p = of_type('I', {1, 2, 3, 4, 5, 6, 11, 12, 13, 14, 15, 16});
  x3p.dimension = "<MatrixDimension><SizeX>3</SizeX><SizeY>2</SizeY><SizeZ>2</SizeZ></MatrixDimension>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("the file has 2 channels"));
  SurfaceOptions options;
  options.channel = "2";
  const SurfaceFile file = read_bytes("a.x3p", x3p_archive(x3p), options);
  EXPECT_DOUBLE_EQ(file.map.height_m[0], 511e-9);
  EXPECT_EQ(file.origin.channel, "layer 2");
}

TEST(X3p, CheckSumsAreVerified) {
  X3p x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
  x3p.checksum = std::string(32, '0');
  EXPECT_THAT(read_bytes("a.x3p", x3p_archive(x3p)).origin.doubts,
              testing::ElementsAre(HasSubstr("md5checksum.hex states 000")));
  x3p.checksum = "";
  EXPECT_THAT(read_bytes("a.x3p", x3p_archive(x3p)).origin.notes, Contains(HasSubstr("could not be verified")));
  x3p.checksum = "right";
  const std::string link = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>";
  x3p.data = link + md5(x3p.points) + "</MD5ChecksumPointData></DataLink>";
  EXPECT_EQ(refusal("a.x3p", x3p_archive(x3p)), "");
  x3p.data = link + md5("other") + "</MD5ChecksumPointData></DataLink>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("bindata/data.bin has the check sum"));
}

TEST(X3p, FaultsNameTheirElement) {
  X3p x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6});
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("bindata/data.bin has 40 bytes, and 6 points of 8 bytes"));
  x3p.axis_z = "<AxisType>A</AxisType><DataType>Q</DataType>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("main.xml, CZ/DataType: \"Q\" is not known"));
  x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
  x3p.axis_x = "<AxisType>I</AxisType><Increment>wide</Increment>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("main.xml, CX/Increment: \"wide\""));
  x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
  x3p.dimension = "<MatrixDimension><SizeX>3</SizeX><SizeY>-2</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
  EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("SizeY"));
}

TEST(X3p, AStepMustBeAboveZero) {
  for (const std::string step : {"0", "-2e-6"}) {
    const std::string axis = "<AxisType>I</AxisType><DataType>D</DataType><Increment>" + step + "</Increment>";
    X3p x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
    x3p.axis_x = axis;
    EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("main.xml, CX/Increment: ")) << step;
    x3p = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
    x3p.axis_y = axis;
    EXPECT_THAT(refusal("a.x3p", x3p_archive(x3p)), HasSubstr("main.xml, CY/Increment: ")) << step;
    X3p heights = of_type('D', {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6});
    heights.axis_z += "<Increment>" + step + "</Increment>";
    EXPECT_THAT(refusal("a.x3p", x3p_archive(heights)), HasSubstr("main.xml, CZ/Increment: ")) << step;
    x3p.dimension = "<MatrixDimension><SizeX>6</SizeX><SizeY>1</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
    EXPECT_EQ(refusal("a.x3p", x3p_archive(x3p)), "") << "one row has no step along y";
  }
}

surface::HeightMap waves(bool with_hole) {
  surface::HeightMap map;
  map.points_x = 5;
  map.points_y = 4;
  map.step_x_m = 1e-6 / 3;
  map.step_y_m = 2e-6;
  for (int i = 0; i < 20; ++i) map.height_m.push_back(1e-6 * std::cos(1.1 * i) + 3e-6);
  if (!with_hole) return map;
  map.missing.assign(20, 0);
  map.missing[9] = map.missing[19] = 1;
  map.height_m[9] = map.height_m[19] = 0;
  return map;
}

TEST(X3pWriter, WhatIsWrittenIsReadBack) {
  for (const bool hole : {false, true}) {
    const surface::HeightMap map = waves(hole);
    X3pOrigin origin;
    origin.comment = "a < b & c";
    const std::string exact = x3p_bytes(map, X3pHeights::kDouble, origin);
    EXPECT_EQ(exact, x3p_bytes(map, X3pHeights::kDouble, origin)) << "the same map must give the same bytes";
    const SurfaceFile back = read_bytes("a.x3p", exact);
    EXPECT_EQ(back.map.height_m, map.height_m);
    EXPECT_EQ(back.map.missing, map.missing);
    EXPECT_EQ(back.map.step_x_m, map.step_x_m);
    EXPECT_TRUE(back.origin.notes.empty());
    const SurfaceFile coarse = read_bytes("a.x3p", x3p_bytes(map, X3pHeights::kInt16, origin));
    EXPECT_EQ(coarse.map.missing, map.missing);
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_NEAR(coarse.map.height_m[i], map.height_m[i], 2e-6 / 65000 / 2 * 1.001);  // half a step of its range
    }
  }
}

}  // namespace
}  // namespace ringfilm::instrument
