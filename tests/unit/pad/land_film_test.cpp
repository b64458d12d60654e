#include "ringfilm/pad/land_film.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/models/land/land_lift.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"

namespace ringfilm::pad::testing {
namespace {

constexpr double kWidth = 100e-6, kSpeed = 8, kViscosity = 6e-3;

/// A wave along the motion: the gap is the separation and `height` times sin(kx) [m].
surface::HeightMap wave(double height, std::size_t points) {
  surface::HeightMap map;
  map.points_x = points;
  map.points_y = 24;
  map.step_x_m = map.step_y_m = kWidth / static_cast<double>(points);
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < points; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(points);
      map.height_m.push_back(-height * std::sin(2 * std::numbers::pi * x));
    }
  }
  return map;
}

LandFilmProblem land_on(surface::HeightMap map, std::vector<double> separations) {
  LandFilmProblem land;
  land.surface = std::move(map);
  land.width = kWidth;
  land.speed = kSpeed;
  land.viscosity = kViscosity;
  land.sides = film::Ends::kJoined;
  land.separations = std::move(separations);
  return land;
}

/// Mean pressure of a full film of the gap s + e sin(kx) between edges at zero, by the trapezoidal rule.
double lift_of_wave(double s, double e) {
  constexpr int kPoints = 20000;
  const auto gap = [&](double part) { return s + e * std::sin(2 * std::numbers::pi * part); };
  double square = 0, cube = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double h = gap(static_cast<double>(i) / kPoints);
    square += 1 / (h * h * kPoints);
    cube += 1 / (h * h * h * kPoints);
  }
  double pressure = 0, mean = 0;
  const auto slope = [&](double part) {
    const double h = gap(part);
    return 6 * kViscosity * kSpeed * kWidth * (1 / (h * h) - square / cube / (h * h * h));
  };
  for (int i = 0; i < kPoints; ++i) {
    const double before = pressure;
    pressure += 0.5 * (slope(static_cast<double>(i) / kPoints) + slope((i + 1.0) / kPoints)) / kPoints;
    mean += 0.5 * (before + pressure) / kPoints;
  }
  return mean;
}

TEST(LandFilm, AFlatLandOnASmoothLinerHasNoLift) {
  const LandFilm film = land_film(land_on(wave(0, 48), {1e-6}));
  EXPECT_NEAR(film.points[0].lift, 0, 1e-3);  // round-off of 1 bar
  EXPECT_NEAR(film.points[0].friction_stress / (kViscosity * kSpeed / 1e-6), 1, 1e-9);
  EXPECT_NEAR(film.points[0].flow / 0.5e-6, 1, 1e-9);
  EXPECT_DOUBLE_EQ(film.points[0].mean_gap, 1e-6);
}

TEST(LandFilm, ASmallWaveLiftsByItsClosedForm) {
  // eq-land-wave: 6 eta U e/(k s^3). The second power of e/s has 3 e^2/s^2 = 3e-4, the cells 2 (pi/n)^2 = 2e-3 at most.
  constexpr double s = 2e-6, e = 0.02e-6;
  const LandFilm film = land_film(land_on(wave(e, 96), {s}));
  const double k = 2 * std::numbers::pi / kWidth;
  EXPECT_NEAR(film.points[0].lift / (6 * kViscosity * kSpeed * e / (k * s * s * s)), 1, 3e-3);
  EXPECT_EQ(film.points[0].cavitated_fraction, 0);
}

TEST(LandFilm, ADeepWaveLiftsByTheIntegralOfItsFullFilm) {
  constexpr double s = 1e-6, e = 0.5e-6;
  LandFilmProblem land = land_on(wave(e, 96), {s});
  land.ambient_pressure = 1e9;  // no cavities
  const double coarse = land_film(land).points[0].lift / lift_of_wave(s, e) - 1;
  land.surface = wave(e, 192);
  const double fine = land_film(land).points[0].lift / lift_of_wave(s, e) - 1;
  EXPECT_LT(std::abs(fine), 5e-3);
  EXPECT_LT(std::abs(fine), 0.4 * std::abs(coarse));  // second order in the cells
}

TEST(LandFilm, HalfTheCellsGiveTheSameLiftOfAHone) {
  surface::SurfaceGrid grid;
  grid.points_x = grid.points_y = 128;
  grid.step_x_m = grid.step_y_m = 1e-6;
  surface::HeightMap fine = surface::honed_surface(grid, {}, 3), coarse;
  coarse.points_x = coarse.points_y = 64;
  coarse.step_x_m = coarse.step_y_m = 2e-6;
  for (std::size_t j = 0; j < 64; ++j) {
    for (std::size_t i = 0; i < 64; ++i) coarse.height_m.push_back(fine.height_m[fine.index(2 * i, 2 * j)]);
  }
  LandFilmProblem land = land_on(fine, {2e-6});
  land.sides = film::Ends::kClosed;
  const double lift = land_film(land).points[0].lift;
  land.surface = coarse;
  // The plateau has a correlation length of 5 um and grooves of 12 um: cells of 2 um err by a few percent.
  EXPECT_NEAR(land_film(land).points[0].lift, lift, 0.05 * std::abs(lift) + 500);
}

