#include "ringfilm/film/film_integrals.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

/// From this film parameter on, the F5/2 polynomial as printed rises again (docs/theory/paper-errata.md).
constexpr double kPolynomialTurns = 1.911;

void add_contact(const FilmProblem& problem, const FilmState& state, FilmIntegrals& sums) {
  const FilmGrid& grid = problem.grid;
  const int n = grid.n_cells();
  for (int i = 0; i <= n; ++i) {
    const double h = problem.contact_spread == ContactSpread::kNominal ? state.h_m : state.h_m + grid.node_height[i];
    const auto contact = problem.contact->contact(h);
    const double weight = (i == 0 || i == n ? 0.5 : 1.0) * grid.dx;
    sums.hydrodynamic_load += weight * state.p[i];
    sums.asperity_load += weight * contact.pressure;
    sums.asperity_area += weight * contact.area_share;
    if (h > kPolynomialTurns * problem.contact->parameters().sigma) {
      sums.asperity_load_beyond_polynomial += weight * contact.pressure;
    }
  }
}

void add_shear(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state, FilmIntegrals& sums) {
  const FilmGrid& grid = problem.grid;
  for (int i = 0; i < grid.n_cells(); ++i) {
    const double h = state.h_m + grid.face_height[i];
    const double eta = 0.5 * (state.eta[i] + state.eta[i + 1]);
    const double theta =
        0.5 * (fill(problem.cavitation, state.deficit[i]) + fill(problem.cavitation, state.deficit[i + 1]));
    sums.shear_couette += grid.dx * theta * eta * inputs.U / h;
    sums.shear_poiseuille += 0.5 * h * (state.p[i + 1] - state.p[i]);
  }
}

void add_flow(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, const FilmState& state,
              FilmIntegrals& sums) {
  const int n = problem.grid.n_cells();
  const auto storage = [&](int i) {
    return problem.grid.dx / inputs.time_step * (state.content[i] - previous.content[i]);
  };
  sums.flow_left = mass_flux(problem, inputs, state, 0) + 0.5 * storage(0);
  sums.flow_right = mass_flux(problem, inputs, state, n - 1) - 0.5 * storage(n);
  sums.flow_middle =
      n % 2 == 1 ? mass_flux(problem, inputs, state, n / 2)
                 : 0.5 * (mass_flux(problem, inputs, state, n / 2 - 1) + mass_flux(problem, inputs, state, n / 2));
  sums.mass_defect = sums.flow_right - sums.flow_left + 0.5 * (storage(0) + storage(n));
  for (int i = 1; i < n; ++i) sums.mass_defect += storage(i);
}

void add_cavities(const FilmProblem& problem, const FilmState& state, FilmIntegrals& sums) {
  const FilmGrid& grid = problem.grid;
  sums.peak_pressure = *std::max_element(state.p.begin(), state.p.end());
  for (int i = 0; i <= grid.n_cells(); ++i) {
    if (state.deficit[i] == 0) continue;
    sums.cavitated_fraction += 1.0 / grid.n_cells();
    if (!sums.cavity_begin) sums.cavity_begin = grid.x(i);
    sums.cavity_end = grid.x(i);
  }
}

}  // namespace

FilmIntegrals film_integrals(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                             const FilmState& state) {
  FilmIntegrals sums;
  add_contact(problem, state, sums);
  add_shear(problem, inputs, state, sums);
  add_flow(problem, inputs, previous, state, sums);
  add_cavities(problem, state, sums);
  return sums;
}

}  // namespace ringfilm::film
