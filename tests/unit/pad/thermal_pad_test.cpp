#include <gtest/gtest.h>

#include <cmath>

#include "pad_cases.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::pad::testing {
namespace {

constexpr double kCelsius = 273.15;

cycle::Case between_walls(double pad, double surface) {
  cycle::Case c = slider();
  c.lubricant.constant_density.reset();
  c.lubricant.density = {{kCelsius + 15, 850}, {kCelsius + 40, 834}};
  c.lubricant.kinematic_viscosity = {{kCelsius + 40, 60e-6}, {kCelsius + 100, 9.6e-6}};
  c.thermal.ring = kCelsius + pad;
  c.thermal.liner = {{0, kCelsius + surface}};
  return c;
}

TEST(PadTemperature, OfAlikeWallsIsThatOfOneViscosity) {
  const cycle::Case c = between_walls(100, 100);
  cycle::Case isothermal = slider();
  const PadSetup setup = prepare_pad(c);
  EXPECT_NEAR(setup.viscosity / (9.6e-6 * setup.density), 1, 1e-9);
  isothermal.lubricant.viscosity = setup.viscosity;
  isothermal.lubricant.constant_density = setup.density;
  const Sample s = solved(c), one = solved(isothermal);
  EXPECT_EQ(s.load, one.load);
  EXPECT_EQ(s.friction_moving, one.friction_moving);
  EXPECT_EQ(s.flow_left, one.flow_left);
  EXPECT_EQ(s.film_temperature, kCelsius + 100);
  EXPECT_TRUE(std::isnan(one.film_temperature));
}

TEST(PadTemperature, IsThatOfTheWallsAskedFor) {
  cycle::Case c = between_walls(140, 60);
  EXPECT_NEAR(solved(c).load / solved(between_walls(100, 100)).load, 1, 1e-9);
  c.thermal.film = cycle::FilmTemperature::kRing;
  EXPECT_NEAR(solved(c).load / solved(between_walls(140, 140)).load, 1, 1e-9);
  c.thermal.film = cycle::FilmTemperature::kLiner;
  EXPECT_NEAR(solved(c).load / solved(between_walls(60, 60)).load, 1, 1e-9);
}

TEST(PadTemperature, ScalesTheCriticalShearRateWithTheViscosity) {
  cycle::Case c = between_walls(100, 100);
  c.lubricant.shear_thinning = cycle::ShearThinning::kCross;
  c.lubricant.critical_shear_rate = 1e5;
  c.lubricant.critical_shear_rate_temperature = kCelsius + 100;
  const double load = solved(c).load;
  const double stress = 1e5 * prepare_pad(c).viscosity;
  c.thermal.ring = kCelsius + 140;
  ASSERT_TRUE(prepare_pad(c).factors.thinning);
  EXPECT_NEAR(prepare_pad(c).factors.thinning->critical_stress / stress, 1, 1e-12);
  EXPECT_LT(solved(c).load, load);
}

// Rayleigh's dissipation eta U^2/h, lost through h to both walls: eta U^2/(12 k), where conduction carries all heat.
TEST(PadTemperature, RisesByTheHeatOfALongParallelFilm) {
  cycle::Case c = slider();
  c.pad.length = 1;
  c.pad.gap_x = {0, 1};
  c.pad.gap_height = {1e-6, 1e-6};
  c.pad.speed = 6.5;
  c.lubricant.viscosity = 5.06e-3;
  c.lubricant.thermal_conductivity = 0.14;
  EXPECT_NEAR(solved(c).viscous_heating_rise / (5.06e-3 * 6.5 * 6.5 / (12 * 0.14)), 1, 1e-5);
}

}  // namespace
}  // namespace ringfilm::pad::testing
