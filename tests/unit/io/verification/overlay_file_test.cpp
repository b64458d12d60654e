#include "ringfilm/io/verification/overlay_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class OverlayFile : public testing::Test {
 protected:
  std::vector<OverlayCurve> read(const std::string& text) {
    std::ofstream(path_) << text;
    return read_overlay(path_, Units());
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  }

 private:
  ScratchFolder folder_;
  std::string path_ = folder_ / "test_12.csv";
};

TEST_F(OverlayFile, GivesOneCurveAColumnInSi) {
  const auto curves = read(
      "crank_angle [degree],friction_on_liner [N],min_film_thickness [um],friction_coefficient\n"
      "-20,10.5,1.25,0.01\n"
      "20,-50,0.5,0.15\n");
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].name, "test_12");
  EXPECT_EQ(curves[0].quantity, "friction_on_liner");
  EXPECT_THAT(curves[0].crank_angle_deg, ElementsAre(-20, 20));
  EXPECT_THAT(curves[0].value, ElementsAre(10.5, -50));
  EXPECT_EQ(curves[1].quantity, "min_film_thickness");
  EXPECT_THAT(curves[1].value, ElementsAre(1.25e-6, 0.5e-6));
  EXPECT_THAT(curves[2].value, ElementsAre(0.01, 0.15));
}

TEST_F(OverlayFile, AnglesMayBeInRadians) {
  const auto curves = read("crank_angle [rad],power_loss [W]\n0,1\n3.141592653589793,2\n");
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_NEAR(curves[0].crank_angle_deg[1], 180, 1e-12);  // rounding of 180/pi
}

TEST_F(OverlayFile, TakesItsUnitsFromARowBelowTheNames) {
  const auto curves =
      read("crank_angle,min_film_thickness,friction_coefficient\ndeg,um,-\n-20,1.25,0.01\n20,0.5,0.15\n");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_THAT(curves[0].value, ElementsAre(1.25e-6, 0.5e-6));
  EXPECT_THAT(curves[1].value, ElementsAre(0.01, 0.15));
}

TEST_F(OverlayFile, RefusesWhatIsNotACurveOrHasNoUnit) {
  EXPECT_THAT(refusal("crank_angle [degree],frction_on_liner [N]\n0,1\n1,2\n"), HasSubstr("friction_on_liner"));
  EXPECT_THAT(refusal("crank_angle [degree],friction_on_liner\n0,1\n1,2\n"), HasSubstr("unit"));
  EXPECT_THAT(refusal("crank_angle [degree],friction_on_liner [um]\n0,1\n1,2\n"), HasSubstr("friction_on_liner"));
  EXPECT_THAT(refusal("friction_on_liner [N],power_loss [W]\n0,1\n1,2\n"), HasSubstr("crank_angle"));
  EXPECT_THAT(refusal("crank_angle [degree]\n0\n1\n"), HasSubstr("beside the crank angle"));
}

TEST_F(OverlayFile, RefusesAnglesThatFallOrLieOutsideOfACycle) {
  const std::string head = "crank_angle [degree],power_loss [W]\n";
  EXPECT_THAT(refusal(head + "0,1\n20,2\n10,3\n"), HasSubstr("4:1: the crank angle falls from 20 to 10 degree"));
  EXPECT_THAT(refusal(head + "0,1\n0,2\n"), HasSubstr("the crank angle 0 degree comes twice"));
  EXPECT_THAT(refusal(head + "0,1\n1e9,2\n"), HasSubstr("the crank angle 1e+09 degree is not within"));
  EXPECT_THAT(refusal(head + "-360,1\n370,2\n"), HasSubstr("the crank angles span 730 degree"));
  EXPECT_EQ(refusal(head + "-360,1\n360,2\n"), "not refused");
  EXPECT_EQ(refusal(head + "0,1\n720,2\n"), "not refused");
}

TEST_F(OverlayFile, ReportsAllFaultsAtOnce) {
  const std::string printed = refusal("crank_angle,frction_on_liner [N],power_loss [m]\n0,1,2\n1,2,3\n");
  EXPECT_THAT(printed, HasSubstr("crank_angle"));
  EXPECT_THAT(printed, HasSubstr("frction_on_liner"));
  EXPECT_THAT(printed, HasSubstr("power_loss"));
}

}  // namespace
}  // namespace ringfilm::io
