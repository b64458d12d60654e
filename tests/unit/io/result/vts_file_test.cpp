#include "ringfilm/io/result/vts_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <pugixml.hpp>

#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"

namespace {

using namespace ringfilm;
using testing::HasSubstr;

/// Two angles, three strips, two nodes across; every value reports its place: 100 x angle + 10 x strip + node.
cycle::UnrolledFields fields(double end_gap) {
  cycle::UnrolledFields f;
  f.circumference = 0.28;
  f.end_gap = end_gap;
  f.gap_position = 0.5;
  f.x = {0, 0.0012};
  f.y = {0, 0.1, 0.2797};
  f.crank_angle_deg = {0, 22.5};
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 2; ++i) f.film_pressure.push_back(static_cast<float>(100 * k + 10 * j + i));
    }
  }
  f.film_thickness = f.film_content = f.asperity_pressure = f.film_pressure;
  for (float& value : f.film_content) value /= 1000;
  return f;
}

/// Shares no line with the writer.
std::string decoded(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t held = 0;
  int n_bits = 0;
  for (const char c : text) {
    const std::size_t value = letters.find(c);
    if (value == std::string::npos) continue;
    held = held << 6 | static_cast<std::uint32_t>(value);
    n_bits += 6;
    if (n_bits >= 8) bytes.push_back(static_cast<char>(held >> (n_bits -= 8) & 0xFF));
  }
  return bytes;
}

template <class Number>
std::vector<double> numbers(const pugi::xml_node& array) {
  const std::string bytes = decoded(array.text().get());
  std::uint64_t n_bytes = 0;
  std::memcpy(&n_bytes, bytes.data(), sizeof n_bytes);
  EXPECT_EQ(bytes.size(), sizeof n_bytes + n_bytes);
  std::vector<Number> values(n_bytes / sizeof(Number));
  std::memcpy(values.data(), bytes.data() + sizeof n_bytes, n_bytes);
  return {values.begin(), values.end()};
}

struct Grid {
  pugi::xml_document xml;
  pugi::xml_node piece;

  explicit Grid(const std::string& text) {
    EXPECT_TRUE(xml.load_string(text.c_str()));
    piece = xml.child("VTKFile").child("StructuredGrid").child("Piece");
  }
  std::vector<double> field(const char* name) const {
    return numbers<float>(piece.child("PointData").find_child_by_attribute("DataArray", "Name", name));
  }
  std::vector<double> points() const { return numbers<double>(piece.child("Points").child("DataArray")); }
};

TEST(VtsFile, HoldsTheFieldsOfItsAngleWithXRunningFastest) {
  const Grid grid(io::vts_text(fields(0.0003), 1, io::VtsShape::kPlane));
  const pugi::xml_node root = grid.xml.child("VTKFile");
  EXPECT_STREQ(root.attribute("type").value(), "StructuredGrid");
  EXPECT_STREQ(root.attribute("byte_order").value(), "LittleEndian");
  EXPECT_STREQ(root.attribute("header_type").value(), "UInt64");
  EXPECT_STREQ(root.child("StructuredGrid").attribute("WholeExtent").value(), "0 1 0 2 0 0");
  EXPECT_STREQ(grid.piece.attribute("Extent").value(), "0 1 0 2 0 0");
  EXPECT_DOUBLE_EQ(root.child("StructuredGrid").child("FieldData").child("DataArray").text().as_double(), 22.5);
  const std::vector<double> expected = {100, 101, 110, 111, 120, 121};
  for (const char* name : {"film_pressure", "film_thickness", "asperity_pressure"}) {
    EXPECT_EQ(grid.field(name), expected) << name;
  }
  EXPECT_NEAR(grid.field("film_content")[3], 0.111, 1e-8);  // single precision
  EXPECT_EQ(grid.points(),
            (std::vector<double>{0, 0, 0, 0.0012, 0, 0, 0, 0.1, 0, 0.0012, 0.1, 0, 0, 0.2797, 0, 0.0012, 0.2797, 0}));
}

TEST(VtsFile, PutsTheRingOnItsBore) {
  const Grid grid(io::vts_text(fields(0.0003), 0, io::VtsShape::kCylinder));
  const std::vector<double> points = grid.points();
  ASSERT_EQ(points.size(), 18u);
  const double radius = 0.28 / (2 * std::numbers::pi);
  constexpr double kRounding = 1e-15;  // metres; some units in the last place of the radius
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(std::hypot(points[3 * k], points[3 * k + 1]), radius, kRounding);
    EXPECT_DOUBLE_EQ(points[3 * k + 2], k % 2 == 0 ? 0 : -0.0012);
  }
  // The ends are half a gap before and behind 0.5 rad.
  EXPECT_NEAR(std::atan2(points[1], points[0]), 0.5 + 0.00015 / radius, 1e-14);
  EXPECT_NEAR(std::atan2(points[13], points[12]), 0.5 - 0.00015 / radius, 1e-13);
}

