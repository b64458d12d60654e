#include "ringfilm/study/verification/manufactured.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/film/solver/film_solver.hpp"
#include "ringfilm/study/verification/manufactured_film2d.hpp"
#include "ringfilm/study/verification/manufactured_laws.hpp"

namespace ringfilm::study {
namespace {

using namespace manufactured;

/// A value with its slope in place and in time.
struct Varying {
  double value, d_dx, d_dt;
};

/// p = edge + peak sin^2(pi x/b) (1 + oscillation cos(omega t)), with its second derivative in place.
struct Pressure : Varying {
  double d2_dx2;
};

Pressure pressure(double x, double t, double oscillation) {
  const double k = std::numbers::pi / kWidth;
  const double amplitude = kPeak * (1 + oscillation * std::cos(kOmega * t));
  const double s = std::sin(k * x), c = std::cos(k * x);
  return {{kEdge + amplitude * s * s, amplitude * 2 * k * s * c,
           -kPeak * oscillation * kOmega * std::sin(kOmega * t) * s * s},
          amplitude * 2 * k * k * (c * c - s * s)};
}

double separation(double t, double oscillation) { return kFilm * (1 + oscillation * std::sin(kOmega * t)); }
double wedge(double x) { return kWedge * (1 - x / kWidth) * (1 - x / kWidth); }

Varying gap(double x, double t, double oscillation) {
  return {separation(t, oscillation) + wedge(x), -2 * kWedge / kWidth * (1 - x / kWidth),
          kFilm * oscillation * kOmega * std::cos(kOmega * t)};
}

/// d(rho h)/dt + d/dx [U rho h/2 - rho h^3 p_x/(12 eta)], every derivative written out.
double source(double x, double t, double oscillation) {
  const Pressure p = pressure(x, t, oscillation);
  const Varying h = gap(x, t, oscillation);
  const auto [rho, rho_p] = density(p.value);
  const auto [eta, eta_p] = viscosity(p.value);
  const double storage = rho_p * p.d_dt * h.value + rho * h.d_dt;
  const double couette = kSpeed / 2 * (rho_p * p.d_dx * h.value + rho * h.d_dx);
  const double mobility = rho * std::pow(h.value, 3) / (12 * eta);
  const double mobility_x = mobility * (rho_p * p.d_dx / rho + 3 * h.d_dx / h.value - eta_p * p.d_dx / eta);
  return storage + couette - mobility_x * p.d_dx - mobility * p.d2_dx2;
}

/// One manufactured film; the inputs at an instant and the state that must come out.
class Film {
 public:
  Film(int n_cells, double oscillation)
      : oil_(models::closed_form_oil(kEta, kRho, kZ, {kA, kB})), oscillation_(oscillation) {
    problem_.grid = film::uniform_grid(n_cells, kWidth, wedge);
    problem_.cavitation = film::Cavitation::kMassConserving;
    problem_.tolerance = 1e-13;
  }

  film::FilmState prescribed(double t) const {
    film::FilmState state;
    state.h_m = separation(t, oscillation_);
    for (const double x : problem_.grid.x) {
      const double p = pressure(x, t, oscillation_).value;
      state.p.push_back(p);
      state.deficit.push_back(0);
      state.mass_per_area.push_back(density(p).value * gap(x, t, oscillation_).value);
    }
    return state;
  }

  /// The state at `t`, solved from the one a step before.
  film::FilmState solved(double t, double time_step, const film::FilmState& previous) const {
    film::FilmInputs inputs;
    inputs.oil = oil_;
    inputs.U = kSpeed;
    inputs.left.pressure = inputs.right.pressure = kEdge;
    inputs.load = kPeak / 2 * kWidth;
    inputs.time_step = time_step;
    for (const double x : problem_.grid.x) inputs.source.push_back(source(x, t, oscillation_));
    film::FilmState state = previous;
    state.h_m = separation(t, oscillation_);
    film::FilmWorkspace workspace(problem_);
    if (!film::solve_film_at_separation(problem_, inputs, previous, state, workspace).converged) {
      throw ConvergenceError("a manufactured film of " + std::to_string(problem_.grid.n_cells()) +
                             " cells has no solution");
    }
    return state;
  }

 private:
  std::shared_ptr<const models::OilAtTemperature> oil_;
  film::FilmProblem problem_;
  double oscillation_;
};

}  // namespace

const std::vector<std::string>& manufactured_films() {
  static const std::vector<std::string> names = {"steady", "transient", "steady in two dimensions",
                                                 "transient in two dimensions"};
  return names;
}

double manufactured_error(const std::string& film, int n_cells, int n_steps) {
  if (film == "steady in two dimensions") return manufactured_film2d_error(n_cells, 0);
  if (film == "transient in two dimensions") return manufactured_film2d_error(n_cells, n_steps);
  if (film == "steady") {
    const Film steady(n_cells, 0.0);
    const film::FilmState exact = steady.prescribed(0);
    film::FilmState start = exact;
    for (double& p : start.p) p = kEdge;
    return difference_from_peak(steady.solved(0, film::kSteady, start), exact);
  }
  const Film transient(n_cells, kOscillation);
  const double end = kPeriod / 4;
  film::FilmState state = transient.prescribed(0);
  for (int k = 1; k <= n_steps; ++k) state = transient.solved(end * k / n_steps, end / n_steps, state);
  return difference_from_peak(state, transient.prescribed(end));
}

}  // namespace ringfilm::study
