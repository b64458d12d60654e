#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "pad_cases.hpp"

namespace ringfilm::pad::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

// --- plane slider: closed forms of Rayleigh (1918), with m = 1 + K --------------------------------------------------

constexpr double kM = 2;  // inlet over outlet

double slider_load() { return 6 * (std::log(kM) - 2 * (kM - 1) / (kM + 1)) / ((kM - 1) * (kM - 1)) * kLoadUnit; }
double slider_flow() { return kU * kOutlet * kM / (kM + 1); }
/// Shear on the surface that moves, and on the pad: (4 ln m - 6 (m - 1)/(m + 1))/(m - 1) and (2 ln m - ...)(-1).
double slider_friction_moving() {
  return (4 * std::log(kM) - 6 * (kM - 1) / (kM + 1)) / (kM - 1) * kEta * kU * kLength / kOutlet;
}
double slider_friction_fixed() {
  return (6 * (kM - 1) / (kM + 1) - 2 * std::log(kM)) / (kM - 1) * kEta * kU * kLength / kOutlet;
}

TEST(PadSlider, MatchesItsClosedForms) {
  const Sample s = solved(slider());
  // Second order: 4e-5 at 200 cells, falling by four with each doubling.
  EXPECT_NEAR(s.load / slider_load(), 1, 1e-4);
  EXPECT_NEAR(s.friction_moving / slider_friction_moving(), 1, 1e-4);
  EXPECT_NEAR(s.friction_fixed / slider_friction_fixed(), 1, 1e-4);
  EXPECT_NEAR(s.flow_left / slider_flow(), 1, 1e-4);
  EXPECT_NEAR(s.flow_right / slider_flow(), 1, 1e-4);
  EXPECT_NEAR(s.mass_flow_right / (kDensity * slider_flow()), 1, 1e-4);
  EXPECT_NEAR(s.peak_film_pressure / (kEta * kU * kLength / (kOutlet * kOutlet) * 1.5 * (kM - 1) / (kM * (kM + 1))), 1,
              1e-4);
  // The pressure peaks where h = 2 h0 m/(m + 1).
  EXPECT_NEAR(s.peak_position / kLength, 2.0 / 3.0, 1e-3);
  EXPECT_NEAR(s.friction_coefficient, s.friction_moving / s.load, 1e-15);
  EXPECT_THAT(s.rupture_positions, IsEmpty());
  EXPECT_LT(s.mass_residual, 1e-9);
}

TEST(PadSlider, OfAnOilAtItsSecondNewtonianViscosityIsThatOfAThinnerOil) {
  cycle::Case c = slider();
  c.lubricant.shear_thinning = cycle::ShearThinning::kCross;
  c.lubricant.second_newtonian_ratio = 0.5;
  c.lubricant.critical_shear_rate = 1e-3;
  const Sample s = solved(c);
  EXPECT_NEAR(s.load / (0.5 * slider_load()), 1, 1e-4);
  EXPECT_NEAR(s.friction_moving / (0.5 * slider_friction_moving()), 1, 1e-4);
  EXPECT_LT(s.mass_residual, 1e-9);
}

TEST(PadSlider, BetweenRoughWallsCarriesTheLoadItIsGiven) {
  cycle::Case c = slider();
  c.pad.gap_height = {kOutlet, 0};
  c.pad.separation.reset();
  c.pad.load = slider_load();
  c.film.flow_factors = c.film.stress_factors = cycle::Roughness::kPatirCheng;
  c.contact.roughness = 0.5 * kOutlet;
  const Sample isotropic = solved(c);
  EXPECT_NEAR(isotropic.load / slider_load(), 1, 1e-8);
  c.film.orientation = 1.0 / 9;  // roughness across the motion holds the oil in the film
  EXPECT_GT(solved(c).separation, 1.05 * isotropic.separation);
  c.contact.roughness = 1e-3 * kOutlet;
  EXPECT_NEAR(solved(c).separation / kOutlet, 1, 1e-4);  // a thick film
}

