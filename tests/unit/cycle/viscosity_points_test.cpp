#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ringfilm/cycle/setup/oil_setup.hpp"

namespace ringfilm::cycle {
namespace {

using testing::Contains;
using testing::Not;

Lubricant oil_with(std::vector<TemperatureValue> viscosities) {
  Lubricant oil;
  oil.kinematic_viscosity = std::move(viscosities);
  oil.constant_density = 850;
  return oil;
}

std::vector<std::string> topics_of_notes(const Lubricant& oil, double temperature) {
  std::vector<std::string> topics;
  for (const Note& note : prepared_oil(oil, std::nullopt, {temperature, 0.1}).notes) topics.push_back(note.topic);
  return topics;
}

double kinematic(const Lubricant& oil, double temperature) {
  const OilSetup setup = prepared_oil(oil, std::nullopt, {temperature, 0.1}).setup;
  return setup.viscosity / setup.density;
}

TEST(ViscosityPoints, AnIndexStandsForTheSecondPoint) {
  Lubricant oil = oil_with({{313.15, 22.83e-6}});
  oil.viscosity_index = 156;  // the second example of ASTM D2270: 5.05 mm2/s at 100 degC; half a unit of the index
  EXPECT_NEAR(kinematic(oil, 373.15), 5.05e-6, 0.02e-6);
  EXPECT_NEAR(kinematic(oil, 313.15), 22.83e-6, 1e-12);
  EXPECT_NEAR(kinematic(oil, 423.15), kinematic(oil_with({{313.15, 22.83e-6}, {373.15, 5.05e-6}}), 423.15), 0.02e-6);
}

TEST(ViscosityPoints, AThirdPointReachesToHotWalls) {
  const Lubricant two = oil_with({{313.15, 60e-6}, {373.15, 9.6e-6}});
  EXPECT_THAT(topics_of_notes(two, 423.15), Contains("viscosity-extrapolated"));
  const Lubricant three = oil_with({{313.15, 60e-6}, {373.15, 9.6e-6}, {423.15, kinematic(two, 423.15)}});
  EXPECT_THAT(topics_of_notes(three, 423.15), Not(Contains("viscosity-extrapolated")));
  EXPECT_THAT(topics_of_notes(three, 423.15), Not(Contains("viscosity-off-line")));
  EXPECT_NEAR(kinematic(three, 400), kinematic(two, 400), 1e-9 * kinematic(two, 400));
}

TEST(ViscosityPoints, APointOffTheLineOfTheOthersIsNoted) {
  EXPECT_THAT(topics_of_notes(oil_with({{313.15, 60e-6}, {373.15, 9.6e-6}, {423.15, 5e-6}}), 373.15),
              Contains("viscosity-off-line"));
}

}  // namespace
}  // namespace ringfilm::cycle
