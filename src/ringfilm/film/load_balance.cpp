#include "ringfilm/film/load_balance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/film/gas_reach.hpp"

namespace ringfilm::film {

double thickest(const FilmProblem& problem) {
  constexpr double kWidths = 1e2;
  return std::max(kWidths * problem.grid.width, problem.contact == nullptr ? 0.0 : problem.contact->reach());
}

double enough_of_newton(const FilmProblem& problem) {
  // relative to the usual: film and asperities then balance to better than sqrt(tolerance)
  constexpr double kAtKinks = 1e-2;
  const bool kinked = problem.contact != nullptr && problem.contact->has_kinks();
  return std::sqrt(problem.tolerance) * (kinked ? kAtKinks : 1);
}

double asperity_load(const FilmProblem& problem, double h_m, double* slope) {
  double load = 0;
  double d_load = 0;
  const auto add = [&](double h, double share) {
    if (h >= problem.contact->reach()) return;
    double p_a;
    double dp_a;
    problem.contact->pressure(h, p_a, dp_a);
    load += share * p_a;
    d_load += share * dp_a;
  };
  if (problem.contact == nullptr) {
    // smooth surfaces
  } else if (problem.contact_spread == ContactSpread::kNominal) {
    add(h_m, problem.grid.width);
  } else {
    const FilmGrid& grid = problem.grid;
    for (std::size_t i = 0; i < grid.x.size(); ++i) add(h_m + grid.node_height[i], grid.share[i]);
  }
  if (slope != nullptr) *slope = d_load;
  return load;
}

double land_load(const FilmProblem& problem, const FilmInputs& inputs, double h_m, double* slope) {
  if (slope != nullptr) *slope = 0;
  if (problem.land == nullptr || inputs.U == 0) return 0;
  const FilmGrid& grid = problem.grid;
  const double eta_U = inputs.oil->viscosity(inputs.p_cavitation) * std::abs(inputs.U);
  double load = 0, d_load = 0, height = std::numeric_limits<double>::quiet_NaN();
  models::LandLift::At at;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    if (grid.node_height[i] != height) {  // a flat land has one height
      height = grid.node_height[i];
      at = problem.land->at(h_m + height, eta_U);
    }
    load += grid.share[i] * at.lift;
    d_load += grid.share[i] * at.lift_slope;
  }
  if (slope != nullptr) *slope = d_load;
  return load;
}

double land_shear(const FilmProblem& problem, const FilmInputs& inputs, double h_m) {
  if (problem.land == nullptr || inputs.U == 0) return 0;
  const FilmGrid& grid = problem.grid;
  const double eta_U = inputs.oil->viscosity(inputs.p_cavitation) * inputs.U;
  double shear = 0;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const double h = h_m + grid.node_height[i];
    shear += grid.share[i] * (problem.land->friction_factor(h) - 1) * eta_U / h;
  }
  return shear;
}

namespace {

double load_of_film(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state) {
  double load = GasReach(problem.grid, inputs).load_beyond_place(state.p, state.deficit);
  for (std::size_t i = 0; i < state.p.size(); ++i) load += problem.grid.share[i] * state.p[i];
  return load;
}

}  // namespace

double hydrodynamic_load(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state) {
  return load_of_film(problem, inputs, state) + land_load(problem, inputs, state.h_m);
}

double least_hydrodynamic_load(const FilmProblem& problem, const FilmInputs& inputs) {
  const GasReach reach(problem.grid, inputs);
  FilmState least;
  for (int i = 0; i <= problem.grid.n_cells(); ++i) least.p.push_back(reach.pressure_bound(i));
  return load_of_film(problem, inputs, least);
}

double edge_pressure_load(const FilmProblem& problem, FilmInputs inputs) {
  inputs.left.fluid = inputs.right.fluid = EdgeFluid::kGas;
  return least_hydrodynamic_load(problem, inputs);
}

}  // namespace ringfilm::film
