#include "ringfilm/pad/recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/film_integrals.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::pad {
namespace {

/// The largest mass flux in the film, or what rounding makes of a film in which nothing flows: of its pressures, and of
/// the oil that it holds from step to step.
double largest_flux(const film::FilmProblem& problem, const film::FilmInputs& inputs, const film::FilmState& state) {
  constexpr double kOfPressures = 1e-8, kSmallestPressure = 1.0, kOfOil = 1e-8;  // shares, but for the second [Pa]
  const auto [low, high] = std::minmax_element(state.p.begin(), state.p.end());
  const auto thickest = std::max_element(problem.grid.node_height.begin(), problem.grid.node_height.end());
  const double h = state.h_m + *thickest, L = problem.grid.width;
  const double rho = problem.oil->density(state.p.front()), K = rho / problem.oil->viscosity(state.p.front());
  const double pressure = std::max({std::abs(*low), std::abs(*high), kSmallestPressure});
  double largest =
      std::max(kOfPressures * pressure * h * h * h * K / (12 * L), kOfOil * rho * h * L / inputs.time_step);
  for (int i = 0; i < problem.grid.n_cells(); ++i) {
    largest = std::max(largest, std::abs(film::mass_flux(problem, inputs, state, i)));
  }
  return largest;
}

struct Peak {
  double pressure, position;
};

/// The highest node, or the top of the parabola through it and its neighbours where the film is smooth there.
Peak peak(const film::FilmGrid& grid, const film::FilmState& state) {
  const auto& p = state.p;
  const int n = grid.n_cells();
  const int top = static_cast<int>(std::max_element(p.begin(), p.end()) - p.begin());
  const Peak at_node{p[top], grid.x[top]};
  const bool at_jump = std::any_of(grid.jumps.begin(), grid.jumps.end(), [&](const auto& j) { return j.node == top; });
  if (top == 0 || top == n || at_jump || state.deficit[top - 1] > 0 || state.deficit[top + 1] > 0) return at_node;
  const double bend = p[top - 1] - 2 * p[top] + p[top + 1];
  if (!(bend < 0)) return at_node;
  const double cells = std::clamp(0.5 * (p[top - 1] - p[top + 1]) / bend, -0.5, 0.5);
  return {p[top] - 0.25 * (p[top - 1] - p[top + 1]) * cells, grid.x[top] + cells * grid.spacing[top]};
}

/// Ends of the cavities in the sense of the motion; at rest the left one counts as upstream.
void add_fronts(const PadSetup& setup, const film::FilmInputs& inputs, const film::FilmState& state,
                const film::FilmIntegrals& sums, Sample& sample) {
  const double L = setup.input.pad.length;
  const bool leftwards = inputs.U < 0;
  const std::size_t n = state.p.size();
  const bool open_left = leftwards && state.deficit[1] > 0 && inputs.p_left <= inputs.p_cavitation;
  const bool open_right = !leftwards && state.deficit[n - 2] > 0 && inputs.p_right <= inputs.p_cavitation;
  for (const film::Cavity& cavity : sums.cavities) {
    const double begin = std::clamp(cavity.begin, 0.0, L), end = std::clamp(cavity.end, 0.0, L);
    sample.rupture_positions.push_back(leftwards ? end : begin);
    const bool is_first = &cavity == &sums.cavities.front(), is_last = &cavity == &sums.cavities.back();
    if ((is_first && open_left) || (is_last && open_right)) continue;
    sample.reformation_positions.push_back(leftwards ? begin : end);
  }
}

}  // namespace

std::vector<double> profile_places(const film::FilmGrid& grid) {
  std::vector<double> x = grid.x;
  for (const film::GapJump& jump : grid.jumps) x.push_back(grid.x[jump.node]);
  std::sort(x.begin(), x.end());
  return x;
}

Profile profile(const PadSetup& setup, const film::FilmProblem& problem, const film::FilmState& state, double time) {
  Profile along;
  along.time = time;
  const auto add = [&](int i, double height, double fill) {
    along.film_thickness.push_back(state.h_m + height);
    along.pressure.push_back(state.p[i]);
    along.fill.push_back(fill);
  };
  auto jump = problem.grid.jumps.begin();
  for (int i = 0; i <= problem.grid.n_cells(); ++i) {
    const double fill = film::fill(problem.cavitation, state.deficit[i]);
    if (jump == problem.grid.jumps.end() || jump->node != i) {
      add(i, problem.grid.node_height[i], fill);
      continue;
    }
    // The fill of the node is that of its downstream side; upstream the same oil flows through the other gap.
    const double left = state.h_m + jump->height_left, right = state.h_m + jump->height_right;
    const bool moves_right = setup.U > 0, moves_left = setup.U < 0;
    add(i, jump->height_left, moves_right ? std::min(1.0, fill * right / left) : fill);
    add(i, jump->height_right, moves_left ? std::min(1.0, fill * left / right) : fill);
    ++jump;
  }
  return along;
}

Sample sample(const PadSetup& setup, const film::FilmProblem& problem, const film::FilmInputs& inputs,
              const film::FilmState& previous, const film::FilmState& state, double time) {
  const film::FilmIntegrals sums = film::film_integrals(problem, inputs, previous, state);
  const double sense = setup.runs_left() ? -1 : 1;
  const double density = setup.input.lubricant.constant_density.value();
  Sample out;
  out.time = time;
  out.load = sums.hydrodynamic_load;
  out.mean_film_pressure = out.load / problem.grid.width;
  const Peak top = peak(problem.grid, state);
  out.peak_film_pressure = top.pressure;
  out.peak_position = top.position;
  out.separation = state.h_m - setup.lowest_gap;
  out.min_film_thickness = state.h_m;
  out.friction_moving = sense * (sums.shear_couette + sums.shear_poiseuille);
  out.friction_fixed = sense * (sums.shear_couette - sums.shear_poiseuille);
  constexpr double kNoLoad = 1e-6;  // of the friction: what the load is then is rounding
  out.friction_coefficient = out.load > kNoLoad * std::abs(out.friction_moving)
                                 ? out.friction_moving / out.load
                                 : std::numeric_limits<double>::quiet_NaN();
  out.mass_flow_left = sums.flow_left;
  out.mass_flow_right = sums.flow_right;
  out.flow_left = sums.flow_left / density;
  out.flow_right = sums.flow_right / density;
  out.cavitated_fraction = sums.cavitated_fraction;
  const double largest_flow = largest_flux(problem, inputs, state);
  out.mass_residual = largest_flow > 0 ? std::abs(sums.mass_defect) / largest_flow : 0.0;
  add_fronts(setup, inputs, state, sums, out);
  return out;
}

}  // namespace ringfilm::pad
