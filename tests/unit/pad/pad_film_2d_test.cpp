#include "ringfilm/pad/pad_film_2d.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "pad_cases.hpp"

namespace ringfilm::pad::testing {
namespace {

/// A pad of that width with all edges at zero.
cycle::Case with_width(cycle::Case c, double width, cycle::Sides sides = cycle::Sides::kOpen) {
  c.pad.width = width;
  c.pad.sides = sides;
  c.solver.cells = 48;
  c.solver.cells_y = 48;
  return c;
}

/// Two flat plates that approach each other at a millimetre a second and are 10 um apart in the end.
cycle::Case squeezed_plates(double length, double width) {
  constexpr double time = 1e-4;
  cycle::Case c = with_width(slider(), width);
  c.pad.length = length;
  c.pad.gap_x = {0, length};
  c.pad.gap_height = {0, 0};
  c.pad.speed = 0;
  c.pad.separation.reset();
  c.pad.separation_history_file = "s.csv";
  c.pad.history_time = {0, time};
  c.pad.history_separation = {kOutlet + 1e-3 * time, kOutlet};
  c.pad.time_step = time / 2;
  return c;
}

/// A map over the slider's length and a width, of a height at each of the places.
void set_map(cycle::Case& c, std::vector<double> x, std::vector<double> y,
             const std::function<double(std::size_t i, std::size_t j)>& height) {
  c.pad.gap_height.clear();
  for (std::size_t j = 0; j < y.size(); ++j) {
    for (std::size_t i = 0; i < x.size(); ++i) c.pad.gap_height.push_back(height(i, j));
  }
  c.pad.gap_x = std::move(x);
  c.pad.gap_y = std::move(y);
}

/// A slider with a pocket in its middle, walls on all four sides, 5 um deep.
cycle::Case pocketed(double width) {
  cycle::Case c = with_width(slider(), width);
  c.film.cavitation_pressure = -1e8;  // the film stays full: another test has cavities
  const double L = kLength, B = width;
  set_map(c, {0, L / 4, L / 4, L / 2, L / 2, L}, {0, B / 4, B / 4, 3 * B / 4, 3 * B / 4, B},
          [](std::size_t i, std::size_t j) {
            const bool pocket = (i == 2 || i == 3) && (j == 2 || j == 3);
            return kOutlet + (pocket ? 5e-6 : 0.0);
          });
  return c;
}

// W = beta eta V a b^3/h^3 on rectangles with sides a >= b.
TEST(Pad2d, SqueezedRectanglesCarryTheirSeries) {
  struct Plate {
    double ratio, beta;
  };
  for (const Plate& plate : {Plate{1, 0.421731}, {2, 0.686045}, {3, 0.789951}, {10, 0.936975}}) {
    constexpr double b = 0.01, V = 1e-3;
    const double a = plate.ratio * b, unit = kEta * V * a * b * b * b / std::pow(kOutlet, 3);
    for (const cycle::Case& c : {squeezed_plates(a, b), squeezed_plates(b, a)}) {
      const Sample s = solved(c);
      // Of second order: 1.4e-3 on a square with 48 cells each way; of a strip 10 times as long as wide the ends are
      // seen by five cells alone.
      EXPECT_NEAR(s.total_load / unit / plate.beta, 1, plate.ratio > 5 ? 5e-3 : 2e-3) << plate.ratio;
      EXPECT_NEAR(s.flow_back, -s.flow_front, 1e-9 * s.flow_back);
      EXPECT_LT(s.mass_residual, 1e-6);
    }
  }
}

TEST(Pad2d, SqueezedSquareConvergesWithTheSquareOfTheCell) {
  const auto error = [](int cells) {
    cycle::Case c = squeezed_plates(0.01, 0.01);
    c.solver.cells = c.solver.cells_y = cells;
    const double unit = kEta * 1e-3 * std::pow(0.01, 4) / std::pow(kOutlet, 3);
    return std::abs(solved(c).total_load / unit - 0.421731);
  };
  const double coarse = error(16), fine = error(32);
  EXPECT_NEAR(coarse / fine, 4, 0.2);
}

// Sides that nothing flows through, or that are each other: each strip is the infinitely wide film.
TEST(Pad2d, WithoutFlowThroughItsSidesItIsTheInfinitelyWidePad) {
  cycle::Case wide = slider();
  wide.pad.gap_x = {0, 0.6 * kLength, 0.6 * kLength, kLength};  // a step among it
  wide.pad.gap_height = {2.2 * kOutlet, 2 * kOutlet, kOutlet, kOutlet};
  wide.pad.left_pressure = 3e5;
  wide.solver.cells = 48;
  const Sample along = solved(wide);
  for (const cycle::Sides sides : {cycle::Sides::kPeriodic, cycle::Sides::kClosed}) {
    const Sample s = solved(with_width(wide, 0.5 * kLength, sides));
    constexpr double kOfIteration = 1e-9;  // both stop at 1e-13 or so of the pressures
    EXPECT_NEAR(s.load / along.load, 1, kOfIteration);
    EXPECT_NEAR(s.friction_moving / along.friction_moving, 1, kOfIteration);
    EXPECT_NEAR(s.friction_fixed / along.friction_fixed, 1, kOfIteration);
    EXPECT_NEAR(s.flow_left / along.flow_left, 1, kOfIteration);
    EXPECT_NEAR(s.flow_right / along.flow_right, 1, kOfIteration);
    EXPECT_NEAR(s.peak_film_pressure / along.peak_film_pressure, 1, kOfIteration);
    for (const double flow : {s.flow_front, s.flow_back, s.mass_flow_front, s.mass_flow_back}) {
      if (sides == cycle::Sides::kPeriodic) {
        EXPECT_TRUE(std::isnan(flow)) << "through joined sides nothing is reported to flow";
      } else {
        EXPECT_EQ(flow, 0);
        EXPECT_FALSE(std::signbit(flow));
      }
    }
  }
}

TEST(Pad2d, OneThatIsMuchWiderThanLongCarriesAsAnInfinitelyWideOne) {
  cycle::Case c = slider();
  c.solver.cells = 48;
  const double wide = solved(c).load;
  // Within a length of either side the pressure is lost: about 0.6 of a length in all, whatever the width.
  const auto lost = [&](double lengths) {
    cycle::Case finite = with_width(c, lengths * kLength);
    finite.solver.cells_y = static_cast<int>(12 * lengths);
    return (1 - solved(finite).load / wide) * lengths;
  };
  const double at_10 = lost(10), at_20 = lost(20);
  EXPECT_GT(at_10, 0.3);
  EXPECT_LT(at_10, 1);
  EXPECT_NEAR(at_20 / at_10, 1, 1e-3);
}

TEST(Pad2d, AMirroredMapMirrorsTheFilm) {
  cycle::Case c = with_width(slider(), 0.02);
  c.pad.front_pressure = 4e5;
  c.pad.back_pressure = 1e5;
  const auto tilted = [](std::size_t i, std::size_t j) {
    return (i == 0 ? 20e-6 : 10e-6) + 1e-6 * static_cast<double>(j);
  };
  set_map(c, {0, kLength}, {0, 0.005, 0.02}, tilted);
  cycle::Case mirrored = c;
  std::swap(mirrored.pad.front_pressure, mirrored.pad.back_pressure);
  set_map(mirrored, {0, kLength}, {0, 0.015, 0.02}, [&](std::size_t i, std::size_t j) { return tilted(i, 2 - j); });
  const Sample one = solved(c), other = solved(mirrored);
  EXPECT_NEAR(one.load / other.load, 1, 1e-9);
  EXPECT_NEAR(one.flow_front / -other.flow_back, 1, 1e-8);
  EXPECT_NEAR(one.peak_position_y, 0.02 - other.peak_position_y, 1e-8);
  EXPECT_GT(std::abs(one.flow_front / one.flow_back - 1), 0.1) << "the film is not symmetric by itself";
}

TEST(Pad2d, OpenSidesHaveTheirPressureUpToTheCorners) {
  cycle::Case c = with_width(slider(), 0.02);
  c.solver.cells = c.solver.cells_y = 8;
  c.pad.left_pressure = c.pad.right_pressure = 1e5;
  c.pad.front_pressure = 4e5;
  c.pad.back_pressure = 2e5;
  const PadSetup setup = prepare_pad(c);
  PadFilm2d film(setup, {8, 8});
  film::FilmInputs inputs = setup.steady_inputs();
  inputs.load = 1e6 * kLength;  // the scale of its pressures
  const film::FilmState start = film.full(0);
  film::FilmState solved = start;
  ASSERT_TRUE(film.solve_at_separation(inputs, start, solved).converged);
  for (const film::FilmState& state : {start, solved}) {
    const std::span<const double> p(state.p);
    EXPECT_THAT(p.first(9), ::testing::Each(4e5));
    EXPECT_THAT(p.last(9), ::testing::Each(2e5));
    EXPECT_EQ(p[9], 1e5);  // x = 0 next to the side
  }
}

TEST(Pad2d, ASymmetricPocketMakesASymmetricFilm) {
  const PadResult result = solve_pad(pocketed(0.012));
  const Sample& s = result.samples.back();
  EXPECT_NEAR(s.flow_front, -s.flow_back, 1e-9 * s.flow_back);
  EXPECT_NEAR(s.peak_position_y, 0.006, 1e-9);
  const std::size_t n_x = result.x.size(), n_y = result.y.size();
  const Profile& field = result.fields.back();
  ASSERT_EQ(field.pressure.size(), n_x * n_y);
  for (std::size_t j = 0; j < n_y; ++j) {
    for (std::size_t i = 0; i < n_x; ++i) {
      const std::size_t here = j * n_x + i, there = (n_y - 1 - j) * n_x + i;
      EXPECT_NEAR(field.pressure[here], field.pressure[there], 1e-9 * s.peak_film_pressure);
      EXPECT_DOUBLE_EQ(field.film_thickness[here], field.film_thickness[there]);
    }
  }
}

TEST(Pad2d, StepsAreRepeatedInTheFieldsInBothDirections) {
  const PadResult result = solve_pad(pocketed(0.012));
  const auto standing_at = [](const std::vector<double>& places, double place) {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (std::abs(places[k] - place) < 1e-15) found.push_back(k);
    }
    return found;
  };
  ASSERT_EQ(result.x.size(), 48u + 1 + 2);
  ASSERT_EQ(standing_at(result.x, kLength / 2).size(), 2u);
  ASSERT_EQ(standing_at(result.y, 0.009).size(), 2u);
  ASSERT_EQ(standing_at(result.x, kLength / 4).size(), 2u);
  ASSERT_EQ(standing_at(result.y, 0.003).size(), 2u);
  const std::size_t i = standing_at(result.x, kLength / 4)[0], j = standing_at(result.y, 0.003)[0];
  const std::size_t n_x = result.x.size();
  const std::vector<double>& h = result.fields.back().film_thickness;
  EXPECT_DOUBLE_EQ(h[j * n_x + i], 10e-6);  // the corner, seen from outside
  EXPECT_DOUBLE_EQ(h[j * n_x + i + 1], 10e-6);
  EXPECT_DOUBLE_EQ(h[(j + 1) * n_x + i], 10e-6);
  EXPECT_DOUBLE_EQ(h[(j + 1) * n_x + i + 1], 15e-6);  // and from inside
  // Along mid-width the profile is the field's row.
  EXPECT_EQ(result.profiles.back().pressure.size(), n_x);
  EXPECT_DOUBLE_EQ(result.profiles.back().film_thickness[i + 1], 15e-6);
}

TEST(Pad2d, JoinedSidesAreInTheFieldsOnceAtEachEnd) {
  cycle::Case c = with_width(slider(), 0.02, cycle::Sides::kPeriodic);
  const PadResult result = solve_pad(c);
  EXPECT_EQ(result.y.front(), 0);
  EXPECT_EQ(result.y.back(), 0.02);
  const std::size_t n_x = result.x.size();
  ASSERT_EQ(result.fields.back().pressure.size(), n_x * result.y.size());
  for (std::size_t i = 0; i < n_x; ++i) {
    EXPECT_EQ(result.fields.back().pressure[i], result.fields.back().pressure[(result.y.size() - 1) * n_x + i]);
  }
}

// A wall of the map anywhere: what is cut out of one period can be moved to its other end.
TEST(Pad2d, APeriodicMapMayBeginAnywhere) {
  const auto load = [](double shift) {
    cycle::Case c = with_width(slider(), 0.012, cycle::Sides::kPeriodic);
    set_map(c, {0, kLength}, {0, 0.003 + shift, 0.003 + shift, 0.006 + shift, 0.006 + shift, 0.012},
            [](std::size_t i, std::size_t j) { return (i == 0 ? 20e-6 : 10e-6) + (j == 2 || j == 3 ? 4e-6 : 0.0); });
    return solved(c).load;
  };
  EXPECT_NEAR(load(0) / load(0.003), 1, 1e-9);
}

// Grooves along the whole length, of a flat pad without pressures: nothing but eta U/h, in each part of the width.
TEST(Pad2d, GroovesAlongTheMotionShearAndLeakAsTheirParts) {
  cycle::Case c = with_width(slider(), 0.012, cycle::Sides::kPeriodic);
  set_map(c, {0, kLength}, {0, 0.002, 0.002, 0.006, 0.006, 0.012},
          [](std::size_t, std::size_t j) { return j == 2 || j == 3 ? 30e-6 : 10e-6; });
  c.solver.cells_y = 12;
  const double mean = (1 / 30e-6 + 2 / 10e-6) / 3;  // a third of the width is groove
  EXPECT_NEAR(solved(c).friction_moving / (kEta * kU * kLength * mean), 1, 1e-9);
  // A drop of pressure along it: what flows goes with the cube of each part's height.
  c.pad.speed = 0;
  c.pad.left_pressure = 1e6;
  const double cube = (std::pow(30e-6, 3) + 2 * std::pow(10e-6, 3)) / 3;
  const Sample s = solved(c);
  EXPECT_NEAR(s.flow_left / (cube / (12 * kEta) * 1e6 / kLength), 1, 1e-9);
  EXPECT_NEAR(s.flow_right / s.flow_left, 1, 1e-9);
  EXPECT_LT(s.mass_residual, 1e-9);
}

TEST(Pad2d, FindsTheSeparationForALoad) {
  cycle::Case c = with_width(slider(), 0.02);
  c.pad.gap_height = {10e-6, 0};
  c.pad.separation = 7e-6;
  const double load = solved(c).load;
  c.pad.separation.reset();
  c.pad.load = load;
  const Sample s = solved(c);
  EXPECT_NEAR(s.separation, 7e-6, 1e-6 * 7e-6);
  EXPECT_NEAR(s.load / load, 1, 1e-6);
}

TEST(Pad2d, PressuresAtTheSidesAloneMakeALineOfPressure) {
  cycle::Case c = with_width(slider(), 0.02);
  c.pad.gap_height = {kOutlet, kOutlet};
  c.pad.speed = 0;
  c.pad.length = 0.2;  // far from the edges in x the film is one-dimensional in y
  c.pad.gap_x = {0, 0.2};
  c.pad.front_pressure = 2e5;
  c.pad.back_pressure = 0;
  const Sample s = solved(c);
  const double q = std::pow(kOutlet, 3) / (12 * kEta) * 2e5 / 0.02;  // per length in x
  EXPECT_GT(s.flow_front, 0);
  EXPECT_NEAR(s.flow_back / (q * 0.2), 1, 0.1);  // the edges in x are at zero: within a width of them less flows out
}

// The film ruptures where the surface enters the pocket and forms again in it; what the side walls hold is part of the
// balance.
TEST(Pad2d, NoPeakIsMadeUpInACornerWherePressuresJump) {
  for (const bool in_x : {true, false}) {
    cycle::Case c = with_width(slider(), 0.015);
    c.pad.speed = 0;
    (in_x ? c.pad.left_pressure : c.pad.front_pressure) = 7e5;
    const PadResult result = solve_pad(c);
    EXPECT_EQ(result.samples.back().peak_film_pressure, 7e5);
    const auto is_reported = [](const auto& note) { return note.topic == "edge-flow-grows"; };
    EXPECT_TRUE(std::any_of(result.notes.begin(), result.notes.end(), is_reported));
    c.pad.left_pressure = c.pad.front_pressure = 0;
    const PadResult without = solve_pad(c);
    EXPECT_FALSE(std::any_of(without.notes.begin(), without.notes.end(), is_reported));
  }
}

TEST(Pad2d, MassIsKeptWithACavityInAPocket) {
  cycle::Case c = pocketed(0.012);
  c.film.cavitation_pressure = 0;
  c.pad.left_pressure = c.pad.right_pressure = c.pad.front_pressure = c.pad.back_pressure = 2e4;
  const PadResult result = solve_pad(c);
  const Sample& s = result.samples.back();
  EXPECT_GT(s.cavitated_fraction, 0.01);
  EXPECT_LT(s.mass_residual, 1e-9);
  const double inflow = 0.012 * s.flow_left, outflow = 0.012 * s.flow_right + s.flow_back - s.flow_front;
  EXPECT_NEAR(inflow / outflow, 1, 1e-9);
  EXPECT_NEAR(s.flow_front, -s.flow_back, 1e-9 * s.flow_right);
  ASSERT_FALSE(s.rupture_positions.empty());
  EXPECT_NEAR(s.rupture_positions.front(), kLength / 4, kLength / 48);
  for (const double film_content : result.fields.back().film_content) {
    EXPECT_GE(film_content, 0);
    EXPECT_LE(film_content, 1);
  }
}

// Square plates that oscillate: a cavity opens in the middle, and closes.
TEST(Pad2d, MassIsKeptWhileACavityOpensAndCloses) {
  cycle::Case c = squeezed_plates(0.01, 0.01);
  c.solver.cells = c.solver.cells_y = 24;
  c.pad.history_time.clear();
  c.pad.history_separation.clear();
  for (int k = 0; k <= 800; ++k) {
    c.pad.history_time.push_back(1e-2 * k / 400);
    c.pad.history_separation.push_back(15e-6 + 5e-6 * std::cos(2 * std::numbers::pi * k / 400.0));
  }
  c.pad.time_step = 5e-5;
  c.pad.end_time = 1.45e-2;  // the plates approach once more
  c.pad.left_pressure = c.pad.right_pressure = c.pad.front_pressure = c.pad.back_pressure = 1e5;
  const PadResult result = solve_pad(c);
  ASSERT_EQ(result.samples.size(), 291u);
  ASSERT_EQ(result.fields.size(), 291u);
  double largest = 0;
  for (const Sample& s : result.samples) {
    largest = std::max(largest, s.cavitated_fraction);
    EXPECT_LT(s.mass_residual, 1e-7) << s.time << " s";  // flows pass zero twice; elsewhere some 1e-10
  }
  EXPECT_GT(largest, 0.05);
  EXPECT_EQ(result.samples.back().cavitated_fraction, 0);
  EXPECT_EQ(result.effort.cut_steps, 0);
}

/// The slider of verification/: 5 m/s, 20 mPa s, no pressure at its edges, `outlet` at its end.
cycle::Case verification_slider(double inlet, double outlet, cycle::Sides sides) {
  cycle::Case c = with_width(slider(), 0.005, sides);
  c.pad.gap_height = {inlet, outlet};
  c.solver.cells = 200;
  c.solver.cells_y = 4;
  return c;
}

// Where nothing flows through the sides the references of verification/ hold, which no code of ours made.
TEST(Pad2d, BarusAndDowsonHigginsonReachTheirReferencesAcrossClosedAndJoinedSides) {
  constexpr double kOfCells = 1e-4;  // of second order: 7e-5 at the most with these 200 cells
  for (const cycle::Sides sides : {cycle::Sides::kPeriodic, cycle::Sides::kClosed}) {
    cycle::Case barus = verification_slider(6.6e-6, 3e-6, sides);
    barus.lubricant.viscosity_pressure = cycle::ViscosityPressure::kBarus;
    barus.lubricant.law_parameters["pressure_viscosity_coefficient"] = 20e-9;
    const Sample thick = solved(barus);
    EXPECT_NEAR(thick.load / 238320.6, 1, kOfCells);
    EXPECT_NEAR(thick.peak_film_pressure / 41987533, 1, kOfCells);
    EXPECT_NEAR(thick.flow_left / 10.3125e-6, 1, kOfCells);

    cycle::Case dense = verification_slider(4.4e-6, 2e-6, sides);
    dense.lubricant.compressibility = cycle::Compressibility::kDowsonHigginson;
    dense.lubricant.dh_a = 6e-10;
    dense.lubricant.dh_b = 1.7e-9;
    const Sample packed = solved(dense);
    EXPECT_NEAR(packed.load / 399821.06, 1, kOfCells);
    EXPECT_NEAR(packed.peak_film_pressure / 64169060, 1, kOfCells);
    EXPECT_NEAR(packed.mass_flow_right / 0.0059821719, 1, kOfCells);
  }
}

// Barus' oil at its reduced pressure P = (1 - exp(-alpha p))/alpha is one of constant viscosity, in both directions:
// the film of the one follows from that of the other point by point.
TEST(Pad2d, BarusFollowsFromTheFilmOfConstantViscosity) {
  constexpr double alpha = 2e-8;
  cycle::Case c = with_width(slider(), 0.01);
  c.pad.gap_height = {8e-6, 4e-6};
  const PadResult plain = solve_pad(c);
  c.lubricant.viscosity_pressure = cycle::ViscosityPressure::kBarus;
  c.lubricant.law_parameters["pressure_viscosity_coefficient"] = alpha;
  const PadResult thick = solve_pad(c);
  const std::vector<double>&P = plain.fields.back().pressure, &p = thick.fields.back().pressure;
  ASSERT_EQ(P.size(), p.size());
  double largest = 0, difference = 0, plain_difference = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double expected = -std::log1p(-alpha * P[k]) / alpha;
    largest = std::max(largest, expected);
    difference = std::max(difference, std::abs(p[k] - expected));
    plain_difference = std::max(plain_difference, std::abs(p[k] - P[k]));
  }
  EXPECT_GT(plain_difference / largest, 0.05) << "the oil hardly thickens";
  EXPECT_LT(difference / largest, 1e-4);  // of second order in both: 3.3e-5 with 48 cells each way
}

