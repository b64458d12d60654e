#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "film_cases.hpp"

namespace ringfilm::film::testing {
namespace {

// --- infinitely wide inclined slider, W h0^2/(eta U L^2) = 6 [ln(1+K)/K^2 - 2/(K(2+K))] (Rayleigh 1918) -------------

constexpr double kLength = 0.01, kOutlet = 10e-6, kEta = 0.02, kU = 5.0;

double slider_load(double K) {
  return 6 * (std::log1p(K) / (K * K) - 2 / (K * (2 + K))) * kEta * kU * kLength * kLength / (kOutlet * kOutlet);
}

FilmInputs slider_inputs(const SmoothFilm& film, double load) {
  FilmInputs in = film.inputs();
  in.U = kU;
  in.load = load;
  in.p_cavitation = -1e12;  // the closed form has no cavity
  return in;
}

double slider_error(int n_cells, double K) {
  SmoothFilm film(
      n_cells, kLength, [&](double x) { return K * kOutlet * (1 - x / kLength); }, kEta, Cavitation::kReynoldsExit);
  const Solved solved = steady_at(film.problem, slider_inputs(film, slider_load(K)), kOutlet);
  EXPECT_TRUE(solved.report.converged);
  return std::abs(solved.integrals.hydrodynamic_load / slider_load(K) - 1);
}

TEST(Reynolds, LinearSliderMatchesClosedForm) {
  // Second order: 3e-5 at 400 cells for the steepest gap, seen and falling by four with each doubling.
  for (const double K : {0.3, 1.0, 1.188705, 3.0}) EXPECT_LT(slider_error(400, K), 4e-5) << "K = " << K;
}

TEST(Reynolds, LinearSliderConvergesWithSecondOrder) {
  const double order = std::log2(slider_error(50, 1.0) / slider_error(100, 1.0));
  EXPECT_NEAR(order, 2.0, 0.05);  // asymptotic range: the next term changes the order by less
}

TEST(Reynolds, SliderUnderItsClosedFormLoadFloatsAtItsOutletFilm) {
  SmoothFilm film(
      400, kLength, [](double x) { return kOutlet * (1 - x / kLength); }, kEta, Cavitation::kReynoldsExit);
  const Solved solved = steady_under_load(film.problem, slider_inputs(film, slider_load(1.0)), 3e-6);
  ASSERT_TRUE(solved.report.converged);
  // Here h_s does not scale with h_m: the outlet film itself is the unknown.
  EXPECT_NEAR(solved.state.h_m / kOutlet, 1, 2e-5);
}

// --- parabola, flooded, Reynolds exit (Martin 1916, numbers of docs/theory/film.md) ---------------------------------

TEST(Reynolds, MartinParabolaMatchesHalfSommerfeldWithReynoldsExit) {
  constexpr double R = 0.05, h0 = 2e-6, eta = 0.01, u = 3.0;  // u: mean entrainment velocity
  const double s = std::sqrt(2 * R * h0);
  const double width = 60 * s;
  // An inlet that begins at 54 s instead of infinity lacks its tail, p = 16 eta u R^2/x^3, and all pressures lie lower
  // by the tail's value there: 12/54^2 of the load factor together.
  const double load_factor = 4.894968 - 12 / (54.0 * 54.0);
  SmoothFilm film(
      12000, width, [&](double x) { return (x - 0.9 * width) * (x - 0.9 * width) / (2 * R); }, eta,
      Cavitation::kReynoldsExit);
  FilmInputs in = film.inputs();
  in.U = 2 * u;
  in.load = 4.894968 * eta * u * R / h0;
  const Solved solved = steady_at(film.problem, in, h0);
  ASSERT_TRUE(solved.report.converged);
  EXPECT_NEAR(solved.integrals.hydrodynamic_load / in.load, load_factor / 4.894968, 2e-5);
  EXPECT_NEAR(solved.integrals.peak_pressure / (2.150942 * eta * u * std::sqrt(R) * std::pow(h0, -1.5)), 1, 1e-4);
  // The rupture point is known to one cell, 1/200 s.
  EXPECT_NEAR((solved.integrals.cavities.front().begin - 0.9 * width) / s, 0.4751299, 0.006);
}

// --- parabolic pad with rupture and reformation-free exit, mass conserving (PHYSICS of docs/theory/film.md) ----------

struct Pad {
  double rupture, p_max, x_max, load, flow, cavitated_fraction, shear_couette;
};

Pad parabolic_pad(int n_cells) {
  constexpr double L = 0.0762, h_min = 25.4e-6, rise = 25.4e-6;
  SmoothFilm film(
      n_cells, L, [&](double x) { return rise * std::pow(2 * x / L - 1, 2); }, 0.039, Cavitation::kMassConserving);
  FilmInputs in = film.inputs();
  in.U = 4.57;
  in.load = 1e5;
  const Solved solved = steady_at(film.problem, in, h_min);
  EXPECT_TRUE(solved.report.converged);
  const auto& p = solved.state.p;
  const auto top = std::max_element(p.begin(), p.end()) - p.begin();
  return {solved.integrals.cavities.front().begin, solved.integrals.peak_pressure, film.problem.grid.x[top],
          solved.integrals.hydrodynamic_load,      solved.integrals.flow_middle,   solved.integrals.cavitated_fraction,
          solved.integrals.shear_couette};
}

TEST(MassConserving, ParabolicPadRupturesWhereTheQuadratureStates) {
  const Pad pad = parabolic_pad(1600);
  // The front is first order: half a cell is 0.024 mm.
  EXPECT_NEAR(pad.rupture, 51.7348e-3, 0.05e-3);
  EXPECT_NEAR(pad.p_max / 3.59179e6, 1, 1e-4);
  EXPECT_NEAR(pad.x_max, 24.4652e-3, 0.05e-3);
  EXPECT_NEAR(pad.load / 101.349e3, 1, 1e-4);
  EXPECT_NEAR(pad.flow / 6.54721e-5, 1, 1e-4);
}

// Where the front lies between two nodes is reported to a fraction of the cell: its error is far below the cell's
// width.
TEST(MassConserving, RuptureIsLocatedWithinItsCell) {
  for (const int n_cells : {100, 217, 400}) {
    const double cell = 76.2e-3 / n_cells;
    const Pad pad = parabolic_pad(n_cells);
    EXPECT_NEAR(pad.rupture, 51.7348e-3, 0.05 * cell) << n_cells << " cells";
    EXPECT_NEAR(pad.cavitated_fraction, 1 - pad.rupture / 76.2e-3, 1e-12) << "it is open to the edge";
  }
}

// A cavity is sheared in its oil alone: it carries theta h = 2 q/U, so that theta eta U/h = 2 eta q/h^2.
TEST(MassConserving, CavityIsShearedWhereItsOilIs) {
  constexpr double L = 0.0762, h_min = 25.4e-6, rise = 25.4e-6, eta = 0.039, U = 4.57;
  constexpr double rupture = 51.7348e-3, flow = 6.54721e-5;  // of the quadrature above
  constexpr int kSteps = 20000;
  double shear = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double x = (k + 0.5) * L / kSteps;
    const double h = h_min + rise * std::pow(2 * x / L - 1, 2);
    shear += (x < rupture ? eta * U / h : 2 * eta * flow / (h * h)) * L / kSteps;
  }
  // Each cell is sheared with what its upstream node holds: second order but at the front, where theta is nearly 1. The
  // mean of both nodes was off by 1.6e-3 at 200 cells.
  EXPECT_NEAR(parabolic_pad(200).shear_couette / shear, 1, 5e-5);
}

// --- Rayleigh's step: the gap jumps, and no cell face lies across the jump (Rayleigh 1918) ---------------------------

TEST(Reynolds, RayleighStepIsExactOnAnyGridBecauseTheJumpIsANode) {
  constexpr double ratio = 1.866, share = 0.7182;
  // Pressure is a straight line on both sides of the step, which linear cells represent without error.
  const double load = 3 * share * (1 - share) * (ratio - 1) / (share + ratio * ratio * ratio * (1 - share));
  EXPECT_NEAR(load, 0.2063, 5e-5);
  for (const int n_cells : {5, 64, 333}) {
    SmoothFilm film(
        8, kLength, [](double) { return 0.0; }, kEta, Cavitation::kMassConserving);
    film.problem.grid = grid_of_pieces(n_cells, {{0, share * kLength, [](double) { return (ratio - 1) * kOutlet; }},
                                                 {share * kLength, kLength, [](double) { return 0.0; }}});
    ASSERT_EQ(film.problem.grid.jumps.size(), 1u);
    FilmInputs in = film.inputs();
    in.U = kU;
    in.load = load * kEta * kU * kLength * kLength / (kOutlet * kOutlet);
    const Solved solved = steady_at(film.problem, in, kOutlet);
    ASSERT_TRUE(solved.report.converged);
    EXPECT_NEAR(solved.integrals.hydrodynamic_load / in.load, 1, 1e-10) << n_cells << " cells";
  }
}

// Two inclined pads with a step between them: p = 6 eta U I2(x) - 12 eta q I3(x), I_n = int dx/h^n in closed form.
struct TwoPads {
  static constexpr double kStep = 0.37 * kLength;
  static double left(double x) { return 30e-6 - 8e-6 * x / kStep; }
  static double right(double x) { return 14e-6 - 4e-6 * (x - kStep) / (kLength - kStep); }

