#include "ringfilm/pad/wide_film.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/integrals/film_heating.hpp"
#include "ringfilm/film/integrals/film_integrals.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"
#include "ringfilm/pad/recording.hpp"

namespace ringfilm::pad {
namespace {

double largest_flux(const film::FilmProblem& problem, const film::FilmInputs& inputs, const film::FilmState& state) {
  const auto thickest = std::max_element(problem.grid.node_height.begin(), problem.grid.node_height.end());
  double largest = flux_of_rounding(problem, inputs, state, state.h_m + *thickest);
  const film::FilmView view = film::film_view(problem, inputs, state);
  for (int i = 0; i < problem.grid.n_cells(); ++i) {
    largest = std::max(largest, std::abs(film::mass_flux(view, inputs, state, i)));
  }
  return largest;
}

Peak peak(const film::FilmGrid& grid, const film::FilmState& state) {
  const int n = grid.n_cells();
  const int top = static_cast<int>(std::max_element(state.p.begin(), state.p.end()) - state.p.begin());
  const Peak at_node{state.p[top], grid.x[top]};
  const bool at_jump = std::any_of(grid.jumps.begin(), grid.jumps.end(), [&](const auto& j) { return j.node == top; });
  if (top == 0 || top == n || at_jump || state.deficit[top - 1] > 0 || state.deficit[top + 1] > 0) return at_node;
  return top_of_parabola(at_node, state.p[top - 1], state.p[top + 1], grid.spacing[top]);
}

}  // namespace

WideFilm::WideFilm(const PadSetup& setup, int n_cells)
    : PadFilm(setup),
      problem_(setup.problem(film::grid_of_pieces(n_cells, setup.pieces))),
      factors_(problem_, setup.factors),
      workspace_(problem_) {}

double WideFilm::lowest_height() const {
  const film::FilmGrid& grid = problem_.grid;
  double lowest = std::min(*std::min_element(grid.node_height.begin(), grid.node_height.end()),
                           *std::min_element(grid.face_height.begin(), grid.face_height.end()));
  for (const film::GapJump& jump : grid.jumps) lowest = std::min({lowest, jump.height_left, jump.height_right});
  return lowest;
}

film::FilmInputs WideFilm::supplied(film::FilmInputs inputs, double h_m) const {
  inputs.h_m_before = h_m;
  if (const auto supply = setup().supply()) {
    film::EdgeState& inlet = inputs.U >= 0 ? inputs.left : inputs.right;
    inlet.supply = *supply * inputs.oil->density(inlet.pressure);
  }
  return inputs;
}

std::optional<int> WideFilm::crest(const film::FilmInputs& inputs, const film::FilmState& state) const {
  const bool to_right = inputs.U >= 0;
  const film::EdgeState &inlet = to_right ? inputs.left : inputs.right, &outlet = to_right ? inputs.right : inputs.left;
  const double fall = inlet.pressure - outlet.pressure;
  if (!inputs.is_steady() || inlet.fluid != film::EdgeFluid::kGas || !(fall > 0)) return std::nullopt;
  // From its peak on the film falls to the pressure of the outlet: below that of the inlet, maybe before the lowest
  // place, and no gas of the inlet is there.
  constexpr double kRounding = 1e-6;
  const int top = static_cast<int>(std::max_element(state.p.begin(), state.p.end()) - state.p.begin());
  const bool is_peak = state.p[top] > inlet.pressure + kRounding * fall;
  const film::GasReach reach(problem_.grid, inputs);
  const bool is_before = to_right ? top < reach.end() : top > reach.begin();
  return is_peak && is_before ? std::optional(top) : std::nullopt;
}

film::FilmReport WideFilm::solve_at_separation(const film::FilmInputs& given, const film::FilmState& previous,
                                               film::FilmState& state) {
  constexpr int kMaxMoves = 5;  // moves of the node at which the bounds meet; one or two are usual
  const film::FilmInputs inputs = supplied(given, state.h_m);
  film::FilmInputs held = inputs;
  film::FilmReport total = solve_with_bounds(held, previous, state);
  for (int move = 0; move < kMaxMoves && total.converged; ++move) {
    const std::optional<int> node = crest(inputs, state);
    if (node == held.crest) break;
    held.crest = node;
    film::FilmState next = state;
    const film::FilmReport report = solve_with_bounds(held, previous, next);
    total.iterations += report.iterations;
    if (!report.converged) break;
    state = std::move(next);
  }
  return total;
}

film::FilmReport WideFilm::solve_with_bounds(const film::FilmInputs& inputs, const film::FilmState& previous,
                                             film::FilmState& state) {
  return factors_.solve(inputs, state, [&](const film::FilmInputs& held, film::FilmState& found) {
    return film::solve_film_at_separation(problem_, held, previous, found, workspace_);
  });
}

film::FilmReport WideFilm::solve(const film::FilmInputs& given, const film::FilmState& previous,
                                 film::FilmState& state) {
  film::FilmInputs inputs = given;
  inputs.h_m_before = previous.h_m;
  return factors_.solve(inputs, state, [&](const film::FilmInputs& held, film::FilmState& found) {
    return film::solve_film(problem_, held, previous, found, workspace_);
  });
}

film::FilmState WideFilm::full(double h_m) const {
  film::FilmState state;
  state.h_m = h_m;
  state.p = pressures_between_edges(setup(), problem_.grid);
  state.deficit.assign(state.p.size(), 0.0);
  state.mass_per_area.assign(state.p.size(), 0.0);
  return state;
}

double WideFilm::load(const film::FilmState& state) const {
  film::FilmInputs inputs = supplied(setup().steady_inputs(), state.h_m);
  inputs.crest = crest(inputs, state);
  return film::hydrodynamic_load(problem_, inputs, state) + film::asperity_load(problem_, state.h_m);
}

Sample WideFilm::sample(const film::FilmInputs& given, const film::FilmState& previous, const film::FilmState& state,
                        double time) const {
  film::FilmInputs inputs = supplied(given, state.h_m);
  inputs.crest = crest(inputs, state);
  const film::FilmIntegrals sums = film::film_integrals(problem_, inputs, previous, state);
  Sample out = sample_of(setup(), sums, state.h_m, time);
  const Peak top = peak(problem_.grid, state);
  out.peak_film_pressure = top.pressure;
  out.peak_position = top.position;
  const double largest_flow = largest_flux(problem_, inputs, state);
  out.mass_residual = largest_flow > 0 ? std::abs(sums.mass_defect) / largest_flow : 0.0;
  const cycle::Lubricant& oil = setup().input.lubricant;
  out.viscous_heating_rise =
      film::film_heating(problem_, inputs, state).rise(oil.thermal_conductivity, oil.specific_heat);
  add_fronts(setup(), inputs, state.deficit, sums, out);
  add_journal_load(setup(), problem_.grid, {1.0}, state.p, out);
  return out;
}

std::vector<double> WideFilm::places_x() const {
  std::vector<int> nodes;
  for (const film::GapJump& jump : problem_.grid.jumps) nodes.push_back(jump.node);
  return places_with_steps(problem_.grid.x, nodes, std::nullopt);
}

Profile WideFilm::profile(const film::FilmState& state, double time) const {
  Profile along;
  along.time = time;
  auto jump = problem_.grid.jumps.begin();
  for (int i = 0; i <= problem_.grid.n_cells(); ++i) {
    const double film_content = film::film_content(problem_.cavitation, state.deficit[i]);
    if (jump == problem_.grid.jumps.end() || jump->node != i) {
      append_node(along, {state.h_m + problem_.grid.node_height[i], state.p[i], film_content});
      continue;
    }
    append_step(setup(), along, state.h_m + jump->height_left, state.h_m + jump->height_right, state.p[i],
                film_content);
    ++jump;
  }
  return along;
}

}  // namespace ringfilm::pad
