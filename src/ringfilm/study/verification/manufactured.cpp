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

/// p = edge + peak sin^2(pi x/b) (1 + oscillation cos(omega t))
Pressure pressure(double x, double t, double oscillation) {
  const double k = std::numbers::pi / kWidth;
  const double amplitude = kPeak * (1 + oscillation * std::cos(kOmega * t));
  const double s = std::sin(k * x), c = std::cos(k * x);
  return {{kEdge + amplitude * s * s, -kPeak * oscillation * kOmega * std::sin(kOmega * t) * s * s,
           amplitude * 2 * k * s * c},
          amplitude * 2 * k * k * (c * c - s * s)};
}

double separation(double t, double oscillation) { return kFilm * (1 + oscillation * std::sin(kOmega * t)); }
double wedge(double x) { return kWedge * (1 - x / kWidth) * (1 - x / kWidth); }

Varying gap(double x, double t, double oscillation) {
  return {separation(t, oscillation) + wedge(x), kFilm * oscillation * kOmega * std::cos(kOmega * t),
          -2 * kWedge / kWidth * (1 - x / kWidth)};
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
    for (const double x : problem_.grid.x)
      inputs.source.push_back(source(pressure(x, t, oscillation_), gap(x, t, oscillation_)));
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
  return film_error<Film>(n_cells, film == "steady" ? 0 : n_steps, kPeriod / 4);
}

}  // namespace ringfilm::study