  static double I2(double length, double a, double b) { return length / (a * b); }
  static double I3(double length, double a, double b) { return length * (a + b) / (2 * a * a * b * b); }

  /// Pressure just at the step.
  static double pressure_at_step() {
    const double before2 = I2(kStep, left(0), left(kStep));
    const double before3 = I3(kStep, left(0), left(kStep));
    const double after2 = I2(kLength - kStep, right(kStep), right(kLength));
    const double after3 = I3(kLength - kStep, right(kStep), right(kLength));
    const double q = 0.5 * kU * (before2 + after2) / (before3 + after3);
    return 6 * kEta * kU * before2 - 12 * kEta * q * before3;
  }

  static double error(int n_cells) {
    SmoothFilm film(
        8, kLength, [](double) { return 0.0; }, kEta, Cavitation::kMassConserving);
    const double lowest = right(kLength);
    film.problem.grid = grid_of_pieces(n_cells, {{0, kStep, [=](double x) { return left(x) - lowest; }},
                                                 {kStep, kLength, [=](double x) { return right(x) - lowest; }}});
    const Solved solved = steady_at(film.problem, slider_inputs(film, 1e4), lowest);
    EXPECT_TRUE(solved.report.converged);
    return std::abs(solved.state.p[film.problem.grid.jumps.front().node] / pressure_at_step() - 1);
  }
};

TEST(Reynolds, GapThatJumpsKeepsTheSecondOrder) {
  double coarse = TwoPads::error(50);
  for (const int n_cells : {100, 200, 400}) {
    const double fine = TwoPads::error(n_cells);
    // The pieces get whole numbers of cells: their shares wobble, and the order with them.
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.15) << n_cells << " cells";
    coarse = fine;
  }
}