TEST(LandFilm, ConvergesDownToALowestGapOf20Nanometres) {
  surface::SurfaceGrid grid;
  grid.points_x = grid.points_y = 96;
  grid.step_x_m = grid.step_y_m = 1e-6;
  LandFilmProblem land = land_on(surface::honed_surface(grid, {}, 1), {});
  land.width = 90e-6;
  land.sides = film::Ends::kClosed;
  const double highest = *std::max_element(land.surface.height_m.begin(), land.surface.height_m.end());
  land.separations = {highest + 0.02e-6, highest + 0.08e-6, highest + 0.3e-6};
  const LandFilm film = land_film(land);
  EXPECT_NEAR(film.points[0].lowest_gap, 0.02e-6, 1e-12);
  EXPECT_GT(film.points[0].lift, film.points[1].lift);
  EXPECT_GT(film.points[1].lift, film.points[2].lift);
  EXPECT_GT(film.points[0].cavitated_fraction, 0.01);
  for (const LandFilmPoint& point : film.points) EXPECT_LT(point.iterations, 100);
}

TEST(LandFilm, RefusesWhatItCannotCompute) {
  const auto message = [](const LandFilmProblem& land) {
    try {
      land_film(land);
    } catch (const InputError& refusal) {
      return refusal.faults().front().message;
    }
    return std::string("accepted");
  };
  EXPECT_THAT(message(land_on(wave(0.5e-6, 48), {0.4e-6})), ::testing::HasSubstr("touch"));
  LandFilmProblem wide = land_on(wave(0.5e-6, 48), {1e-6});
  wide.width = 2 * kWidth;
  EXPECT_THAT(message(wide), ::testing::HasSubstr("wide"));
  LandFilmProblem missing = land_on(wave(0.5e-6, 48), {1e-6});
  missing.surface.missing.assign(missing.surface.points(), 0);
  missing.surface.missing[5] = 1;
  EXPECT_THAT(message(missing), ::testing::HasSubstr("no height"));
}

models::LandTable table() {
  return {{1e-6, 1.4e-6, 2e-6, 3e-6}, {266e3, 108e3, 31e3, 4e3}, {0.9, 0.95, 1, 1}, 0.048, 1.2};
}

TEST(LandLift, HasTheRowsAndTheSlopeOfItsValues) {
  const models::LandLift lift(table());
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(lift.at(table().separation[k], 0.048).lift / table().lift[k], 1, 1e-12);
  }
  for (const double h : {0.5e-6, 1.2e-6, 2.7e-6, 6e-6}) {
    const double d = 1e-5 * h;
    const double slope = (lift.at(h + d, 0.03).lift - lift.at(h - d, 0.03).lift) / (2 * d);
    EXPECT_NEAR(lift.at(h, 0.03).lift_slope / slope, 1, 1e-6);
    EXPECT_LT(slope, 0);
    EXPECT_NEAR(lift.at(h, 0.06).lift / lift.at(h, 0.03).lift, std::pow(2, 1.2), 1e-12);
  }
  EXPECT_EQ(lift.at(1e-6, 0).lift, 0);
}

TEST(LandLift, AFitFindsThePowerLawThatMadeItsRows) {
  constexpr double sigma = 0.4e-6, width = 0.15e-3, eta_U = 0.048;
  std::vector<double> separation = {1e-6, 1.5e-6, 2e-6, 4e-6}, lift;
  for (const double s : separation) lift.push_back(0.03 * eta_U * width / (sigma * sigma) * std::pow(s / sigma, -3.1));
  const models::LandFit fit = models::fit_land(separation, lift, sigma, width, eta_U);
  EXPECT_NEAR(fit.coefficient, 0.03, 1e-12);
  EXPECT_NEAR(fit.exponent, 3.1, 1e-12);
  EXPECT_LT(fit.residual, 1e-12);
}

TEST(LandLift, RefusesATableThatDoesNotFall) {
  models::LandTable rising = table();
  rising.lift[1] = 300e3;
  EXPECT_THROW(models::LandLift{rising}, InputError);
  models::LandTable few = table();
  few.separation.resize(2);
  few.lift.resize(2);
  few.friction_factor.resize(2);
  EXPECT_THROW(models::LandLift{few}, InputError);
}

}  // namespace
}  // namespace ringfilm::pad::testing
