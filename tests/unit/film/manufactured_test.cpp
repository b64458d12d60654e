#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "film_cases.hpp"

namespace ringfilm::film::testing {
namespace manufactured_films {
namespace {

// Manufactured solutions of the transient, compressible, piezoviscous equation (eq-reynolds): pressure (or film
// content) and separation are prescribed functions of place and time, the mass source that makes them a solution is
// worked out here, with laws and derivatives of this file's own, and the solver must find them again.
constexpr double kWidth = 1.2e-3, kVelocity = 9, kOmega = 400;  // [m], [m/s], [1/s]
constexpr double kEta = 0.006, kRho = 790, kZ = 0.6;            // [Pa s], [kg/m3], [-]
constexpr double kA = 6.0e-10, kB = 1.7e-9;                     // Dowson-Higginson [1/Pa]
constexpr double kAtm = 101325;

double density(double p) { return kRho * (1 + kA * (p - kAtm) / (1 + kB * (p - kAtm))); }
double viscosity(double p) { return kEta * std::exp((std::log(kEta) + 9.67) * (std::pow(1 + p / 1.98e8, kZ) - 1)); }

double face(double x) {
  return 6e-6 * std::pow(x / kWidth - 0.4, 2) + 0.4e-6 * std::sin(3 * std::numbers::pi * x / kWidth);
}
double separation(double t) { return 2e-6 * (1 + 0.3 * std::sin(kOmega * t)); }
double gap(double x, double t) { return separation(t) + face(x); }

/// Pressures of up to 800 bar: viscosity more than doubles, density grows by 4 %.
double full_pressure(double x, double t) {
  return 2e5 + 3e5 * x / kWidth +
         8e7 * std::sin(std::numbers::pi * x / kWidth) * (1 + 0.3 * std::sin(2 * x / kWidth)) *
             (1 + 0.4 * std::cos(kOmega * t));
}

/// Sixth-order central difference: its error is far below the scheme's.
template <typename Function>
double slope(const Function& f, double at, double step) {
  return (45 * (f(at + step) - f(at - step)) - 9 * (f(at + 2 * step) - f(at - 2 * step)) +
          (f(at + 3 * step) - f(at - 3 * step))) /
         (60 * step);
}

/// d(rho theta h)/dt + dq/dx of a prescribed pressure and film content.
template <typename Pressure, typename FilmContent>
double mass_source(const Pressure& p, const FilmContent& theta, double x, double t, double transient) {
  const auto content = [&](double time) { return density(p(x, time)) * theta(x, time) * gap(x, time); };
  const auto flux = [&](double place) {
    const double h = gap(place, t);
    const double dp = slope([&](double at) { return p(at, t); }, place, kWidth / 2000);
    const double here = p(place, t);
    return 0.5 * kVelocity * density(here) * theta(place, t) * h -
           density(here) * h * h * h / (12 * viscosity(here)) * dp;
  };
  return transient * slope(content, t, 1e-3 / kOmega) + slope(flux, x, kWidth / 2000);
}

constexpr double kTransientTerm = 1, kNoTransientTerm = 0;  // weights of d(rho theta h)/dt
const auto kFull = [](double, double) -> double { return 1; };

struct Manufactured {
  std::shared_ptr<const models::OilAtTemperature> oil = models::closed_form_oil(kEta, kRho, kZ, {});
  FilmProblem problem;

  explicit Manufactured(int n_cells) {
    const double lowest = lowest_face();
    problem.grid = uniform_grid(n_cells, kWidth, [=](double x) { return face(x) - lowest; });
    problem.cavitation = Cavitation::kMassConserving;
    problem.tolerance = 1e-13;
  }

  static double lowest_face() {
    double lowest = face(0);
    for (int i = 1; i <= 4000; ++i) lowest = std::min(lowest, face(kWidth * i / 4000));
    return lowest;
  }

  template <typename Pressure, typename FilmContent>
  FilmInputs inputs(const Pressure& p, const FilmContent& theta, double t, double transient) const {
    FilmInputs in;
    in.oil = oil;
    in.U = kVelocity;
    in.left.pressure = p(0, t);
    in.right.pressure = p(kWidth, t);
    in.p_cavitation = 1e5;
    in.load = 4e7 * kWidth;
    for (const double x : problem.grid.x) {
      in.source.push_back(mass_source(p, theta, x, t, transient));
    }
    return in;
  }

