#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "pad_cases.hpp"

namespace ringfilm::pad::testing {
namespace {

constexpr double kN = 0.1e12, kBeta = 1.5e-6, kSigma = 0.5e-6, kE = 130e9, kZeta = 0.3;
constexpr double kWidth = 2.4e-3, kCrown = 45e-6;

/// Half of the width times itself over twice the height of the crown.
constexpr double kRadius = 0.5 * (0.5 * kWidth) * (0.5 * kWidth) / kCrown;

void add_contact(cycle::Case& c) {
  c.contact.asperity_density = kN;
  c.contact.asperity_radius = kBeta;
  c.contact.roughness = kSigma;
  c.contact.composite_modulus = kE;
  c.contact.boundary_shear_strength_coefficient = kZeta;
}

/// A parabola between edges of gas at no pressure, with a film on the surface that moves.
cycle::Case starved(double film, double separation) {
  cycle::Case c = cycle::blank_case(cycle::Problem::kPad);
  c.pad.length = kWidth;
  c.pad.face.form = cycle::FaceForm::kParabola;
  c.pad.face.crown_height = kCrown;
  c.pad.speed = 6.5;
  c.pad.separation = separation;
  c.lubricant.viscosity = 5e-3;
  c.lubricant.constant_density = 850;
  c.film.cavitation_pressure = 0;
  c.film.left_edge = c.film.right_edge = cycle::EdgeFluid::kGas;
  c.film.supply_left = film;
  c.solver.cells = 400;
  return c;
}

void set_load(cycle::Case& c, double load) {
  c.pad.separation.reset();
  c.pad.load = load;
}

/// (1/sqrt(2 pi)) int_lambda^inf (s - lambda)^3 exp(-s^2/2) ds.
double third_integral(double lambda) {
  const double density = std::exp(-lambda * lambda / 2) / std::sqrt(2 * std::numbers::pi);
  const double beyond = 0.5 * std::erfc(lambda / std::numbers::sqrt2);
  return (lambda * lambda + 2) * density - (lambda * lambda * lambda + 3 * lambda) * beyond;
}

/// Asperities of a parabola: int F_5/2(lambda + u^2) du over all u is 5 pi/16 F_3(lambda).
double load_of_asperities(double h_m) {
  const double scale = 8 * std::numbers::sqrt2 / 15 * std::numbers::pi * std::pow(kN * kBeta * kSigma, 2) *
                       std::sqrt(kSigma / kBeta) * kE;
  return scale * std::sqrt(2 * kRadius * kSigma) * 5 * std::numbers::pi / 16 * third_integral(h_m / kSigma);
}

TEST(PadContact, OfAParabolaMatchesItsClosedForm) {
  for (const double h_m : {0.3e-6, 0.7e-6, 1e-6}) {
    cycle::Case c = starved(0.55e-6, h_m);
    const Sample smooth = solved(c);
    add_contact(c);
    const Sample rough = solved(c);
    EXPECT_NEAR(rough.asperity_load / load_of_asperities(h_m), 1, 1e-6) << h_m;  // rounding of a smooth sum
    EXPECT_EQ(rough.film_load, smooth.film_load) << h_m;
    EXPECT_NEAR(rough.load, rough.film_load + rough.gas_load + rough.asperity_load, 1e-9 * rough.load) << h_m;
    EXPECT_EQ(smooth.asperity_load, 0) << h_m;
  }
}

TEST(PadContact, SharesTheLoadWithTheFilm) {
  cycle::Case c = starved(0.55e-6, 1e-6);
  add_contact(c);
  const Sample at_separation = solved(c);
  EXPECT_GT(at_separation.asperity_load, 0.05 * at_separation.film_load);
  set_load(c, at_separation.load);
  const Sample under_load = solved(c);
  EXPECT_NEAR(under_load.separation / 1e-6, 1, 1e-7);
  EXPECT_EQ(under_load.stable_solutions, 1);
}

TEST(PadContact, CarriesAllOfTheLoadWhereTheOilIsTooLittle) {
  cycle::Case c = starved(0.3e-6, 0);
  add_contact(c);
  set_load(c, load_of_asperities(0.9e-6));
  const Sample s = solved(c);
  EXPECT_NEAR(s.separation / 0.9e-6, 1, 1e-6);
  EXPECT_NEAR(s.film_left_behind / 0.3e-6, 1, 1e-9);
  EXPECT_NEAR(s.film_load / s.load, 0, 1e-12);
}

TEST(PadContact, AddsBoundaryFrictionToBothFrictions) {
  cycle::Case c = starved(0.55e-6, 1e-6);
  const Sample smooth = solved(c);
  add_contact(c);
  const Sample rough = solved(c);
  EXPECT_GT(rough.boundary_friction, kZeta * rough.asperity_load);
  EXPECT_NEAR(rough.friction_moving - smooth.friction_moving, rough.boundary_friction, 1e-9 * rough.friction_moving);
  EXPECT_NEAR(rough.friction_fixed - smooth.friction_fixed, rough.boundary_friction, 1e-9 * rough.friction_moving);
  c.contact.eyring_shear_stress = 0;
  EXPECT_NEAR(solved(c).boundary_friction / (kZeta * rough.asperity_load), 1, 1e-12);
}

TEST(PadContact, AtRestWithoutPressureCarriesWithoutFriction) {
  cycle::Case c = starved(0.55e-6, 0.5e-6);
  c.film.left_edge = c.film.right_edge = cycle::EdgeFluid::kOil;
  c.pad.speed = 0;
  add_contact(c);
  const Sample s = solved(c);
  EXPECT_NEAR(s.load / load_of_asperities(0.5e-6), 1, 1e-6);
  EXPECT_EQ(s.friction_moving, 0);
}

TEST(PadContact, OfAnOscillatingPadFollowsTheSeparation) {
  cycle::Case c = starved(0.55e-6, 0.8e-6);
  add_contact(c);
  c.pad.oscillation.amplitude = 0.2e-6;
  c.pad.oscillation.period = 1e-3;
  c.pad.end_time = 0.5e-3;
  c.pad.time_step = 0.05e-3;
  const PadResult result = solve_pad(c);
  for (const Sample& s : result.samples)
    EXPECT_NEAR(s.asperity_load / load_of_asperities(s.min_film_thickness), 1, 1e-6) << s.time;
}

// More oil than the inlet takes floods it: the film is that of an inlet in oil, also on few cells.
TEST(PadGasEdge, WithMoreOilThanTheInletTakesIsFlooded) {
  cycle::Case c = starved(8e-6, 3e-6);
  c.solver.cells = 50;
  const Sample supplied = solved(c);
  c.film.left_edge = cycle::EdgeFluid::kOil;
  c.film.supply_left.reset();
  const Sample flooded = solved(c);
  EXPECT_NEAR(supplied.load / flooded.load, 1, 1e-9);
  EXPECT_NEAR(supplied.film_left_behind / flooded.film_left_behind, 1, 1e-9);
  EXPECT_EQ(supplied.wetted_left, 0);
}

// The film falls from its peak to the lower pressure of the exit, also before the lowest place: no gas of the inlet is
// there. An inlet in oil has the same film.
TEST(PadGasEdge, OfAHigherPressureAtTheInletReachesToThePeakOfTheFilmAtMost) {
  cycle::Case c = starved(8e-6, 3e-6);
  c.pad.speed = 1;
  c.pad.left_pressure = 9e5;
  c.pad.right_pressure = 1e5;
  c.film.cavitation_pressure = 1e5;
  const Sample supplied = solved(c);
  c.film.left_edge = cycle::EdgeFluid::kOil;
  c.film.supply_left.reset();
  const Sample flooded = solved(c);
  EXPECT_NEAR(supplied.load / flooded.load, 1, 1e-9);
  EXPECT_THAT(supplied.rupture_positions, ::testing::IsEmpty());
}

/// A land between two slopes and gas of two pressures, drawn at random.
cycle::Case random_land(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
  };
  cycle::Case c = cycle::blank_case(cycle::Problem::kPad);
  c.pad.length = 1e-3;
  const double begin = between(0.1e-3, 0.4e-3), end = 1e-3 - between(0.1e-3, 0.4e-3);
  c.pad.gap_x = {0, begin, end, c.pad.length};
  c.pad.gap_height = {between(1e-6, 1e-4), 0, 0, between(1e-6, 1e-4)};
  c.pad.speed = between(0.05, 5);
  c.pad.separation = between(0.3e-6, 3e-6);
  c.pad.left_pressure = between(1e5, 2e6);
  c.pad.right_pressure = between(1e5, 2e6);
  c.lubricant.viscosity = 1e-2;
  c.lubricant.constant_density = 850;
  c.film.cavitation_pressure = 0;
  c.film.left_edge = c.film.right_edge = cycle::EdgeFluid::kGas;
  c.film.supply_left = *c.pad.separation * between(0.1, 3);
  c.solver.cells = 200;
  c.solver.tolerance = 1e-10;
  return c;
}

/// The same as seen from the other side.
cycle::Case mirrored(cycle::Case c) {
  for (double& x : c.pad.gap_x) x = c.pad.length - x;
  std::reverse(c.pad.gap_x.begin(), c.pad.gap_x.end());
  std::reverse(c.pad.gap_height.begin(), c.pad.gap_height.end());
  c.pad.direction = cycle::Direction::kMinusX;
  std::swap(c.pad.left_pressure, c.pad.right_pressure);
  std::swap(c.film.supply_left, c.film.supply_right);
  return c;
}

TEST(PadBetweenGases, OnALandIsItsMirrorImageTheOtherWay) {
  std::mt19937 random(1);
  for (int k = 0; k < 60; ++k) {
    const cycle::Case c = random_land(random);
    const Sample there = solved(c), back = solved(mirrored(c));
    EXPECT_NEAR(back.load / there.load, 1, 1e-6) << k;  // the root of the tolerance is 1e-5
    EXPECT_NEAR(back.wetted_left, c.pad.length - there.wetted_right, c.pad.length / c.solver.cells)
        << k;  // by rounding
  }
}

TEST(PadBetweenGases, OnALandFollowsATiltSmoothly) {
  std::mt19937 random(2);
  for (int k = 0; k < 20; ++k) {
    cycle::Case c = random_land(random);
    const double flat = solved(c).load;
    for (const std::size_t end : {1, 2}) {
      cycle::Case tilted = c;
      tilted.pad.gap_height[end] = 1e-11;
      EXPECT_NEAR(solved(tilted).load / flat, 1, 2e-3) << k;
    }
  }
}

}  // namespace
}  // namespace ringfilm::pad::testing
