#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/film/solver2d/film2d_solver.hpp"
#include "ringfilm/models/oil/lubricant.hpp"

namespace ringfilm::film {
namespace manufactured_films {
namespace {

// Manufactured solutions in two dimensions (eq-film-2d-reynolds): pressure and separation are prescribed functions of
// place and time, the mass source that makes them a solution is worked out here, with laws and derivatives of this
// file's own, and the solver must find them again. The pad is about as long as wide, so that both directions count, and
// all that varies does so with x and y together.
constexpr double kWidth = 1.2e-3, kLength = 2e-3;         // [m]
constexpr double kVelocity = 9, kOmega = 8000;            // [m/s], [1/s]
constexpr double kEta = 0.006, kRho = 790, kZ = 0.6;      // [Pa s], [kg/m3], [-]
constexpr double kA = 6.0e-10, kB = 1.7e-9;               // Dowson-Higginson [1/Pa]
constexpr double kAtm = 101325, kEdge = 2e5, kTop = 6e7;  // [Pa]

double density(double p) { return kRho * (1 + kA * (p - kAtm) / (1 + kB * (p - kAtm))); }
double viscosity(double p) { return kEta * std::exp((std::log(kEta) + 9.67) * (std::pow(1 + p / 1.98e8, kZ) - 1)); }

double pad(double x, double y) {
  const double u = x / kWidth, v = y / kLength;
  return 3e-6 * (1 - u) * (1 - u) * (1 + 0.5 * v) + 1e-6 * (1 + std::cos(2 * std::numbers::pi * v)) * u * (1 - 0.5 * u);
}
double separation(double t) { return 2e-6 * (1 + 0.3 * std::sin(kOmega * t)); }

/// Up to some 600 bar, where viscosity more than doubles; at the edge's on all four sides.
double pressure(double x, double y, double t) {
  const double u = x / kWidth, v = y / kLength;
  return kEdge + kTop * std::sin(std::numbers::pi * u) * (1 + 0.3 * u * v) * std::sin(std::numbers::pi * v) *
                     (1 - 0.3 * v * v) * (1 + 0.4 * std::cos(kOmega * t));
}

/// The same for a two-dimensional film whose ends are joined: periodic in y.
double pad_around(double x, double y) {
  const double u = x / kWidth, v = y / kLength;
  return 3e-6 * (1 - u) * (1 - u) * (1 + 0.3 * std::sin(2 * std::numbers::pi * v)) +
         1e-6 * (1 + std::cos(2 * std::numbers::pi * v)) * u;
}
double pressure_around(double x, double y, double t) {
  const double u = x / kWidth, v = y / kLength;
  return kEdge + kTop * std::sin(std::numbers::pi * u) * (1 + 0.5 * std::sin(2 * std::numbers::pi * v + u)) *
                     (1 + 0.4 * std::cos(kOmega * t));
}

/// Sixth-order central difference: its error is far below the scheme's.
template <typename Function>
double slope(const Function& f, double at, double step) {
  return (45 * (f(at + step) - f(at - step)) - 9 * (f(at + 2 * step) - f(at - 2 * step)) +
          (f(at + 3 * step) - f(at - 3 * step))) /
         (60 * step);
}

struct Prescribed {
  double (*pressure)(double, double, double);
  double (*pad)(double, double);
  Ends ends;

  double gap(double x, double y, double t) const { return separation(t) + pad(x, y); }
  double content(double x, double y, double t) const { return density(pressure(x, y, t)) * gap(x, y, t); }
  double mobility(double x, double y, double t) const {
    const double p = pressure(x, y, t), h = gap(x, y, t);
    return density(p) * h * h * h / (12 * viscosity(p));
  }

  /// d(rho h)/dt + dq_x/dx + dq_y/dy; without the first where `transient_weight` is zero.
  double mass_source(double x, double y, double t, double transient_weight) const {
    const double dx = kWidth / 2000, dy = kLength / 2000;
    const auto flux_x = [&](double at) {
      const double dp = slope([&](double a) { return pressure(a, y, t); }, at, dx);
      return 0.5 * kVelocity * content(at, y, t) - mobility(at, y, t) * dp;
    };
    const auto flux_y = [&](double at) {
      return -mobility(x, at, t) * slope([&](double a) { return pressure(x, a, t); }, at, dy);
    };
    const auto held = [&](double at) { return content(x, y, at); };
    return transient_weight * slope(held, t, 1e-3 / kOmega) + slope(flux_x, x, dx) + slope(flux_y, y, dy);
  }
};

const Prescribed kOpenFilm2d{pressure, pad, Ends::kOpen};
const Prescribed kJoinedFilm2d{pressure_around, pad_around, Ends::kJoined};

/// Strips that crowd smoothly towards one place, so that uneven cells are put to the test as well.
CircumferentialGrid uneven_around(int n_cells, Ends ends) {
  std::vector<double> y;
  const int n_strips = ends == Ends::kJoined ? n_cells : n_cells + 1;
  for (int j = 0; j < n_strips; ++j) {
    const double s = static_cast<double>(j) / n_cells;
    y.push_back(kLength * (s + 0.5 * std::sin(2 * std::numbers::pi * s) / (2 * std::numbers::pi)));
  }
  if (ends == Ends::kOpen) y.back() = kLength;
  return around_at(std::move(y), kLength, ends);
}

class ManufacturedFilm2d {
 public:
  ManufacturedFilm2d(const Prescribed& prescribed, int n_across, int n_around)
      : prescribed_(prescribed), oil_(models::closed_form_oil(kEta, kRho, kZ, {kA, kB})) {
    problem_.strip.grid = uniform_grid(n_across, kWidth, [](double) { return 0.0; });
    problem_.strip.cavitation = Cavitation::kMassConserving;
    problem_.strip.tolerance = 1e-11;
    problem_.around = uneven_around(n_around, prescribed.ends);
    const std::vector<double>& x = problem_.strip.grid.x;
    const CircumferentialGrid& around = problem_.around;
    for (const double y : around.y) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        problem_.gap.node.push_back(prescribed.pad(x[i], y));
        if (i + 1 < x.size()) problem_.gap.face_x.push_back(prescribed.pad(0.5 * (x[i] + x[i + 1]), y));
      }
    }
    for (int c = 0; c < around.n_cells(); ++c) {
      const double y = around.y[c] + 0.5 * around.spacing[c];
      for (const double at : x) problem_.gap.face_y.push_back(prescribed.pad(at, y));
    }
  }