// Between plates that are at rest the mass that flows across is the same everywhere: the integral of the density over
// the pressure falls on a straight line from side to side, far from the edges in x.
TEST(Pad2d, DowsonHigginsonBendsTheLineOfPressureAcross) {
  constexpr double a = 6e-10, b = 1.7e-9, front = 3e8, width = 0.01;
  cycle::Case c = with_width(slider(), width);
  c.pad.gap_height = {kOutlet, kOutlet};
  c.pad.speed = 0;
  c.pad.length = 0.2;  // exp(-pi 0.1/0.01) of the edges is left halfway
  c.pad.gap_x = {0, 0.2};
  c.pad.front_pressure = front;
  c.pad.back_pressure = 0;
  c.lubricant.compressibility = cycle::Compressibility::kDowsonHigginson;
  c.lubricant.dh_a = a;
  c.lubricant.dh_b = b;
  // rho/rho_0 = 1 + a p/(1 + b p), integrated from 0
  const auto content = [](double p) { return p + a / b * (p - std::log1p(b * p) / b); };
  const PadResult result = solve_pad(c);
  const std::size_t n_x = result.x.size(), middle = n_x / 2;
  double bend = 0;
  for (std::size_t j = 0; j < result.y.size(); ++j) {
    const double p = result.fields.back().pressure[j * n_x + middle], share = 1 - result.y[j] / width;
    EXPECT_NEAR(content(p) / content(front), share, 2e-6);  // of second order, 7e-7 here: K is a mean of two nodes
    bend = std::max(bend, std::abs(p / front - share));
  }
  EXPECT_GT(bend, 1e-2) << "the density hardly grows";
}

TEST(Pad2d, ACoarseGridIsReported) {
  cycle::Case c = with_width(slider(), 0.01);
  c.solver.cells = c.solver.cells_y = 8;
  const PadResult result = solve_pad(c);
  const auto note = std::find_if(result.notes.begin(), result.notes.end(),
                                 [](const cycle::Note& n) { return n.topic == "coarse-grid"; });
  ASSERT_NE(note, result.notes.end());
  EXPECT_THAT(note->message, ::testing::HasSubstr("solver.cells and solver.cells_y"));
}

}  // namespace
}  // namespace ringfilm::pad::testing
