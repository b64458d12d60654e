#include "ringfilm/film/factors/average_shear.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

double factor(const std::vector<double>& of, int i, double none) { return of.empty() ? none : of[i]; }

}  // namespace

double pressure_slope(const FilmProblem& problem, const FilmState& state, int i) {
  const int low = std::max(i - 1, 0), high = std::min(i + 1, problem.grid.n_cells());
  return (state.p[high] - state.p[low]) / (problem.grid.x[high] - problem.grid.x[low]);
}

double pressure_shear(double h, double slope) { return kPressureShear * h * std::abs(slope); }

AverageShear average_shear(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state,
                           const double* deficit) {
  const FilmGrid& grid = problem.grid;
  const FlowFactors& factors = *state.factors;
  const int upstream = inputs.U >= 0 ? 0 : 1;
  const auto viscosity = [&](int i) {
    return factor(factors.thinning, i, 1) * viscosity_at(*inputs.oil, state.laws, state.p[i]);
  };
  AverageShear sum{0, 0};
  double left = viscosity(0);
  for (int i = 0; i < grid.n_cells(); ++i) {
    const double right = viscosity(i + 1), h = state.h_m + grid.face_height[i];
    const double of_node = film_content(problem.cavitation, deficit[i + upstream]);
    const double content =
        of_node < 1 ? of_node * carried_gap(of_node, state.h_m + grid.node_height[i + upstream], h).gap / h : of_node;
    const double sliding = grid.spacing[i] * content * 0.5 * (left + right) * inputs.U / h;
    sum.mean += factor(factors.sliding_stress, i, 1) * sliding;
    sum.half_difference += 0.5 * factor(factors.pressure_stress, i, 1) * h * (state.p[i + 1] - state.p[i]) -
                           factor(factors.stress_difference, i, 0) * sliding;
    left = right;
  }
  return sum;
}

double peak_shear_rate(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state,
                       const double* deficit, double inside_squared) {
  const FilmGrid& grid = problem.grid;
  const bool is_content = problem.cavitation == Cavitation::kMassConserving;
  const bool thins = state.factors && !state.factors->thinning.empty();
  const auto viscosity = [&](int i) {
    const double eta = viscosity_at(*inputs.oil, state.laws, state.p[i]);
    return thins ? eta * state.factors->thinning[i] : eta;
  };
  const int n = grid.n_cells();
  double largest = thins ? 0 : inside_squared;
  for (int i = 0; i <= n; i += thins ? 1 : n) {
    if (is_content && deficit[i] == 1) continue;  // gas
    const double h = state.h_m + grid.node_height[i];
    const double slide = inputs.U / h;
    const double by_pressure = pressure_shear(h, pressure_slope(problem, state, i)) / viscosity(i);
    largest = std::max(largest, slide * slide + by_pressure * by_pressure);
  }
  return std::sqrt(largest);
}

}  // namespace ringfilm::film
