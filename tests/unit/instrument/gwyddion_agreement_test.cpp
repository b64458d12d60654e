#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ringfilm/instrument/formats/digital_surf_file.hpp"
#include "ringfilm/instrument/formats/gwy_file.hpp"
#include "ringfilm/instrument/formats/gwyddion_program.hpp"
#include "ringfilm/instrument/formats/simple_field_file.hpp"
#include "ringfilm/instrument/formats/x3p_writer.hpp"
#include "written_files.hpp"

/// Real files and files of our own, read by us and by gwyddion, which shares no line with us.
namespace ringfilm::instrument {
namespace {

/// What gwyddion reads, in metres.
ChannelValues by_gwyddion(const std::string& path, std::size_t channel = 0) {
  return read_gwy(path, converted_by_gwyddion(path)).values(channel);
}

double largest_difference(const surface::HeightMap& map, const std::vector<double>& heights) {
  double largest = map.height_m.size() == heights.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < heights.size() && largest < 1; ++i) {
    if (map.measured(i)) largest = std::max(largest, std::abs(map.height_m[i] - heights[i]));
  }
  return largest;
}

double largest_height(const surface::HeightMap& map) {
  double largest = 0;
  for (const double height : map.height_m) largest = std::max(largest, std::abs(height));
  return largest;
}

#define SKIP_WITHOUT_GWYDDION() \
  if (!has_gwyddion()) GTEST_SKIP() << "the program gwyddion is not installed"
#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no instrument file " << path

class RealFile : public testing::TestWithParam<const char*> {};

TEST_P(RealFile, HasTheHeightsThatGwyddionReads) {
  SKIP_WITHOUT_GWYDDION();
  const std::string path = instrument_sample(GetParam());
  SKIP_WITHOUT(path);
  const SurfaceFile ours = read_surface_file(path, {}, units());
  const ChannelValues theirs = by_gwyddion(path);
  EXPECT_EQ(ours.map.points_x, theirs.channel.points_x);
  EXPECT_EQ(ours.map.points_y, theirs.channel.points_y);
  EXPECT_NEAR(ours.map.step_x_m, theirs.step_x, 1e-12 * theirs.step_x);
  EXPECT_NEAR(ours.map.step_y_m, theirs.step_y, 1e-12 * theirs.step_y);
  // The same products in another order: some roundings of the largest height.
  EXPECT_LE(largest_difference(ours.map, theirs.value), 1e-15 * largest_height(ours.map) * 4);
}

INSTANTIATE_TEST_SUITE_P(OwnReaders, RealFile, testing::Values("x3p-2.x3p", "sdf-1.sdf", "sur-3.sur"));

TEST(RealFile, MissingPointsOfDigitalSurfAreAMask) {
  const std::string path = instrument_sample("sur-3.sur");
  SKIP_WITHOUT(path);
  const SurfaceFile file = read_surface_file(path, {}, units());
  // Counted in the bytes of the file: 32-bit numbers that are -2, the header states that there are special points.
  ASSERT_FALSE(file.map.missing.empty());
  const std::string bytes = [&path] {
    std::ifstream in(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  }();
  std::size_t missing = 0;
  for (std::size_t i = 512; i < bytes.size(); i += 4) missing += bytes.compare(i, 4, "\xFE\xFF\xFF\xFF") == 0 ? 1 : 0;
  EXPECT_GT(missing, 1000u);
  EXPECT_EQ(static_cast<std::size_t>(std::count(file.map.missing.begin(), file.map.missing.end(), 1)), missing);
}

TEST(RealFile, NanoscopeListsItsChannels) {
  SKIP_WITHOUT_GWYDDION();
  const std::string path = instrument_sample("di-3.di");
  SKIP_WITHOUT(path);
  try {
    const SurfaceFile file = read_surface_file(path, {}, units());
    ADD_FAILURE() << "took " << file.origin.channel << " of several channels of heights";
  } catch (const InputError& error) {
    EXPECT_THAT(describe(error.faults()), testing::HasSubstr("1: ZSensor [m], 256 x 256 points"));
  }
  SurfaceOptions options;
  options.channel = "ZSensor";
  const SurfaceFile file = read_surface_file(path, options, units());
  EXPECT_NEAR(file.map.step_x_m, 10e-6 / 256, 1e-15);
  EXPECT_EQ(file.origin.format, "read by gwyddion from nanoscope");
  const std::vector<ChannelValues> channels = read_channels(path);
  EXPECT_EQ(channels.size(), file.origin.channels.size());
  EXPECT_TRUE(std::any_of(channels.begin(), channels.end(),
                          [](const ChannelValues& values) { return values.channel.unit != "m"; }));
}

TEST(RealFile, ZygoAndAliconaComeThroughGwyddion) {
  SKIP_WITHOUT_GWYDDION();
  const std::string zygo = instrument_sample("metropro-1.dat"), alicona = instrument_sample("al3d-1.al3d");
  SKIP_WITHOUT(zygo);
  const SurfaceFile file = read_surface_file(zygo, {}, units());
  EXPECT_EQ(file.map.points_x, 640u);
  EXPECT_NEAR(file.map.step_x_m * 640, 0.703e-3, 0.0005e-3);  // as the list of the files states
  EXPECT_NEAR(file.map.step_y_m * 480, 0.527e-3, 0.0005e-3);
  const SurfaceFile depth = read_surface_file(alicona, {}, units());
  EXPECT_EQ(depth.origin.channel, "Depth");
  EXPECT_NEAR(depth.map.step_x_m, 0.438e-6, 0.0005e-6);
}

TEST(RealFile, InvalidPointsOfZygoAreMissing) {
  SKIP_WITHOUT_GWYDDION();
  const std::string path = instrument_sample("metropro-1.dat");
  SKIP_WITHOUT(path);
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::size_t first = bytes.size() - 640 * 480 * 4;  // the heights end the file
  for (const std::size_t point : {5, 6, 700}) bytes.replace(first + 4 * point, 4, "\x7F\xFF\xFF\xF8");
  const SurfaceFile file = read_bytes("a.dat", bytes);
  ASSERT_FALSE(file.map.missing.empty());
  EXPECT_EQ(std::count(file.map.missing.begin(), file.map.missing.end(), 1), 3);
  EXPECT_FALSE(file.map.measured(700));
}

surface::HeightMap uneven_map() {
  surface::HeightMap map;
  map.points_x = 37;
  map.points_y = 23;
  map.step_x_m = 0.4e-6;
  map.step_y_m = 0.7e-6;
  for (int j = 0; j < 23; ++j) {
    for (int i = 0; i < 37; ++i) map.height_m.push_back(1e-6 * std::sin(0.3 * i + 0.11 * i * j) - 2e-7 * j);
  }
  return map;
}

TEST(OurWriters, AreReadByGwyddionWithTheSameHeights) {
  SKIP_WITHOUT_GWYDDION();
  const surface::HeightMap map = uneven_map();
  const ScratchFolder folder;
  struct Written {
    std::string path;
    double tolerance;
  };
  const std::vector<Written> files = {
      {folder.write("a.x3p", x3p_bytes(map, X3pHeights::kDouble, {})), 0},
      {folder.write("b.x3p", x3p_bytes(map, X3pHeights::kInt16, {})), 7e-6 / 65000},  // less than one step of the range
      {folder.write("c.sur", digital_surf_bytes(map, 1e-12, "made")), 1e-12},         // one step
      {folder.write("d.gsf", simple_field_bytes(map, "made")), 5e-6 * 6e-8}};         // single precision
  for (const auto& [path, tolerance] : files) {
    const ChannelValues theirs = by_gwyddion(path);
    EXPECT_EQ(theirs.channel.points_x, 37u) << path;
    EXPECT_NEAR(theirs.step_x, 0.4e-6, 1e-13) << path;
    EXPECT_NEAR(theirs.step_y, 0.7e-6, 1e-13) << path;
    EXPECT_LE(largest_difference(map, theirs.value), tolerance) << path;
    EXPECT_LE(largest_difference(read_surface_file(path, {}, units()).map, theirs.value), 5e-6 * 1e-15 * 4) << path;
  }
}

TEST(OurWriters, HolesAreMaskedInGwyddionToo) {
  SKIP_WITHOUT_GWYDDION();
  surface::HeightMap map = uneven_map();
  map.missing.assign(map.points(), 0);
  for (const std::size_t point : {0, 1, 10, 100, 850}) {
    map.missing[point] = 1;
    map.height_m[point] = 0;
  }
  const ScratchFolder folder;
  EXPECT_EQ(by_gwyddion(folder.write("a.x3p", x3p_bytes(map, X3pHeights::kDouble, {}))).missing, map.missing);
  EXPECT_EQ(by_gwyddion(folder.write("b.x3p", x3p_bytes(map, X3pHeights::kInt16, {}))).missing, map.missing);
  EXPECT_EQ(by_gwyddion(folder.write("c.gsf", simple_field_bytes(map, "made"))).missing, map.missing);
}

TEST(ExportsOfGwyddion, AreReadWithTheSameHeights) {
  SKIP_WITHOUT_GWYDDION();
  const ScratchFolder folder;
  const std::string source = folder.write("source.x3p", x3p_bytes(uneven_map(), X3pHeights::kDouble, {}));
  std::string command = "HOME='" + folder.path() +
                        "' python3 '" RINGFILM_SOURCE_FOLDER "/tests/unit/instrument/gwyddion_export.py' '" + source +
                        "'";
  for (const char* name : {"a.gsf", "b.sdf", "c.sur"}) command += " '" + folder / name + "'";
  command += " >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "gwyddion's libraries cannot be driven here";
  const surface::HeightMap map = uneven_map();
  const double range = 7e-6;
  // Single precision; six digits of text; 2^30 steps over the range with a step and an offset in single precision.
  const std::vector<std::pair<const char*, double>> files = {
      {"a.gsf", range * 6e-8}, {"b.sdf", range * 5e-6}, {"c.sur", range * 1.2e-7}};
  for (const auto& [name, tolerance] : files) {
    const SurfaceFile ours = read_surface_file(folder / name, {}, units());
    EXPECT_EQ(ours.map.points_x, 37u) << name;
    EXPECT_NEAR(ours.map.step_x_m, 0.4e-6, 1e-12) << name;
    EXPECT_NEAR(ours.map.step_y_m, 0.7e-6, 1e-12) << name;
    EXPECT_LE(largest_difference(ours.map, map.height_m), tolerance) << name;
  }
}

}  // namespace
}  // namespace ringfilm::instrument