TEST(VtsFile, ClosesARingWithoutAGap) {
  const Grid grid(io::vts_text(fields(0), 0, io::VtsShape::kCylinder));
  EXPECT_STREQ(grid.piece.attribute("Extent").value(), "0 1 0 3 0 0");
  EXPECT_EQ(grid.field("film_pressure"), (std::vector<double>{0, 1, 10, 11, 20, 21, 0, 1}));
  const std::vector<double> points = grid.points();
  ASSERT_EQ(points.size(), 24u);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(points[18 + k], points[k], 1e-15) << k;
}

TEST(VtsFile, ListsItsSeriesWithCrankAnglesAsTimes) {
  const io::ScratchFolder folder;
  const std::string path = io::write_vts_series(folder / "fields", "a & \"b\"", fields(0.0003), io::VtsShape::kPlane);
  EXPECT_EQ(path, folder / "fields/a & \"b\".pvd");
  pugi::xml_document list;
  ASSERT_TRUE(list.load_file(path.c_str()));
  std::vector<double> times;
  for (const pugi::xml_node& set : list.child("VTKFile").child("Collection").children("DataSet")) {
    times.push_back(set.attribute("timestep").as_double());
    pugi::xml_document grid;
    EXPECT_TRUE(grid.load_file((folder / "fields/" + set.attribute("file").value()).c_str()))
        << set.attribute("file").value();
  }
  EXPECT_EQ(times, (std::vector<double>{0, 22.5}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "fields"), {}), 3);
}

TEST(VtsFile, LeavesTheOldSeriesWhereTheNewOneCannotBeWritten) {
  const io::ScratchFolder folder;
  const std::string where = folder / "fields";
  // A value that is missing is found at the last angle alone, after the first has been written.
  cycle::UnrolledFields damaged = fields(0.0003);
  damaged.crank_angle_deg.push_back(45);
  std::filesystem::create_directories(where + "/a.pvd");  // a folder that no file can replace
  EXPECT_THROW(io::write_vts_series(where, "a", fields(0.0003), io::VtsShape::kPlane), OutputError);
  EXPECT_FALSE(std::filesystem::exists(where + "/a_0000.vts"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(where), {}), 1);
  EXPECT_THROW(io::write_vts_series(folder / "none", "a", damaged, io::VtsShape::kPlane), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(VtsFile, RemovesWhatAnOlderSeriesListsBeyondIt) {
  const io::ScratchFolder folder;
  const std::string where = folder / "fields";
  io::write_vts_series(where, "a", fields(0.0003), io::VtsShape::kPlane);
  std::ofstream(where + "/a_0007.vts") << "somebody's own";
  cycle::UnrolledFields one = fields(0.0003);
  one.crank_angle_deg.pop_back();
  for (const cycle::UnrolledField& field : cycle::unrolled_fields()) {
    (one.*field.values).resize((one.*field.values).size() / 2);
  }
  io::write_vts_series(where, "a", one, io::VtsShape::kPlane);
  EXPECT_TRUE(std::filesystem::exists(where + "/a_0000.vts"));
  EXPECT_FALSE(std::filesystem::exists(where + "/a_0001.vts"));
  EXPECT_TRUE(std::filesystem::exists(where + "/a_0007.vts"));
}

TEST(VtsFile, RefusesWhatHasNoFieldsOrNoFolder) {
  const io::ScratchFolder folder;
  EXPECT_THROW(io::write_vts_series(folder / "fields", "a", {}, io::VtsShape::kPlane), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "fields"));
  cycle::UnrolledFields short_of_one = fields(0.0003);
  short_of_one.film_content.pop_back();
  try {
    io::write_vts_series(folder / "fields", "a", short_of_one, io::VtsShape::kPlane);
    FAIL() << "a field with a value missing was written";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("film_content has 11 values"));
  }
  const std::string file = folder.write("file", "");
  EXPECT_THROW(io::check_can_write_series(file), InputError);
  EXPECT_THROW(io::check_can_write_series(folder / "none/fields"), InputError);
  EXPECT_NO_THROW(io::check_can_write_series(folder / "fields/"));
}

}  // namespace
