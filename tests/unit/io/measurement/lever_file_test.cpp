#include "ringfilm/io/measurement/lever_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../case_example.hpp"

namespace ringfilm::io {
namespace {

using surface::LoadUnit;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kSmall =
    "shape = \"rectangular\"\nlength = \"450 um +- 5 um\"\ntip_height = \"17 um +- 1 um\"\npoissons_ratio = 0.27\n";
const std::string kWhole = kSmall +
                           "sensitivity_ratio = \"1.1 +- 0.05\"\nyoungs_modulus = \"169 GPa +- 5 GPa\"\n"
                           "width = \"50 um +- 4 %\"\nthickness = \"(2 +- 0.1) um\"\n"
                           "torsional_sensitivity = \"0.05 V/nm +- 5 %\"\n";

LeverFile read_text(const std::string& text, LoadUnit unit) {
  const ScratchFolder folder;
  write_text(folder / "lever.toml", text);
  return read_lever({folder / "lever.toml", "lever.toml"}, unit, Units());
}

std::string message_of_lever(const std::string& text, LoadUnit unit = LoadUnit::kVolt) {
  try {
    read_text(text, unit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LeverFile, HoldsSizesWithTheirDeviations) {
  const surface::Lever lever = read_text(kWhole, LoadUnit::kNewton).lever;
  EXPECT_EQ(lever.shape, surface::LeverShape::kRectangular);
  EXPECT_DOUBLE_EQ(lever.length_m.value, 450e-6);
  EXPECT_DOUBLE_EQ(lever.length_m.deviation, 5e-6);
  EXPECT_DOUBLE_EQ(lever.tip_height_m.value, 17e-6);
  EXPECT_DOUBLE_EQ(lever.poissons_ratio.value, 0.27);
  EXPECT_EQ(lever.poissons_ratio.deviation, 0);
  EXPECT_DOUBLE_EQ(lever.sensitivity_ratio.value, 1.1);
  EXPECT_DOUBLE_EQ(lever.youngs_modulus_Pa.value, 169e9);
  EXPECT_DOUBLE_EQ(lever.width_m.deviation, 2e-6);
  EXPECT_DOUBLE_EQ(lever.thickness_m.deviation, 0.1e-6);
  EXPECT_DOUBLE_EQ(lever.torsional_sensitivity_V_per_m.value, 5e7);
}

TEST(LeverFile, RequiresTheSectionForLoadsInNewtonsOnly) {
  EXPECT_DOUBLE_EQ(read_text(kSmall, LoadUnit::kVolt).lever.sensitivity_ratio.value, 1);
  const std::string words = message_of_lever(kSmall, LoadUnit::kNewton);
  for (const char* key : {"youngs_modulus", "width", "thickness", "torsional_sensitivity"}) {
    EXPECT_THAT(words, HasSubstr(std::string(key) + " is missing: the loads are in newtons"));
  }
}

TEST(LeverFile, ReportsEveryFaultWithItsPlace) {
  const std::string words =
      message_of_lever("shape = \"round\"\nlenght = \"450 um\"\ntip_height = 17\npoissons_ratio = \"a third\"\n");
  EXPECT_THAT(words, HasSubstr("lever.toml:1:9: shape = \"round\" is not known"));
  EXPECT_THAT(words, HasSubstr("lever.toml:2:1: unknown key lenght"));
  EXPECT_THAT(words, HasSubstr("did you mean length?"));
  EXPECT_THAT(words, HasSubstr("length is missing"));
  EXPECT_THAT(words, HasSubstr("lever.toml:3:14: tip_height = 17 has no unit"));
  EXPECT_THAT(words, HasSubstr("lever.toml:4:18: poissons_ratio = \"a third\" does not start with a number"));
  EXPECT_THAT(message_of_lever("length = [1]\n"), HasSubstr("is not a text"));
  EXPECT_THAT(message_of_lever("length = \n"), HasSubstr("lever.toml:1"));
  EXPECT_THAT(message_of_lever(kWhole, LoadUnit::kNewton), Not(HasSubstr("lever")));
}

}  // namespace
}  // namespace ringfilm::io