TEST(PadSlider, FindsTheSeparationThatCarriesItsLoad) {
  cycle::Case c = slider();
  c.pad.gap_height = {kOutlet, 0};
  c.pad.separation.reset();
  c.pad.load = slider_load();
  const Sample s = solved(c);
  EXPECT_NEAR(s.separation / kOutlet, 1, 1e-4);  // as the load above, at a third of its relative error
  EXPECT_NEAR(s.min_film_thickness, s.separation, 1e-18);
  EXPECT_NEAR(s.load / slider_load(), 1, 1e-8);
}

TEST(PadSlider, AddsTheSeparationToTheGap) {
  cycle::Case thinner = slider();
  thinner.pad.gap_height = {1.5 * kOutlet, 0.5 * kOutlet};
  thinner.pad.separation = 0.5 * kOutlet;
  EXPECT_NEAR(solved(thinner).load / solved(slider()).load, 1, 1e-9);  // the same film; rounding and iteration
}

TEST(PadSlider, GivesTheMirroredAnswerWhenMirrored) {
  cycle::Case c = slider();
  c.pad.left_pressure = 2e4;
  c.pad.right_pressure = 1e4;
  cycle::Case mirrored = c;
  mirrored.pad.direction = cycle::Direction::kMinusX;
  std::swap(mirrored.pad.left_pressure, mirrored.pad.right_pressure);
  std::swap(mirrored.pad.gap_height[0], mirrored.pad.gap_height[1]);
  const Sample a = solved(c), b = solved(mirrored);
  // Sums run in the other direction: rounding, amplified by the iteration.
  EXPECT_NEAR(b.load / a.load, 1, 1e-8);
  EXPECT_NEAR(b.friction_moving / a.friction_moving, 1, 1e-8);
  EXPECT_NEAR(b.friction_fixed / a.friction_fixed, 1, 1e-8);
  EXPECT_NEAR(b.flow_left / -a.flow_right, 1, 1e-8);
  EXPECT_NEAR(b.flow_right / -a.flow_left, 1, 1e-8);
  EXPECT_NEAR(b.peak_position + a.peak_position, kLength, 1e-8);
}

// With rho and eta constant, adding a pressure everywhere changes nothing but the load by its share.
TEST(PadSlider, CountsPressureFromAnyZero) {
  cycle::Case c = slider();
  c.pad.left_pressure = c.pad.right_pressure = c.film.cavitation_pressure = -3e5;
  const Sample below = solved(c), at_zero = solved(slider());
  EXPECT_NEAR((below.load + 3e5 * kLength) / at_zero.load, 1, 1e-8);
  EXPECT_NEAR(below.flow_left / at_zero.flow_left, 1, 1e-8);
}

TEST(PadSlider, OfBarusOilHasTheReducedPressureOfAConstantOil) {
  // q = (1 - exp(-alpha p))/alpha obeys the equation of constant viscosity: peak q is the peak of that film.
  cycle::Case c = slider();
  c.solver.cells = 400;
  const double peak_q = solved(c).peak_film_pressure;
  c.lubricant.viscosity_pressure = cycle::ViscosityPressure::kBarus;
  c.lubricant.law_parameters["pressure_viscosity_coefficient"] = 0.8 / peak_q;
  const Sample thick = solved(c);
  const double expected = -std::log(1 - 0.8) / 0.8 * peak_q;
  EXPECT_NEAR(thick.peak_film_pressure / expected, 1, 2e-4);  // second order, steeper than the constant oil
  EXPECT_NEAR(thick.flow_left / solved(slider()).flow_left, 1, 2e-4);
}

