#include "ringfilm/instrument/formats/map_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/base/error.hpp"
#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using testing::HasSubstr;

surface::HeightMap example() {
  surface::HeightMap map;
  map.points_x = 7;
  map.points_y = 5;
  map.step_x_m = 0.5e-6;
  map.step_y_m = 1.25e-6;
  for (int i = 0; i < 35; ++i) map.height_m.push_back(1e-6 * std::sin(1.7 * i));
  map.missing.assign(35, 0);
  map.missing[9] = 1;
  map.height_m[9] = 0;
  return map;
}

struct Ending {
  const char* name;
  double step_m;  ///< of the heights in the file
};

class EveryFormat : public testing::TestWithParam<Ending> {};

TEST_P(EveryFormat, IsReadBackWithoutOptions) {
  const auto [name, step_m] = GetParam();
  const surface::HeightMap map = example();
  const std::string bytes = map_bytes(map, map_format_of(name), "SYNTHETIC", "a maker, seed 7");
  EXPECT_EQ(bytes, map_bytes(map, map_format_of(name), "SYNTHETIC", "a maker, seed 7"));
  const SurfaceFile back = read_bytes(name, bytes);
  ASSERT_EQ(back.map.points_x, 7u);
  ASSERT_EQ(back.map.points_y, 5u);
  // Single precision of step and size in SUR.
  EXPECT_NEAR(back.map.step_x_m, 0.5e-6, 1e-13);
  EXPECT_NEAR(back.map.step_y_m, 1.25e-6, 1e-13);
  EXPECT_EQ(back.map.missing, map.missing);
  for (std::size_t i = 0; i < 35; ++i) EXPECT_NEAR(back.map.height_m[i], map.height_m[i], 0.51 * step_m) << i;
}

// X3P and text keep every bit (a step of round-off); SUR has steps of 1 pm, kept in single precision; GSF has singles.
INSTANTIATE_TEST_SUITE_P(MapWriter, EveryFormat,
                         testing::Values(Ending{"a.x3p", 1e-21}, Ending{"a.sur", 1.2e-12}, Ending{"a.gsf", 1.2e-13},
                                         Ending{"a.csv", 1e-21}));

TEST(MapWriter, FilesContainWhatMadeThem) {
  const auto read = [](const char* name) {
    return read_bytes(name, map_bytes(example(), map_format_of(name), "SYNTHETIC", "a maker, seed 7")).origin;
  };
  EXPECT_EQ(read("a.x3p").instrument, "SYNTHETIC a maker, seed 7");
  EXPECT_THAT(read("a.sur").notes, testing::Contains("comment in the file: a maker, seed 7"));
  EXPECT_EQ(read("a.sur").channel, "SYNTHETIC");
  EXPECT_EQ(read("a.gsf").channel, "SYNTHETIC, a maker, seed 7");
  const std::string text = map_bytes(example(), MapFormat::kMatrix, "SYNTHETIC", "a maker,\nseed 7");
  EXPECT_EQ(text.rfind("# SYNTHETIC\n# a maker, seed 7\n", 0), 0u);
}

TEST(MapWriter, OtherEndingsAreRefused) {
  for (const char* name : {"a.sdf", "a", "a.X3P", "x3p"}) {
    try {
      map_format_of(name);
      FAIL() << name;
    } catch (const InputError& refusal) {
      EXPECT_THAT(refusal.what(), HasSubstr("end it in .x3p, .sur, .gsf or .csv"));
    }
  }
}

}  // namespace
}  // namespace ringfilm::instrument