  template <typename Value>
  std::vector<double> at_nodes(const Value& value) const {
    std::vector<double> values;
    for (const double y : problem_.around.y) {
      for (const double x : problem_.strip.grid.x) values.push_back(value(x, y));
    }
    return values;
  }

  FilmState prescribed(double t) const {
    FilmState state;
    state.h_m = separation(t);
    state.p = at_nodes([&](double x, double y) { return prescribed_.pressure(x, y, t); });
    state.deficit.assign(state.p.size(), 0.0);
    state.mass_per_area = at_nodes([&](double x, double y) { return prescribed_.content(x, y, t); });
    return state;
  }

  FilmState solved(double t, double time_step, const FilmState& previous, FilmState guess) const {
    Film2dInputs inputs;
    inputs.strip.oil = oil_;
    inputs.strip.U = kVelocity;
    inputs.strip.left.pressure = inputs.strip.right.pressure = inputs.p_low = inputs.p_high = kEdge;
    inputs.strip.load = kTop / 2 * kWidth;
    inputs.strip.time_step = time_step;
    const double transient_weight = time_step == kSteady ? 0 : 1;
    inputs.strip.source =
        at_nodes([&](double x, double y) { return prescribed_.mass_source(x, y, t, transient_weight); });
    guess.h_m = separation(t);
    Film2dWorkspace workspace(problem_);
    EXPECT_TRUE(solve_film2d_at_separation(problem_, inputs, previous, guess, workspace).converged);
    return guess;
  }

 private:
  Prescribed prescribed_;
  std::shared_ptr<const models::OilAtTemperature> oil_;
  Film2dProblem problem_;
};

double largest_difference(const FilmState& a, const FilmState& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.p.size(); ++i) largest = std::max(largest, std::abs(a.p[i] - b.p[i]));
  return largest / kTop;
}

double steady_error(const Prescribed& prescribed, int n_across, int n_around) {
  const ManufacturedFilm2d film(prescribed, n_across, n_around);
  const FilmState exact = film.prescribed(0);
  FilmState guess = exact;
  std::fill(guess.p.begin(), guess.p.end(), kEdge);
  return largest_difference(film.solved(0, kSteady, exact, guess), exact);
}

double transient_error(int n_across, int n_around, int n_steps) {
  const ManufacturedFilm2d film(kOpenFilm2d, n_across, n_around);
  const double end = 0.5 * std::numbers::pi / kOmega;
  FilmState state = film.prescribed(0);
  for (int k = 1; k <= n_steps; ++k) state = film.solved(end * k / n_steps, end / n_steps, state, state);
  return largest_difference(state, film.prescribed(end));
}

/// Mean slope of the error over the ladder, each level twice as fine.
double observed_order(const std::vector<double>& errors) {
  return std::log2(errors.front() / errors.back()) / static_cast<double>(errors.size() - 1);
}

TEST(ManufacturedFilm2d, ErrorFallsWithTheSquareOfBothCells) {
  std::vector<double> errors;
  for (const int n : {20, 40, 80, 160}) errors.push_back(steady_error(kOpenFilm2d, n, n));
  EXPECT_NEAR(observed_order(errors), 2, 0.1);
  EXPECT_LT(errors.back(), 2e-3);
  RecordProperty("order", std::to_string(observed_order(errors)));
}

TEST(ManufacturedFilm2d, ErrorFallsWithTheSquareOfBothCellsAroundAJoinedFilm2d) {
  std::vector<double> errors;
  for (const int n : {20, 40, 80}) errors.push_back(steady_error(kJoinedFilm2d, n, 2 * n));
  EXPECT_NEAR(observed_order(errors), 2, 0.15);
}

// In one direction alone: the other is so fine that what it leaves is a sixteenth of the least error here.
TEST(ManufacturedFilm2d, ErrorFallsWithTheSquareOfTheCellsAcross) {
  std::vector<double> errors;
  for (const int n : {10, 20, 40}) errors.push_back(steady_error(kOpenFilm2d, n, 160));
  EXPECT_NEAR(observed_order(errors), 2, 0.2);
}

TEST(ManufacturedFilm2d, ErrorFallsWithTheSquareOfTheCellsAround) {
  std::vector<double> errors;
  for (const int n : {10, 20, 40}) errors.push_back(steady_error(kOpenFilm2d, 160, n));
  EXPECT_NEAR(observed_order(errors), 2, 0.2);
}

// Backward Euler; the cells leave a tenth of what the finest step does.
TEST(ManufacturedFilm2d, ErrorFallsWithTheStepInTime) {
  std::vector<double> errors;
  for (const int n : {4, 8, 16}) errors.push_back(transient_error(96, 96, n));
  EXPECT_NEAR(observed_order(errors), 1, 0.15);
}

}  // namespace
}  // namespace manufactured_films
}  // namespace ringfilm::film