TEST(MassConserving, SteadyFlowIsTheSameThroughBothEdges) {
  constexpr double L = 0.0762;
  SmoothFilm film(
      200, L, [&](double x) { return 25.4e-6 * std::pow(2 * x / L - 1, 2); }, 0.039, Cavitation::kMassConserving);
  FilmInputs in = film.inputs();
  in.U = 4.57;
  in.load = 1e5;
  const Solved solved = steady_at(film.problem, in, 25.4e-6);
  ASSERT_GT(solved.integrals.cavitated_fraction, 0.2);
  // Round-off of 200 sums; the tolerance of the iteration is quadratic, 1e-10.
  EXPECT_NEAR(solved.integrals.flow_right / solved.integrals.flow_left, 1, 1e-9);
}

// Nothing moves: the pressure falls from edge to edge, nearly all of it in the narrowest place, q = dp/(12 eta int
// dx/h^3). No equation holds the film content of a node that the iteration takes below p_c on the way.
TEST(MassConserving, FilmAtRestIsFullHoweverThinItIs) {
  constexpr double b = 1e-3, rise = 50e-6, apex = 0.64e-3, p_left = 110e5, p_right = 1e5;
  const auto height = [](double x) { return rise * std::pow((x - apex) / apex, 2); };
  for (const double h_m : {1e-9, 1e-7, 1e-5}) {
    SmoothFilm film(400, b, height, 0.005, Cavitation::kMassConserving);
    FilmInputs in = film.inputs();
    in.left.pressure = p_left;
    in.right.pressure = p_right;
    in.p_cavitation = 1e4;
    in.load = 115e5 * b;
    const Solved solved = steady_at(film.problem, in, h_m);
    ASSERT_TRUE(solved.report.converged) << h_m;
    EXPECT_TRUE(solved.integrals.cavities.empty());
    // The sum over the faces is the discrete answer itself; the integral differs where the valley is below a cell.
    double resistance = 0;
    for (int i = 0; i < 400; ++i)
      resistance += film.problem.grid.spacing[i] / std::pow(h_m + height((i + 0.5) * b / 400), 3);
    EXPECT_NEAR(solved.integrals.flow_middle * 12 * 0.005 * resistance / (p_left - p_right), 1, 1e-6) << h_m;
  }
}