/// Film of the slider with density rho_0 [1 + a p/(1 + b p)]: with the mass flow m stated, dp/dx = 12 eta/h^3 (U h/2 -
/// m/rho) from p(0) = 0 on, by Runge and Kutta's method; m such that p(L) = 0.
struct DenseFilm {
  double load = 0, end_pressure = 0;
};
DenseFilm dense_film(double m, double a, double b) {
  constexpr int n = 4000;
  const auto slope = [&](double x, double p) {
    const double h = kOutlet * (2 - x / kLength);
    const double rho = kDensity * (1 + a * p / (1 + b * p));
    return 12 * kEta / (h * h * h) * (kU * h / 2 - m / rho);
  };
  DenseFilm film;
  const double dx = kLength / n;
  double p = 0;
  for (int i = 0; i < n; ++i) {
    const double x = i * dx;
    const double k1 = slope(x, p), k2 = slope(x + dx / 2, p + dx / 2 * k1), k3 = slope(x + dx / 2, p + dx / 2 * k2);
    const double k4 = slope(x + dx, p + dx * k3);
    const double next = p + dx / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    film.load += 0.5 * dx * (p + next);
    p = next;
  }
  film.end_pressure = p;
  return film;
}

TEST(PadSlider, OfCompressibleOilAgreesWithShooting) {
  constexpr double a = 2e-8, b = 5e-8;  // strong: the density rises by 4 % at the peak of 2.5 MPa
  double low = 0.9 * kDensity * slider_flow(), high = 1.1 * kDensity * slider_flow();
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (dense_film(middle, a, b).end_pressure > 0 ? low : high) = middle;
  }
  cycle::Case c = slider();
  c.solver.cells = 400;
  c.lubricant.compressibility = cycle::Compressibility::kDowsonHigginson;
  c.lubricant.dh_a = a;
  c.lubricant.dh_b = b;
  const Sample s = solved(c);
  EXPECT_NEAR(s.mass_flow_left / low, 1, 2e-5);  // second order at 400 cells
  EXPECT_NEAR(s.load / dense_film(low, a, b).load, 1, 4e-5);
  EXPECT_GT(std::abs(s.load / slider_load() - 1), 1e-3);  // the law matters here
}

// --- Rayleigh's step -----------------------------------------------------------------------------------------------

cycle::Case rayleigh_step(double ratio, double share) {
  cycle::Case c = slider();
  c.pad.gap_x = {0, share * kLength, share * kLength, kLength};
  c.pad.gap_height = {ratio * kOutlet, ratio * kOutlet, kOutlet, kOutlet};
  return c;
}

TEST(PadStep, IsExactOnAnyGrid) {
  constexpr double ratio = 1.866, share = 0.7182;
  const double load = 3 * share * (1 - share) * (ratio - 1) / (share + ratio * ratio * ratio * (1 - share));
  for (const int n_cells : {10, 77, 300}) {
    cycle::Case c = rayleigh_step(ratio, share);
    c.solver.cells = n_cells;
    const PadResult result = solve_pad(c);
    const Sample& s = result.samples.back();
    EXPECT_NEAR(s.load / kLoadUnit / load, 1, 1e-9);  // straight lines on both sides: rounding and iteration
    EXPECT_NEAR(s.peak_position / kLength, share, 1e-12);
    EXPECT_NEAR(s.peak_film_pressure, 2 * s.load / kLength, 1e-9 * s.peak_film_pressure);
    // The step is twice among the places, with both heights.
    const auto step = std::adjacent_find(result.x.begin(), result.x.end());
    ASSERT_NE(step, result.x.end());
    const auto i = step - result.x.begin();
    EXPECT_NEAR(result.profiles[0].film_thickness[i] / result.profiles[0].film_thickness[i + 1], ratio, 1e-12);
    EXPECT_EQ(result.profiles[0].pressure[i], result.profiles[0].pressure[i + 1]);
    for (const double film_content : result.profiles[0].film_content)
      EXPECT_EQ(film_content, 1);  // on the thick side of the step, too
  }
}

// --- cavities -------------------------------------------------------------------------------------------------------

cycle::Case parabolic_pad(cycle::Direction direction) {
  cycle::Case c = slider();
  c.pad.length = 0.0762;
  c.pad.speed = 4.57;
  c.pad.direction = direction;
  c.lubricant.viscosity = 0.039;
  c.solver.cells = 800;
  set_gap(c, 800, [](double x) { return 25.4e-6 * (1 + std::pow(2 * x / 0.0762 - 1, 2)); });
  return c;
}

