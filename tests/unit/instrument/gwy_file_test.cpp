#include "ringfilm/instrument/formats/gwy_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using handmade::Bytes;
using testing::HasSubstr;

std::string name(const std::string& text) { return text + '\0'; }

std::string object(const std::string& kind, const std::string& body) {
  return name(kind) + Bytes().i32(static_cast<std::int64_t>(body.size())).str() + body;
}

std::string unit(const std::string& key, const std::string& text) {
  return name(key) + "o" + object("GwySIUnit", name("unitstr") + "s" + name(text));
}

std::string image(const std::vector<double>& values, const std::string& z_unit, int points_x = 3) {
  Bytes body;
  body.text(name("xres") + "i").i32(points_x).text(name("yres") + "i").i32(2);
  body.text(name("xreal") + "d").f64(6e-6).text(name("yreal") + "d").f64(8e-6);
  body.text(unit("si_unit_xy", "m"));
  if (!z_unit.empty()) body.text(unit("si_unit_z", z_unit));
  body.text(name("data") + "D").i32(static_cast<std::int64_t>(values.size()));
  for (const double value : values) body.f64(value);
  return object("GwyDataField", body);
}

std::string item(const std::string& key, const std::string& value) { return name(key) + value; }

std::string two_channels() {
  return "GWYP" +
         object("GwyContainer",
                item("/0/data", "o" + image({1e-9, 2e-9, 3e-9, 4e-9, 5e-9, 6e-9}, "m")) +
                    item("/0/data/title", "s" + name("Height")) + item("/0/mask", "o" + image({0, 0, 1, 0, 0, 0}, "")) +
                    item("/0/meta", "o" + object("GwyContainer", item("Date", "s" + name("yesterday")))) +
                    item("/0/show", std::string("b") + '\1') +
                    item("/0/log", "S" + Bytes().i32(2).str() + name("a") + name("b")) +
                    item("/1/data", "o" + image({1, 2, 3, 4, 5, 6}, "V")) +
                    item("/1/data/title", "s" + name("LateralForce")));
}

TEST(Gwy, ImagesWithMaskAndUnits) {
  const SurfaceFile file = read_bytes("a.gwy", two_channels());
  EXPECT_EQ(file.origin.channel, "Height");
  EXPECT_EQ(file.origin.date, "yesterday");
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 2e-6);
  EXPECT_DOUBLE_EQ(file.map.step_y_m, 4e-6);
  EXPECT_EQ(file.map.height_m[3], 4e-9);
  EXPECT_EQ(file.map.missing, (std::vector<std::uint8_t>{0, 0, 1, 0, 0, 0}));
  EXPECT_THAT(file.origin.notes, testing::Contains(HasSubstr("the only one in a unit of length")));
}

TEST(Gwy, AnyUnitComesAsAChannel) {
  const ScratchFolder folder;
  const std::vector<ChannelValues> channels = read_channels(folder.write("a.gwy", two_channels()));
  ASSERT_EQ(channels.size(), 2u);
  EXPECT_EQ(channels[1].channel.name, "LateralForce");
  EXPECT_EQ(channels[1].channel.unit, "V");
  EXPECT_EQ(channels[1].value[5], 6);
  EXPECT_DOUBLE_EQ(channels[1].step_x, 2e-6);
  SurfaceOptions options;
  options.channel = "LateralForce";
  EXPECT_THAT(refusal("a.gwy", two_channels(), options), HasSubstr("which is not a unit of length"));
  options.channel = "3";
  EXPECT_THAT(refusal("a.gwy", two_channels(), options), HasSubstr("there is no channel 3 among"));
}

std::string numbers(const std::string& key, const std::vector<double>& values) {
  Bytes body;
  body.text(name(key) + "D").i32(static_cast<std::int64_t>(values.size()));
  for (const double value : values) body.f64(value);
  return body;
}

/// A file with one graph of one curve, as gwyddion writes the profile of a stylus.
std::string one_curve(const std::vector<double>& x, const std::vector<double>& y) {
  const std::string curve =
      object("GwyGraphCurveModel", numbers("xdata", x) + numbers("ydata", y) + name("description") + "s" + name("Rz"));
  return "GWYP" + object("GwyContainer",
                         item("/0/graph/graph/1",
                              "o" + object("GwyGraphModel", unit("x_unit", "m") + unit("y_unit", "m") + name("curves") +
                                                                "O" + Bytes().i32(1).str() + curve)));
}

TEST(Gwy, ACurveIsAProfile) {
  const std::string bytes = one_curve({0, 1e-6, 2e-6, 3e-6}, {1e-9, 2e-9, 3e-9, 5e-9});
  const SurfaceFile file = read_bytes("a.gwy", bytes);
  EXPECT_TRUE(file.map.is_profile());
  EXPECT_EQ(file.origin.channel, "Rz");
  EXPECT_DOUBLE_EQ(file.map.step_x_m, 1e-6);
  EXPECT_EQ(file.map.height_m, (std::vector<double>{1e-9, 2e-9, 3e-9, 5e-9}));
  const SurfaceFile falling = read_bytes("a.gwy", one_curve({3e-6, 2e-6, 1e-6, 0}, {5e-9, 3e-9, 2e-9, 1e-9}));
  EXPECT_EQ(falling.map.height_m, file.map.height_m);
  EXPECT_THAT(refusal("a.gwy", one_curve({0, 1e-6, 1e-6, 3e-6}, {1, 2, 3, 5})), HasSubstr("its places do not rise"));
  EXPECT_THAT(refusal("a.gwy", one_curve({0, 1e-6}, {1})), HasSubstr("not as many heights as places"));
  for (std::size_t length = 4; length < bytes.size(); length += 7) {
    EXPECT_NE(refusal("a.gwy", bytes.substr(0, length)), "") << length << " of " << bytes.size() << " bytes";
  }
}

TEST(Gwy, DamagedFilesAreRefused) {
  const std::string whole = two_channels();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(refusal("a.gwy", whole.substr(0, length)), "") << length << " of " << whole.size() << " bytes";
  }
  const std::string few = "GWYP" + object("GwyContainer", item("/0/data", "o" + image({1, 2, 3}, "m")));
  EXPECT_THAT(refusal("a.gwy", few), HasSubstr("an image of 3 x 2 points has 3 values"));
  const std::string huge = "GWYP" + object("GwyContainer", item("/0/data", "o" + image({1}, "m", 2000000000)));
  EXPECT_THAT(refusal("a.gwy", huge), HasSubstr("over the limit"));
  EXPECT_THAT(refusal("a.gwy", "GWYP" + object("GwyContainer", "")), HasSubstr("the file holds no image and no curve"));
  std::string deep = "c" + std::string(1, '\0');
  for (int i = 0; i < 40; ++i) deep = "O" + Bytes().i32(1).str() + object("A", name("k") + deep);
  EXPECT_NE(refusal("a.gwy", "GWYP" + object("GwyContainer", name("k") + deep)), "");
}

}  // namespace
}  // namespace ringfilm::instrument
