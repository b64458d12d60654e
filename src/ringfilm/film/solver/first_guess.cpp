#include "ringfilm/film/solver/first_guess.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/solver/film_solver.hpp"

namespace ringfilm::film {
namespace {

constexpr double kSliderLoad = 0.16;       // W h^2/(eta U b^2) of the best plane slider
constexpr int kCoarsest = 16;              // cells of the grid on which a first guess starts
constexpr double kCoarseTolerance = 1e-4;  // tolerance of films that only serve as a start
constexpr double kAtMostFull = 0.5;        // film content of a film that begins dry: no pressure in the first step

/// Edge pressures joined linearly, h_m as a plane slider or the asperities would have it.
FilmState coarse_guess(const FilmProblem& problem, const FilmInputs& inputs) {
  const int n = problem.grid.n_cells();
  const double p_mean = inputs.mean_pressure(problem.grid);
  const double eta = inputs.oil->viscosity(std::max(inputs.left.pressure, inputs.right.pressure));
  FilmState state;
  const double rough = problem.contact == nullptr ? 0.0 : 2 * problem.contact->length_scale();
  state.h_m = std::max(rough, std::sqrt(kSliderLoad * eta * std::abs(inputs.U) * problem.grid.width / p_mean));
  for (const double x : problem.grid.x) {
    const double share = x / problem.grid.width;
    state.p.push_back(
        std::max(inputs.left.pressure + (inputs.right.pressure - inputs.left.pressure) * share, inputs.p_cavitation));
  }
  state.deficit.assign(n + 1, 0.0);
  state.mass_per_area.assign(n + 1, 0.0);
  return state;
}

/// Every second node. A jump may be lost: good enough to start from.
FilmProblem coarsened(const FilmProblem& problem) {
  const FilmGrid& fine = problem.grid;
  FilmProblem coarse = problem;
  FilmGrid& grid = coarse.grid;
  const int n = fine.n_cells() / 2;
  grid = {};
  grid.width = fine.width;
  for (int i = 0; i <= n; ++i) {
    grid.x.push_back(fine.x[2 * i]);
    grid.node_height.push_back(fine.node_height[2 * i]);
  }
  for (int i = 0; i < n; ++i) {
    grid.spacing.push_back(grid.x[i + 1] - grid.x[i]);
    grid.face_height.push_back(fine.node_height[2 * i + 1]);
  }
  complete_grid(grid);
  return coarse;
}

}  // namespace

std::optional<FilmState> dry_film(const FilmProblem& problem, const FilmInputs& inputs, double on_wall) {
  const bool between_gases = inputs.left.fluid == EdgeFluid::kGas && inputs.right.fluid == EdgeFluid::kGas;
  if (!between_gases || problem.contact == nullptr) return std::nullopt;
  const double carried = inputs.load - least_hydrodynamic_load(problem, inputs);
  const auto excess = [&](double ln_h) { return asperity_load(problem, std::exp(ln_h)) / carried - 1; };
  const double thin = std::log(kMolecules), thick = std::log(problem.contact->reach());
  if (!(carried > 0) || !(excess(thin) > 0) || !(excess(thick) < 0)) return std::nullopt;
  boost::uintmax_t evaluations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, thin, thick, [&](double a, double b) { return b - a < problem.tolerance; }, evaluations);
  return film_on_wall(problem, inputs, std::exp(0.5 * (low + high)), on_wall);
}

FilmState film_on_wall(const FilmProblem& problem, const FilmInputs& inputs, double h_m, double on_wall) {
  const FilmGrid& grid = problem.grid;
  const int n = grid.n_cells();
  FilmState state;
  const GasReach reach(grid, inputs);
  for (int i = 0; i <= n; ++i) state.p.push_back(reach.pressure_bound(i));
  state.h_m = h_m;
  for (int i = 0; i <= n; ++i) {
    const double full = inputs.oil->density(state.p[i]) * (state.h_m + grid.node_height[i]);
    state.mass_per_area.push_back(std::min(on_wall, kAtMostFull * full));
    state.deficit.push_back(1 - state.mass_per_area.back() / full);
  }
  return state;
}

FilmState first_guess(const FilmProblem& problem, const FilmInputs& inputs) {
  FilmState state = coarse_guess(problem, inputs);
  const int n = problem.grid.n_cells();
  if (n % 2 == 1 || n < 2 * kCoarsest) return state;
  FilmProblem coarse = coarsened(problem);
  coarse.tolerance = std::max(problem.tolerance, kCoarseTolerance);
  FilmWorkspace workspace(coarse);
  FilmState solved = first_guess(coarse, inputs);
  const FilmState before = solved;
  if (!solve_film(coarse, inputs, before, solved, workspace).converged) return state;
  state.h_m = solved.h_m;
  for (int i = 0; i <= n; ++i) {
    const int low = i / 2;
    const int high = (i + 1) / 2;
    state.p[i] = 0.5 * (solved.p[low] + solved.p[high]);
    state.deficit[i] =
        solved.deficit[low] > 0 && solved.deficit[high] > 0 ? 0.5 * (solved.deficit[low] + solved.deficit[high]) : 0.0;
  }
  return state;
}

}  // namespace ringfilm::film