// Numbers by quadrature of the film up to a rupture with p = p' = 0 (docs/theory/film.md).
TEST(PadParabola, RupturesWhereTheQuadratureStates) {
  const Sample s = solved(parabolic_pad(cycle::Direction::kPlusX));
  const double cell = 76.2e-3 / 800;
  ASSERT_THAT(s.rupture_positions, SizeIs(1));
  EXPECT_NEAR(s.rupture_positions[0], 51.7348e-3, 0.1 * cell);
  EXPECT_THAT(s.reformation_positions, IsEmpty());  // open to the edge
  EXPECT_NEAR(s.peak_film_pressure / 3.59179e6, 1, 1e-4);
  EXPECT_NEAR(s.peak_position, 24.4652e-3, 0.1 * cell);
  EXPECT_NEAR(s.load / 101.349e3, 1, 1e-4);
  EXPECT_NEAR(s.flow_right / 6.54721e-5, 1, 1e-4);
}

TEST(PadParabola, RupturesAtTheMirroredPlaceWhenTheSurfaceRunsBack) {
  const Sample s = solved(parabolic_pad(cycle::Direction::kMinusX));
  ASSERT_THAT(s.rupture_positions, SizeIs(1));
  EXPECT_NEAR(s.rupture_positions[0], 76.2e-3 - 51.7348e-3, 0.1 * 76.2e-3 / 800);
  EXPECT_THAT(s.reformation_positions, IsEmpty());
  EXPECT_NEAR(s.flow_left / -6.54721e-5, 1, 1e-4);
  EXPECT_GT(s.friction_moving, 0);
  EXPECT_GT(s.friction_fixed, 0);
}

/// A flat pad with one pocket, in which the film ruptures at its entry and forms again before its end.
cycle::Case pocket(int n_cells) {
  cycle::Case c = slider();
  c.pad.length = 0.02;
  c.pad.speed = 2;
  c.pad.gap_x = {0, 0.004, 0.004, 0.010, 0.010, 0.020};
  c.pad.gap_height = {10e-6, 10e-6, 30e-6, 30e-6, 10e-6, 10e-6};
  c.lubricant.viscosity = 0.01;
  c.pad.left_pressure = c.pad.right_pressure = 5e4;
  c.solver.cells = n_cells;
  return c;
}

// The solver takes heights at nodes and half way between them: points there give the same film.
TEST(PadGap, OfAFormulaIsThatOfItsPoints) {
  const auto expect_same = [](const cycle::FaceShape& face, const std::function<double(double)>& height) {
    cycle::Case formula = slider();
    formula.pad.face = face;
    formula.pad.separation = kOutlet;
    formula.film.cavitation_pressure = -1e9;
    cycle::Case points = formula;
    points.pad.face = cycle::Pad().face;
    set_gap(points, 2 * points.solver.cells, height);
    for (const auto& width : {std::optional<double>(), std::optional<double>(kLength)}) {
      for (cycle::Case* c : {&formula, &points}) {
        c->pad.width = width;
        c->solver.cells = width ? 40 : 200;
        c->solver.cells_y = 20;
      }
      const Sample a = solved(formula), b = solved(points);
      EXPECT_NEAR(a.load / b.load, 1, 1e-12);
      EXPECT_NEAR(a.flow_left / b.flow_left, 1, 1e-12);
      EXPECT_NEAR(a.min_film_thickness / b.min_film_thickness, 1, 1e-14);
      EXPECT_DOUBLE_EQ(a.separation, kOutlet);
    }
  };
  using cycle::FaceForm;
  const auto parabola = [](double x) { return 20e-6 * std::pow(2 * x / kLength - 1, 2); };
  expect_same({.form = FaceForm::kParabola, .crown_height = 20e-6}, parabola);
  expect_same({FaceForm::kPolynomial, {0.8, -8, 20}, 1e-3, 1e-6}, parabola);
  expect_same({FaceForm::kPolynomial, {-1, 20}, 1e-3, 1e-6}, [](double x) { return 20e-6 - 1e-3 * x; });
  expect_same({.form = FaceForm::kCosine, .crown_height = 20e-6, .apex = 0.25},
              [](double x) { return 10e-6 * (1 + std::cos(2 * std::numbers::pi * (x / kLength + 0.25))); });
}

