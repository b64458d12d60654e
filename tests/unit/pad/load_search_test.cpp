#include "ringfilm/pad/load_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "pad_cases.hpp"

/// Pads under a load whose films are hard to find.
namespace ringfilm::pad::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string reason_of_stop(const cycle::Case& c) {
  try {
    solve_pad(c);
  } catch (const StoppedPad& stopped) {
    return stopped.what();
  }
  return "";
}

/// Separation and load of a stated separation are those of the load.
void expect_found(cycle::Case c, double separation) {
  c.pad.load.reset();
  c.pad.separation = separation;
  const double load = solved(c).load;
  c.pad.separation.reset();
  c.pad.load = load;
  const Sample s = solved(c);
  EXPECT_NEAR(s.load / load, 1, 1e-6);
  EXPECT_NEAR(s.separation / separation, 1, 1e-4);
}

/// A pocket, a ridge and a notch of a few cells each, which half as many cells do not resolve: they carry 70 times as
/// much at the same separation.
cycle::Case narrow_features() {
  cycle::Case c = slider();
  c.pad.length = 122.148644e-6;
  c.pad.gap_x = {0,
                 16.4828452e-6,
                 16.4828452e-6,
                 33.4375357e-6,
                 36.4146504e-6,
                 37.4106319e-6,
                 54.8629505e-6,
                 81.9077484e-6,
                 87.3280736e-6,
                 95.1669048e-6,
                 120.521373e-6,
                 122.148644e-6};
  c.pad.gap_height = {1.49479341e-6, 0.697180463e-6, 4.40583852e-6, 0.31984289e-6, 1.33499314e-6, 3.31322001e-6,
                      17.1564041e-6, 9.04013108e-6,  17.0414905e-6, 4.40459234e-6, 7.05813043e-6, 0.196661909e-6};
  c.pad.speed = 0.163834;
  c.pad.direction = cycle::Direction::kMinusX;
  c.lubricant.viscosity = 49.627e-3;
  c.film.cavitation = cycle::Cavitation::kMassConserving;
  c.solver.cells = 400;
  return c;
}

TEST(LoadSearch, FindsTheFilmOnTheGridOfTheCase) {
  for (const double separation : {0.5e-6, 0.8e-6, 0.9e-6, 2e-6}) expect_found(narrow_features(), separation);
}

TEST(LoadSearch, FindsTheFilmJustAboveTheThinnestThatExists) {
  // Barus' law, eq-barus: films below some thickness do not exist, and the load rises steeply towards it.
  cycle::Case c = slider();
  c.lubricant.viscosity_pressure = cycle::ViscosityPressure::kBarus;
  c.lubricant.law_parameters["pressure_viscosity_coefficient"] = 2e-8;
  c.pad.separation.reset();
  c.pad.load = 1e9;
  EXPECT_THAT(reason_of_stop(c), AllOf(HasSubstr("were not found"), HasSubstr("1/alpha"), HasSubstr("largest load")));
  LoadSearch search;
  {
    const PadSetup setup = prepare_pad(c);
    PadFilms films(setup);
    Effort effort;
    search = steady_film_under(films, 1e9, effort);
  }
  ASSERT_TRUE(search.most && !search.film);
  c.pad.load = 0.99 * search.most->load;
  EXPECT_NEAR(solved(c).load / *c.pad.load, 1, 1e-6);
}

TEST(LoadSearch, FindsALoadBetweenTwoFilmsOfTheScanNearItsLargest) {
  // Flat lands with a pocket between them: the load is largest at one separation.
  cycle::Case c = slider();
  c.pad.gap_x = {0, 1e-3, 1e-3, 6e-3, 6e-3, kLength};
  c.pad.gap_height = {0, 0, 20e-6, 20e-6, 0, 0};
  c.pad.speed = 1;
  c.lubricant.viscosity = 0.01;
  c.pad.left_pressure = c.pad.right_pressure = 1e5;
  c.pad.separation.reset();
  c.pad.load = 1e9;
  const PadSetup setup = prepare_pad(c);
  PadFilms films(setup);
  Effort effort;
  const LoadSearch search = steady_film_under(films, 1e9, effort);
  ASSERT_TRUE(search.most);
  c.pad.load = search.most->load * (1 - 1e-6);
  EXPECT_NEAR(solved(c).load / *c.pad.load, 1, 1e-6);
}

TEST(LoadSearch, ReportsTheRangeAndThatTheGapMakesNoPressure) {
  cycle::Case c = slider();
  c.pad.direction = cycle::Direction::kMinusX;  // the gap opens in the direction of motion
  c.film.cavitation = cycle::Cavitation::kMassConserving;
  c.pad.separation.reset();
  c.pad.load = 10;
  EXPECT_THAT(reason_of_stop(c), AllOf(HasSubstr("from 1e+04 um, the length of the pad"), HasSubstr("of molecules"),
                                       HasSubstr("each carries 0 N/m: the gap makes no pressure of its own")));
  c.pad.direction = cycle::Direction::kPlusX;
  c.pad.load = 1e15;
  EXPECT_THAT(reason_of_stop(c), HasSubstr("the largest load is"));
}

}  // namespace
}  // namespace ringfilm::pad::testing
