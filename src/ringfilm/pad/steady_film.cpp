#include "ringfilm/pad/steady_film.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::pad {
namespace {

constexpr int kCoarsest = 16;          // cells of the first grid
constexpr int kSpeedHalvings = 8;      // the slowest start of a speed that is raised little by little
constexpr double kFarOff = 0.1;        // an estimate of the pressures is not used if they turn out below this share
constexpr int kMostEstimates = 40;     // each a tenth of the one before or less
constexpr double kNothing = 1e-40;     // of the first estimate
constexpr double kStandstill = 1e-10;  // of the film in one step
constexpr double kNoPressure = 1.0;    // scale where neither motion nor edges make any pressure [Pa]

/// Pressures that wedge, squeeze and edges may make [Pa]; never 0.
double estimated_pressure(const PadSetup& setup, const film::FilmInputs& inputs, double h_m, double closing) {
  const double L = setup.input.pad.length, eta = setup.input.lubricant.viscosity;
  const double wedge = eta * std::abs(inputs.U) * L / (h_m * h_m);
  // What the film remembers is rounded: a plate that moves by less than that in a step is no measure.
  const double speed = std::max(std::abs(closing), kStandstill * h_m / inputs.time_step);
  const double squeeze = eta * speed * L * L / (h_m * h_m * h_m);
  const double edges = std::max(inputs.p_left, inputs.p_right) - inputs.p_cavitation;
  const double largest = std::max({wedge, squeeze, edges});
  return largest > 0 ? largest : kNoPressure;
}

void count(const film::FilmReport& report, Effort& effort) {
  effort.newton_iterations += report.iterations;
  if (report.converged) effort.max_newton_step = std::max(effort.max_newton_step, report.last_step);
}

double line(const std::vector<double>& x, const std::vector<double>& y, double at, std::size_t& k) {
  while (k + 2 < x.size() && x[k + 1] < at) ++k;
  return y[k] + (y[k + 1] - y[k]) * (at - x[k]) / (x[k + 1] - x[k]);
}

/// A film of a coarser grid as a guess on a finer one.
film::FilmState refined(const film::FilmGrid& coarse, const film::FilmState& solved, const film::FilmGrid& fine) {
  film::FilmState guess;
  guess.h_m = solved.h_m;
  std::size_t k = 0;
  for (const double x : fine.x) {
    guess.p.push_back(line(coarse.x, solved.p, x, k));
    const bool cavity = solved.deficit[k] > 0 && solved.deficit[k + 1] > 0;
    guess.deficit.push_back(cavity ? line(coarse.x, solved.deficit, x, k) : 0.0);
  }
  guess.deficit.front() = guess.deficit.back() = 0;
  guess.content.assign(fine.x.size(), 0.0);
  return guess;
}

/// Numbers of cells from the coarsest grid to that of the problem.
std::vector<int> levels(int n_cells) {
  std::vector<int> cells{n_cells};
  while (cells.back() >= 2 * kCoarsest) cells.push_back(cells.back() / 2);
  std::reverse(cells.begin(), cells.end());
  return cells;
}

/// Raises the speed from a fraction of its own.
bool ease_in(const PadSetup& setup, const film::FilmProblem& problem, const film::FilmInputs& inputs,
             film::FilmState& state, film::FilmWorkspace& workspace, Effort& effort) {
  ++effort.eased_starts;
  film::FilmState reached = full_film(setup, problem, state.h_m);
  for (int halvings = kSpeedHalvings; halvings >= 0; --halvings) {
    film::FilmInputs slower = inputs;
    slower.U = std::ldexp(inputs.U, -halvings);
    state = reached;
    if (!solve_at_separation(setup, problem, slower, 0, reached, state, workspace, effort)) return false;
    reached = state;
  }
  return true;
}

}  // namespace

bool solve_at_separation(const PadSetup& setup, const film::FilmProblem& problem, film::FilmInputs inputs,
                         double closing, const film::FilmState& previous, film::FilmState& state,
                         film::FilmWorkspace& workspace, Effort& effort) {
  const double width = problem.grid.width;
  const double estimate = estimated_pressure(setup, inputs, state.h_m, closing);
  // The film is solved to a share of an estimate of its pressures: as long as they turn out far below, they are the
  // next estimate, until nothing but rounding is left of them.
  double scale = estimate;
  for (int k = 0; k < kMostEstimates; ++k) {
    const film::FilmState before = state;
    inputs.load = scale * width;
    const film::FilmReport report = film::solve_film_at_separation(problem, inputs, previous, state, workspace);
    count(report, effort);
    if (!report.converged && k == 0) return false;
    if (!report.converged) {  // no finer than by the estimate before; the balance of mass tells what that is worth
      state = before;
      break;
    }
    const double peak = *std::max_element(state.p.begin(), state.p.end()) - inputs.p_cavitation;
    if (peak <= kNothing * estimate || peak > kFarOff * scale) break;
    scale = peak;
  }
  return true;
}

film::FilmState full_film(const PadSetup& setup, const film::FilmProblem& problem, double h_m) {
  const film::FilmInputs inputs = setup.steady_inputs();
  film::FilmState state;
  state.h_m = h_m;
  for (const double x : problem.grid.x) {
    state.p.push_back(inputs.p_left + (inputs.p_right - inputs.p_left) * x / problem.grid.width);
  }
  state.deficit.assign(state.p.size(), 0.0);
  state.content.assign(state.p.size(), 0.0);
  return state;
}

std::optional<film::FilmState> steady_film_at(const PadSetup& setup, const film::FilmProblem& problem,
                                              double separation, Effort& effort) {
  const film::FilmInputs inputs = setup.steady_inputs();
  const double h_m = separation + setup.lowest_gap;
  std::optional<film::FilmState> solved;
  film::FilmGrid solved_on;
  for (const int n_cells : levels(setup.input.solver.cells)) {
    const film::FilmProblem level = setup.problem(n_cells);
    film::FilmState state = solved ? refined(solved_on, *solved, level.grid) : full_film(setup, level, h_m);
    film::FilmWorkspace workspace(level);
    const film::FilmState guess = state;
    bool converged = solve_at_separation(setup, level, inputs, 0, guess, state, workspace, effort);
    if (!converged && level.grid.n_cells() == problem.grid.n_cells()) {
      state.h_m = h_m;
      converged = ease_in(setup, level, inputs, state, workspace, effort);
      if (!converged) return std::nullopt;
    }
    if (!converged) continue;
    solved = state;
    solved_on = level.grid;
  }
  return solved;
}

}  // namespace ringfilm::pad