TEST(PadGap, GroovesOfAFormulaAreTheStepsOfItsPoints) {
  cycle::Case grooved = slider();
  grooved.pad.face = {cycle::FaceForm::kPolynomial, {-1, 20}, 1e-3, 1e-6};
  grooved.pad.grooves = {{0, 0.6}, 1e-3, 30e-6};
  cycle::Case points = grooved;
  points.pad.face = cycle::Pad().face;
  points.pad.gap_x = {0, 0.5e-3, 0.5e-3, 5.5e-3, 5.5e-3, 6.5e-3, 6.5e-3, kLength};
  points.pad.gap_height = {50e-6, 49.5e-6, 19.5e-6, 14.5e-6, 44.5e-6, 43.5e-6, 13.5e-6, kOutlet};
  for (const auto& width : {std::optional<double>(), std::optional<double>(kLength)}) {
    grooved.pad.width = points.pad.width = width;
    grooved.solver.cells_y = points.solver.cells_y = 20;
    const PadResult a = solve_pad(grooved), b = solve_pad(points);
    EXPECT_EQ(a.x.size(), b.x.size());
    EXPECT_NEAR(a.samples.back().load / b.samples.back().load, 1, 1e-9);
    EXPECT_NEAR(a.samples.back().friction_moving / b.samples.back().friction_moving, 1, 1e-9);
  }
}

/// A full film around a journal that moves towards +x, its lowest place at that share of the way around.
cycle::Case journal(double apex) {
  cycle::Case c = slider();
  c.pad.journal_radius = kLength / (2 * std::numbers::pi);
  c.pad.face = {.form = cycle::FaceForm::kCosine, .crown_height = 10e-6, .apex = apex};
  c.pad.separation = kOutlet;
  c.film.cavitation_pressure = -1e9;
  return c;
}

TEST(JournalLoad, IsMirroredWithTheMotion) {
  cycle::Case mirrored = journal(0.6);
  mirrored.pad.direction = cycle::Direction::kMinusX;
  const Sample a = solved(journal(0.4)), b = solved(mirrored);
  EXPECT_NEAR(a.journal_load / b.journal_load, 1, 1e-9);
  EXPECT_NEAR(a.journal_load_angle, -b.journal_load_angle, 1e-6);
  EXPECT_NEAR(a.attitude_angle, b.attitude_angle, 1e-6);
  EXPECT_NEAR(a.attitude_angle, 0.4 * 360 - a.journal_load_angle, 1e-9);
  EXPECT_DOUBLE_EQ(a.friction_coefficient, a.friction_moving / a.journal_load);
}

TEST(JournalLoad, BetweenWallsIsThatOfAnInfinitelyWideFilm) {
  cycle::Case walled = journal(0.4);
  walled.pad.width = kLength;
  walled.pad.sides = cycle::Sides::kClosed;
  walled.solver.cells_y = 8;
  const Sample a = solved(journal(0.4)), b = solved(walled);
  EXPECT_NEAR(b.journal_load / a.journal_load, 1, 1e-7);
  EXPECT_NEAR(b.journal_load_angle, a.journal_load_angle, 1e-5);
}

TEST(JournalLoad, IsOfPadsWithARadiusAlone) {
  const Sample flat = solved(slider());
  for (const double value : {flat.journal_load, flat.journal_load_angle, flat.attitude_angle}) {
    EXPECT_TRUE(std::isnan(value));
  }
}

TEST(PadGap, OfAFormulaIsNotCutByTheLengthOfTheCells) {
  cycle::Case c = slider();
  c.pad.face = {.form = cycle::FaceForm::kParabola, .crown_height = 20e-6, .apex = 0.123456789};  // no node there
  c.pad.separation = kOutlet;
  c.solver.cells = 400;
  const PadResult result = solve_pad(c);
  EXPECT_EQ(result.samples.back().separation, kOutlet);
  for (const cycle::Note& note : result.notes) EXPECT_NE(note.topic, "separation-adds-to-gap");
}

