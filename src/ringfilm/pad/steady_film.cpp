#include "ringfilm/pad/steady_film.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::pad {
namespace {

constexpr int kSpeedHalvings = 8;   // the slowest start of a speed that is raised little by little
constexpr double kFarOff = 0.1;     // an estimate of the pressures is not used if they turn out below this share
constexpr int kMaxEstimates = 40;   // each a tenth of the one before or less
constexpr double kNothing = 1e-40;  // share of the first estimate below which a pressure counts as zero
// smallest change of the film in one step that counts as motion, over the film thickness
constexpr double kStandstill = 1e-10;
constexpr double kNoPressure = 1.0;  // scale where neither motion nor edges make any pressure [Pa]

/// Pressures that wedge, squeeze and edges may make [Pa]; never 0.
double estimated_pressure(const PadSetup& setup, const film::FilmInputs& inputs, double h_m, double closing) {
  const double L = setup.input.pad.length, eta = setup.viscosity;
  const double wedge = eta * std::abs(inputs.U) * L / (h_m * h_m);
  // What the film remembers is rounded: a motion of the plate by less than that in a step is not used as a measure.
  const double speed = std::max(std::abs(closing), kStandstill * h_m / inputs.time_step);
  const double squeeze = eta * speed * L * L / (h_m * h_m * h_m);
  const cycle::Pad& pad = setup.input.pad;
  double highest = std::max(inputs.left.pressure, inputs.right.pressure);
  if (pad.has_sides_at_pressures()) highest = std::max({highest, pad.front_pressure, pad.back_pressure});
  const double edges = highest - inputs.p_cavitation;
  const double largest = std::max({wedge, squeeze, edges});
  return largest > 0 ? largest : kNoPressure;
}

void count(const film::FilmReport& report, Effort& effort) {
  effort.newton_iterations += report.iterations;
  if (report.converged) effort.max_newton_step = std::max(effort.max_newton_step, report.last_step);
}

/// Raises the speed from a fraction of its own.
bool ease_in(PadFilm& film, const film::FilmInputs& inputs, film::FilmState& state, Effort& effort) {
  ++effort.eased_starts;
  film::FilmState reached = film.full(state.h_m);
  for (int halvings = kSpeedHalvings; halvings >= 0; --halvings) {
    film::FilmInputs slower = inputs;
    slower.U = std::ldexp(inputs.U, -halvings);
    state = reached;
    if (!solve_at_separation(film, slower, 0, reached, state, effort)) return false;
    reached = state;
  }
  return true;
}

}  // namespace

bool solve_at_separation(PadFilm& film, film::FilmInputs inputs, double closing, const film::FilmState& previous,
                         film::FilmState& state, Effort& effort) {
  const double estimate = estimated_pressure(film.setup(), inputs, state.h_m, closing);
  // The film is solved to a share of an estimate of its pressures: as long as they turn out far below, they are the
  // next estimate, until nothing but rounding is left of them.
  double scale = estimate;
  for (int k = 0; k < kMaxEstimates; ++k) {
    const film::FilmState before = state;
    inputs.load = scale * film.setup().input.pad.length;
    const film::FilmReport report = film.solve_at_separation(inputs, previous, state);
    count(report, effort);
    if (!report.converged && k == 0) return false;
    if (!report.converged) {  // no finer than by the estimate before; the balance of mass shows what that is worth
      state = before;
      break;
    }
    const double peak = *std::max_element(state.p.begin(), state.p.end()) - inputs.p_cavitation;
    if (peak <= kNothing * estimate || peak > kFarOff * scale) break;
    scale = peak;
  }
  return true;
}

std::optional<film::FilmState> steady_film_at(PadFilms& films, double separation, Effort& effort) {
  const PadSetup& setup = films.finest().setup();
  const film::FilmInputs inputs = setup.steady_inputs();
  const double h_m = separation + setup.lowest_gap;
  std::optional<film::FilmState> solved;
  const PadFilm* solved_on = nullptr;
  for (std::size_t k = 0; k < films.n_levels(); ++k) {
    PadFilm& level = films.level(k);
    film::FilmState state = solved ? level.guess_from(*solved_on, *solved) : level.full(h_m);
    const film::FilmState guess = state;
    bool converged = solve_at_separation(level, inputs, 0, guess, state, effort);
    if (!converged && &level == &films.finest()) {
      state.h_m = h_m;
      converged = ease_in(level, inputs, state, effort);
      if (!converged) return std::nullopt;
    }
    if (!converged) continue;
    solved = state;
    solved_on = &level;
  }
  return solved;
}

}  // namespace ringfilm::pad