TEST(MassConserving, FilmAtRestClosesTheCavityOfItsGuess) {
  // Nothing flows but what the edges drive: between parallel plates the pressure falls in a straight line.
  SmoothFilm film(
      50, kLength, [](double) { return 0.0; }, kEta, Cavitation::kMassConserving);
  FilmInputs in = film.inputs();
  in.left.pressure = 2e5;
  in.right.pressure = 1e5;
  in.p_cavitation = 2e4;
  in.load = 1.5e5 * kLength;
  FilmState guess = first_guess(film.problem, in);
  guess.h_m = kOutlet;
  for (int i = 10; i <= 20; ++i) {
    guess.p[i] = in.p_cavitation;
    guess.deficit[i] = 0.3;
  }
  FilmState state = guess;
  FilmWorkspace workspace(film.problem);
  ASSERT_TRUE(solve_film_at_separation(film.problem, in, guess, state, workspace).converged);
  for (int i = 0; i <= 50; ++i) {
    EXPECT_EQ(state.deficit[i], 0);
    EXPECT_NEAR(state.p[i] / (2e5 - 2e3 * i), 1, 1e-9) << "node " << i;  // a linear system: rounding
  }
}

// Gas at both edges presses the two sides apart with more than the load, however wide the gap: there is no answer.
TEST(FilmSolver, ReportsThatTheGasLiftsOffWhatIsPressedOnTooLittle) {
  SmoothFilm film(
      64, kLength, [](double x) { return kOutlet * (1 - x / kLength); }, kEta, Cavitation::kMassConserving);
  FilmInputs in = film.inputs();
  in.U = 0.1;
  in.left.pressure = in.right.pressure = in.p_cavitation = 1e5;
  in.load = 0.5e5 * kLength;
  FilmWorkspace workspace(film.problem);
  FilmState state = first_guess(film.problem, in);
  const FilmState previous = state;
  const FilmReport report = solve_film(film.problem, in, previous, state, workspace);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.failure, Failure::kLiftedOff);
}

TEST(ReynoldsExit, CavityHoldsTheCavitationPressureAndNoNodeLiesBelow) {
  constexpr double L = 0.0762;
  SmoothFilm film(
      200, L, [&](double x) { return 25.4e-6 * std::pow(2 * x / L - 1, 2); }, 0.039, Cavitation::kReynoldsExit);
  FilmInputs in = film.inputs();
  in.U = 4.57;
  in.load = 1e5;
  in.left.pressure = in.right.pressure = in.p_cavitation = 1e5;
  const Solved solved = steady_at(film.problem, in, 25.4e-6);
  ASSERT_TRUE(solved.report.converged);
  for (std::size_t i = 0; i < solved.state.p.size(); ++i) {
    EXPECT_GE(solved.state.p[i], 1e5);
    if (solved.state.deficit[i] > 0) {
      EXPECT_EQ(solved.state.p[i], 1e5);
    }
  }
}

TEST(Reynolds, TurningTheFaceAndTheMotionMirrorsTheFilm) {
  constexpr double b = 1.2e-3;
  const auto height = [](double x) { return 8e-6 * std::pow(x / b - 0.4, 2) / 0.36; };
  for (const auto cavitation : {Cavitation::kReynoldsExit, Cavitation::kMassConserving}) {
    SmoothFilm film(100, b, height, 0.005, cavitation);
    SmoothFilm mirrored(
        100, b, [&](double x) { return height(b - x); }, 0.005, cavitation);
    FilmInputs in = film.inputs();
    in.U = 6;
    in.left.pressure = 8e5;
    in.right.pressure = in.p_cavitation = 1e5;
    in.load = 9e5 * b;
    FilmInputs back = in;
    back.oil = mirrored.oil;
    back.U = -in.U;
    std::swap(back.left.pressure, back.right.pressure);
    const Solved a = steady_under_load(film.problem, in, 1e-6);
    const Solved m = steady_under_load(mirrored.problem, back, 1e-6);
    ASSERT_TRUE(a.report.converged && m.report.converged);
    // Sums run in the other direction: rounding, amplified by the iteration's own tolerance.
    EXPECT_NEAR(a.state.h_m / m.state.h_m, 1, 1e-9);
    EXPECT_NEAR(a.integrals.flow_middle / -m.integrals.flow_middle, 1, 1e-8);
  }
}

}  // namespace
}  // namespace ringfilm::film::testing
