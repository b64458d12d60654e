#include "ringfilm/film/integrals/film_heating.hpp"

#include <cmath>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/fronts.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

using OneCell = base::Pack<1, base::InstructionSet::kBaseline>;

/// As FilmView has it, of one strip.
FilmView view_of_strip(const FilmProblem& problem, const FilmState& state, int strip, double rise) {
  const FilmGrid& grid = problem.grid;
  const std::size_t first = strip * grid.x.size();
  FilmView film{};
  film.n_cells = grid.n_cells();
  film.face_height = grid.face_height.data();
  film.spacing = grid.spacing.data();
  film.p = state.p.data() + first;
  film.deficit = state.deficit.data() + first;
  film.h_m = state.h_m + rise;
  if (state.factors) {
    const FlowFactors& factors = *state.factors;
    const auto from = [](const std::vector<double>& list, std::size_t i) { return list.empty() ? nullptr : &list[i]; };
    const std::size_t first_face = strip * grid.face_height.size();
    film.mobility = from(factors.mobility, first);
    film.thinning = from(factors.thinning, first);
    film.carried = from(factors.carried, first_face);
    film.sliding_stress = from(factors.sliding_stress, first_face);
    film.inverse_gap = from(factors.inverse_gap, first_face);
  }
  return film;
}

HeatingSums sums_of_full_cells(const FilmProblem& problem, const FilmInputs& inputs, LaneLaws laws,
                               const FilmView& film) {
  if (laws == LaneLaws::kFitted) return problem.kernels->heating(film, fitted_oil_view(*inputs.oil), inputs.U);
  NodalOil oil;
  oil.update(*inputs.oil, {film.p, problem.grid.x.size()});
  return problem.kernels->heating_of_given_oil(film, {oil.rho.data(), oil.K.data()}, inputs.U);
}

/// Length filled with oil of the cell behind node `i`, in which the film ends or begins [m].
double filled_length(const FilmProblem& problem, const FilmInputs& inputs, const GasReach& reach, const double* p,
                     int i, bool ends) {
  const FilmGrid& grid = problem.grid;
  const int inside = ends ? i : i + 1, outside = ends ? i + 1 : i;
  const double front =
      front_position(grid, p, reach.pressure_bound(outside), inside, outside, ends_level(problem, inputs, ends));
  return std::abs(front - grid.x[inside]);
}

}  // namespace

double FilmHeating::rise(double conductivity, double specific_heat) const {
  // A parabola of temperature across the film loses 6 k/h times its mean to each wall.
  const double per_kelvin = mass_flow * specific_heat + 12 * conductivity * conductance;
  return per_kelvin > 0 ? dissipation / per_kelvin : 0;
}

FilmHeating film_heating(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state, int strip,
                         double rise) {
  const FilmView film = view_of_strip(problem, state, strip, rise);
  return film_heating(problem, inputs, GasReach(problem.grid, inputs), film, state.laws,
                      sums_of_full_cells(problem, inputs, state.laws, film));
}

FilmHeating film_heating(const FilmProblem& problem, const FilmInputs& inputs, const GasReach& reach,
                         const FilmView& film, LaneLaws laws, const HeatingSums& full) {
  const FilmGrid& grid = problem.grid;
  FilmHeating sums{full.dissipation, full.conductance, 0};
  double length = full.length, flow = full.flow;
  // In the part of a cell in which the film ends or begins pressure falls to that of the cavity.
  const int n = grid.n_cells();
  for (int i = 0; i < n;) {
    const bool cavity = is_cavity(film.deficit[i]);
    i = problem.kernels->next_node(film.deficit, i + 1, n + 1, !cavity);
    if (i > n) break;
    const double cell = filled_length(problem, inputs, reach, film.p, i - 1, !cavity);
    if (!(cell > 0)) continue;
    const int inside = cavity ? i : i - 1, outside = cavity ? i - 1 : i;
    const double fall = film.p[inside] - reach.pressure_bound(outside);
    const double slope = (cavity ? fall : -fall) / cell;
    const auto& oil = *inputs.oil;
    const double rho[] = {density_at(oil, laws, film.p[i - 1]), density_at(oil, laws, film.p[i])};
    const double K[] = {rho[0] / viscosity_at(oil, laws, film.p[i - 1]), rho[1] / viscosity_at(oil, laws, film.p[i])};
    const auto heat = heating_of_cell<OneCell>(film, inputs.U, rho, K, i - 1, cell, slope);
    sums.dissipation += heat.dissipation.v;
    sums.conductance += heat.conductance.v;
    flow += heat.flow.v;
    length += cell;
  }
  if (length > 0) sums.mass_flow = std::abs(flow) / length;
  return sums;
}

}  // namespace ringfilm::film