  template <typename Pressure, typename FilmContent>
  FilmState exact(const Pressure& p, const FilmContent& theta, double t) const {
    FilmState state;
    state.h_m = separation(t) + lowest_face();
    for (const double x : problem.grid.x) {
      state.p.push_back(p(x, t));
      state.deficit.push_back(1 - theta(x, t));
      state.mass_per_area.push_back(density(p(x, t)) * theta(x, t) * gap(x, t));
    }
    return state;
  }
};

double worst(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Largest error of pressure of the steady problem, relative to its top.
double steady_error(int n_cells) {
  const Manufactured film(n_cells);
  const FilmInputs in = film.inputs(full_pressure, kFull, 0, kNoTransientTerm);
  const FilmState exact = film.exact(full_pressure, kFull, 0);
  FilmState state = exact;
  for (double& p : state.p) p = 0.5 * p + 1e5;  // not the answer to start from
  FilmWorkspace workspace(film.problem);
  EXPECT_TRUE(solve_film_at_separation(film.problem, in, exact, state, workspace).converged);
  return worst(state.p, exact.p) / 1.1e8;
}

TEST(Manufactured, FullFilmConvergesWithSecondOrderInSpace) {
  double coarse = steady_error(40);
  for (const int n_cells : {80, 160, 320}) {
    const double fine = steady_error(n_cells);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1) << n_cells << " cells";  // seen 1.99 to 2.01
    coarse = fine;
  }
  EXPECT_LT(coarse, 3e-4);  // seen 2.1e-4
}

struct TransientError {
  double pressure, film;
};

enum class Prescribed { kSeparation, kLoad };

/// A third of a period integrated; errors at its end, relative.
TransientError transient_error(int n_cells, int n_steps, Prescribed prescribed) {
  const Manufactured film(n_cells);
  const double end = 2 / kOmega;
  FilmState state = film.exact(full_pressure, kFull, 0);
  FilmWorkspace workspace(film.problem);
  for (int k = 1; k <= n_steps; ++k) {
    const double t = end * k / n_steps;
    FilmInputs in = film.inputs(full_pressure, kFull, t, kTransientTerm);
    in.time_step = end / n_steps;
    const FilmState exact = film.exact(full_pressure, kFull, t);
    const FilmState previous = state;
    if (prescribed == Prescribed::kSeparation) {
      state.h_m = exact.h_m;
      EXPECT_TRUE(solve_film_at_separation(film.problem, in, previous, state, workspace).converged);
    } else {
      in.load = 0;
      for (std::size_t i = 0; i < exact.p.size(); ++i) in.load += film.problem.grid.share[i] * exact.p[i];
      EXPECT_TRUE(solve_film(film.problem, in, previous, state, workspace).converged);
    }
  }
  const FilmState exact = film.exact(full_pressure, kFull, end);
  return {worst(state.p, exact.p) / 1e8, std::abs(state.h_m / exact.h_m - 1)};
}

// 1600 and 800 cells, so that the error of the steps is what one sees.
// A wrong factor or sign in front of d(rho h)/dt does not converge at all: the squeeze term moves the pressures of this
// film by more than their own size.
TEST(Manufactured, FullFilmConvergesWithFirstOrderInTimeAtPrescribedSeparation) {
  double coarse = transient_error(1600, 20, Prescribed::kSeparation).pressure;
  for (const int n_steps : {40, 80}) {
    const double fine = transient_error(1600, n_steps, Prescribed::kSeparation).pressure;
    EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.1) << n_steps << " steps";
    coarse = fine;
  }
}

TEST(Manufactured, SeparationUnderLoadConvergesWithFirstOrderInTime) {
  double coarse = transient_error(800, 20, Prescribed::kLoad).film;
  for (const int n_steps : {40, 80}) {
    const double fine = transient_error(800, n_steps, Prescribed::kLoad).film;
    EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.15) << n_steps << " steps";
    coarse = fine;
  }
  EXPECT_LT(coarse, 0.01);
}

/// Largest error of the film content in a cavity that the liner moves through while the gap opens and closes.
double cavity_error(int n_cells, int n_steps) {
  const auto pressure = [](double, double) -> double { return 1e5; };
  const auto theta = [](double x, double t) {
    return 1 - 0.5 * std::sin(std::numbers::pi * x / (2 * kWidth)) * (1 + 0.3 * std::sin(kOmega * t));
  };
  const Manufactured film(n_cells);
  const double end = 1 / kOmega;
  FilmState state = film.exact(pressure, theta, 0);
  FilmWorkspace workspace(film.problem);
  for (int k = 1; k <= n_steps; ++k) {
    const double t = end * k / n_steps;
    FilmInputs in = film.inputs(pressure, theta, t, kTransientTerm);
    in.time_step = end / n_steps;
    const FilmState previous = state;
    state.h_m = film.exact(pressure, theta, t).h_m;
    EXPECT_TRUE(solve_film_at_separation(film.problem, in, previous, state, workspace).converged);
  }
  FilmState exact = film.exact(pressure, theta, end);
  exact.deficit.back() = 0;  // the edge is full by definition and lies downstream
  return worst(state.deficit, exact.deficit);
}

TEST(Manufactured, CavityConvergesWithFirstOrderInSpaceAndTime) {
  double coarse = cavity_error(50, 25);
  for (const int refinement : {2, 4}) {
    const double fine = cavity_error(50 * refinement, 25 * refinement);
    EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.1) << refinement;
    coarse = fine;
  }
  EXPECT_LT(coarse, 1e-2);
}

}  // namespace
}  // namespace manufactured_films
}  // namespace ringfilm::film::testing
