#include "ringfilm/study/verification/manufactured_film2d.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "ringfilm/base/error.hpp"
#include "ringfilm/film/solver2d/film2d_solver.hpp"
#include "ringfilm/study/verification/manufactured_laws.hpp"

namespace ringfilm::study {
namespace {

using namespace manufactured;

constexpr double kAcross = 2.5e-3;  // in y [m]
// Oscillates so fast that a step in time errs more than the cells do.
constexpr double kQuick = 10 * kOmega;  // [1/s]

/// A function of one place with two derivatives.
struct Curve {
  double value, slope, bend;
};

/// sin^2(pi x/b)
Curve hump(double x, double width) {
  const double k = std::numbers::pi / width, s = std::sin(k * x), c = std::cos(k * x);
  return {s * s, 2 * k * s * c, 2 * k * k * (c * c - s * s)};
}

/// sin^2(pi y/L) (1 + y/2L)
Curve leaning_hump(double y) {
  const Curve even = hump(y, kAcross);
  const double lean = 1 + 0.5 * y / kAcross, rise = 0.5 / kAcross;
  return {even.value * lean, even.slope * lean + even.value * rise, even.bend * lean + 2 * even.slope * rise};
}

Pressure pressure(double x, double y, double t, double oscillation) {
  const double amplitude = kPeak * (1 + oscillation * std::cos(kQuick * t));
  const double growth = -kPeak * oscillation * kQuick * std::sin(kQuick * t);
  const Curve along = hump(x, kWidth), across = leaning_hump(y);
  return {{kEdge + amplitude * along.value * across.value, growth * along.value * across.value,
           amplitude * along.slope * across.value, amplitude * along.value * across.slope},
          amplitude * along.bend * across.value,
          amplitude * along.value * across.bend};
}

double film2d_separation(double t, double oscillation) { return kFilm * (1 + oscillation * std::sin(kQuick * t)); }

double pad(double x, double y) {
  const double u = 1 - x / kWidth;
  return kWedge * u * u * (1 + 0.5 * y / kAcross);
}

Varying gap(double x, double y, double t, double oscillation) {
  const double u = 1 - x / kWidth;
  return {film2d_separation(t, oscillation) + pad(x, y), kFilm * oscillation * kQuick * std::cos(kQuick * t),
          -2 * kWedge / kWidth * u * (1 + 0.5 * y / kAcross), kWedge * u * u * 0.5 / kAcross};
}

film::CircumferentialGrid crowded_around(int n_cells) {
  std::vector<double> y;
  for (int j = 0; j <= n_cells; ++j) {
    const double s = static_cast<double>(j) / n_cells;
    y.push_back(kAcross * s * (1 + 0.5 * (s - 1)));
  }
  return film::around_at(std::move(y), kAcross, film::Ends::kOpen);
}

/// One manufactured film; the inputs at an instant and the state that must come out.
class Film2d {
 public:
  Film2d(int n_cells, double oscillation)
      : oil_(models::closed_form_oil(kEta, kRho, kZ, {kA, kB})), oscillation_(oscillation) {
    problem_.strip.grid = film::uniform_grid(n_cells, kWidth, [](double) { return 0.0; });
    problem_.strip.cavitation = film::Cavitation::kMassConserving;
    problem_.strip.tolerance = 1e-11;
    problem_.around = crowded_around(n_cells);
    const std::vector<double>& x = problem_.strip.grid.x;
    const std::vector<double>& y = problem_.around.y;
    for (std::size_t j = 0; j < y.size(); ++j) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        problem_.gap.node.push_back(pad(x[i], y[j]));
        if (i + 1 < x.size()) problem_.gap.face_x.push_back(pad(0.5 * (x[i] + x[i + 1]), y[j]));
        if (j + 1 < y.size()) problem_.gap.face_y.push_back(pad(x[i], 0.5 * (y[j] + y[j + 1])));
      }
    }
  }

  film::FilmState prescribed(double t) const {
    film::FilmState state;
    state.h_m = film2d_separation(t, oscillation_);
    for (const double y : problem_.around.y) {
      for (const double x : problem_.strip.grid.x) {
        const double p = pressure(x, y, t, oscillation_).value;
        state.p.push_back(p);
        state.mass_per_area.push_back(density(p).value * gap(x, y, t, oscillation_).value);
      }
    }
    state.deficit.assign(state.p.size(), 0.0);
    return state;
  }

  /// The state at `t`, solved from the one a step before.
  film::FilmState solved(double t, double time_step, const film::FilmState& previous) const {
    film::Film2dInputs inputs;
    inputs.strip.oil = oil_;
    inputs.strip.U = kSpeed;
    inputs.strip.left.pressure = inputs.strip.right.pressure = inputs.p_low = inputs.p_high = kEdge;
    inputs.strip.load = kPeak / 2 * kWidth;
    inputs.strip.time_step = time_step;
    for (const double y : problem_.around.y) {
      for (const double x : problem_.strip.grid.x) {
        inputs.strip.source.push_back(source(pressure(x, y, t, oscillation_), gap(x, y, t, oscillation_)));
      }
    }
    film::FilmState state = previous;
    state.h_m = film2d_separation(t, oscillation_);
    film::Film2dWorkspace workspace(problem_);
    if (!film::solve_film2d_at_separation(problem_, inputs, previous, state, workspace).converged) {
      throw ConvergenceError("a manufactured film of " + std::to_string(problem_.strip.grid.n_cells()) +
                             " cells in both directions has no solution");
    }
    return state;
  }

 private:
  std::shared_ptr<const models::OilAtTemperature> oil_;
  film::Film2dProblem problem_;
  double oscillation_;
};

}  // namespace

double manufactured_film2d_error(int n_cells, int n_steps) {
  return film_error<Film2d>(n_cells, n_steps, 0.5 * std::numbers::pi / kQuick);
}

}  // namespace ringfilm::study