// Piece by piece the gap is parallel and the pressure a straight line. Land before the pocket: from 0.5 bar down to 0
// at the pocket's entry, where the film ruptures; so the flow is known, and with it the rest.
TEST(PadPocket, AgreesWithTheFilmPutTogetherByHand) {
  constexpr double h = 10e-6, H = 30e-6, U = 2, eta = 0.01, edge = 5e4, a = 0.004, end = 0.010, L = 0.020;
  const double q = U * h / 2 + h * h * h / (12 * eta) * edge / a;
  const double rise_in_pocket = 12 * eta / (H * H * H) * (U * H / 2 - q);
  const double fall_after = 12 * eta / (h * h * h) * (q - U * h / 2);
  const double peak = edge + fall_after * (L - end);
  const double reformation = end - peak / rise_in_pocket;
  ASSERT_GT(reformation, a);
  // Drag of the films and of the cavity, which holds 2 q/(U H) of oil, and h/2 times the differences of pressure.
  const double in_cavity = 2 * q / (U * H);
  const double drag = eta * U * ((a + L - end) / h + (in_cavity * (reformation - a) + end - reformation) / H);
  const double friction = drag + 0.5 * (h * (0 - edge) + H * peak + h * (edge - peak));
  std::array<double, 3> front_error{};
  int k = 0;
  for (const int n_cells : {100, 200, 400}) {
    const Sample s = solved(pocket(n_cells));
    EXPECT_NEAR(s.flow_left / q, 1, 1e-8);
    EXPECT_LT(s.mass_residual, 1e-8);
    // Exact but for the iteration: the cell of the front holds what its upstream node does.
    EXPECT_NEAR(s.friction_moving / friction, 1, 1e-6) << n_cells << " cells";
    EXPECT_NEAR(s.peak_film_pressure / peak, 1, 1e-8);
    EXPECT_NEAR(s.peak_position, end, 1e-12);
    ASSERT_THAT(s.rupture_positions, SizeIs(1));
    ASSERT_THAT(s.reformation_positions, SizeIs(1));
    EXPECT_NEAR(s.rupture_positions[0], a, L / n_cells);
    front_error[k++] = std::abs(s.reformation_positions[0] - reformation);
    EXPECT_LT(front_error[k - 1], L / n_cells) << n_cells << " cells";  // first order at a front
  }
}

// --- what has no answer ---------------------------------------------------------------------------------------------

TEST(Pad, ReportsThatALoadBelowThatOfItsEdgesHasNoSeparation) {
  cycle::Case c = slider();
  c.pad.separation.reset();
  c.pad.left_pressure = c.pad.right_pressure = 1e5;
  c.pad.load = 0.5e5 * kLength;
  EXPECT_THROW(solve_pad(c), StoppedPad);
}

// What flat lands with a pocket between them carry is largest at one separation and falls again towards thinner films,
// where the pocket fills from the edge no more: the thick one is found.
TEST(Pad, UnderALoadTakesTheThickerOfTwoFilms) {
  cycle::Case c = slider();
  c.pad.gap_x = {0, 1e-3, 1e-3, 6e-3, 6e-3, kLength};
  c.pad.gap_height = {0, 0, 20e-6, 20e-6, 0, 0};
  c.pad.speed = 1;
  c.lubricant.viscosity = 0.01;
  c.pad.left_pressure = c.pad.right_pressure = 1e5;
  const auto load_at = [&](double separation) {
    c.pad.separation = separation;
    return solved(c).load;
  };
  EXPECT_GT(load_at(4e-6), 2200);
  EXPECT_GT(load_at(1.5e-6), 2200);
  EXPECT_LT(load_at(0.5e-6), 2200);
  c.pad.separation.reset();
  c.pad.load = 2200;
  const Sample s = solved(c);
  EXPECT_NEAR(s.load, 2200, 1e-4);
  EXPECT_NEAR(s.separation, 4.61e-6, 0.05e-6);  // by hand from the loads at given separations
}

TEST(Pad, ReportsThatAnySeparationCarriesALoadThatOnlyTheEdgesMake) {
  cycle::Case c = slider();
  c.pad.gap_height = {kOutlet, kOutlet};
  c.pad.separation.reset();
  c.pad.left_pressure = c.pad.right_pressure = 1e5;
  c.pad.load = 1e5 * kLength;
  EXPECT_THROW(solve_pad(c), StoppedPad);
}

// The estimate of the pressures, from the thinnest place, is nine orders of magnitude above what they are.
TEST(Pad, KeepsMassWhereItsThinnestPlaceIsANeedle) {
  cycle::Case c = slider();
  c.pad.gap_x = {0, 4.99e-3, 5e-3, 5.01e-3, kLength};
  c.pad.gap_height = {20e-6, 20e-6, 1e-9, 20e-6, 15e-6};
  c.pad.left_pressure = c.pad.right_pressure = 1e5;
  const PadResult result = solve_pad(c);
  EXPECT_LT(result.samples.back().mass_residual, 1e-8);
  for (double& x : c.pad.gap_x) x += x > 0 && x < kLength ? 0.013e-3 : 0.0;  // no node or face at its point any more
  const auto notes = solve_pad(c).notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const auto& n) { return n.topic == "gap-finer-than-cells"; }));
}

TEST(Pad, AtRestBetweenEqualPressuresHasTheirPressureEverywhere) {
  cycle::Case c = slider();
  c.pad.speed = 0;
  c.pad.left_pressure = c.pad.right_pressure = 2e5;
  const Sample s = solved(c);
  EXPECT_NEAR(s.load, 2e5 * kLength, 1e-9);
  EXPECT_NEAR(s.flow_left, 0, 1e-15);
  EXPECT_NEAR(s.friction_moving, 0, 1e-9);
}

std::vector<std::string> topics(const cycle::Case& c) {
  std::vector<std::string> all;
  for (const cycle::Note& note : solve_pad(c).notes) all.push_back(note.topic);
  return all;
}

TEST(Pad, AtRestWithoutPressureItsGridIsNotCalledCoarse) {
  cycle::Case c = slider();
  c.pad.speed = 0;
  c.pad.left_pressure = c.pad.right_pressure = c.film.cavitation_pressure = 0;
  c.solver.cells = 400;
  const PadResult result = solve_pad(c);
  EXPECT_TRUE(result.notes.empty());
  EXPECT_EQ(result.samples.back().load, 0);
  EXPECT_EQ(result.samples.back().peak_film_pressure, 0);
  EXPECT_TRUE(std::isnan(result.samples.back().friction_coefficient));
}

TEST(Pad, FilmsThatNoOilFormsAreNotedMostSeriousFirst) {
  EXPECT_THAT(topics(slider()), IsEmpty());
  cycle::Case thin = slider();
  thin.pad.gap_height = {2e-10, 1e-10};
  EXPECT_THAT(topics(thin), ::testing::ElementsAre("film-below-molecules", "film-pressure-high", "shear-stress-high"));
  cycle::Case thick = slider();
  thick.pad.gap_height = {2.1e-3, 1.1e-3};  // on 10 mm
  EXPECT_THAT(topics(thick), ::testing::ElementsAre("film-too-thick"));
}

TEST(Pad, NotesOnLimitsHaveTheirFigures) {
  cycle::Case c = slider();
  c.lubricant.viscosity = 1e3;
  const auto notes = solve_pad(c).notes;
  ASSERT_THAT(notes, SizeIs(2));
  EXPECT_EQ(notes[0].message,
            "film pressure up to 1.25e+05 MPa: beyond 400 MPa neither the laws of density and viscosity nor rigid "
            "surfaces hold");
  EXPECT_THAT(notes[1].message, ::testing::StartsWith("mean shear stress in the film up to 386 MPa: real oils"));
}

}  // namespace
}  // namespace ringfilm::pad::testing
