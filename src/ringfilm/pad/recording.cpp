#include "ringfilm/pad/recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ringfilm/cycle/integration/sampling.hpp"
#include "ringfilm/film/cavitation.hpp"

namespace ringfilm::pad {
namespace {

/// NaN without load.
double friction_coefficient(double friction, double load) {
  constexpr double kNoLoad = 1e-6;  // share of the friction: a smaller load is rounding
  return load > kNoLoad * std::abs(friction) ? friction / load : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<double> pressures_between_edges(const PadSetup& setup, const film::FilmGrid& grid) {
  const film::FilmInputs inputs = setup.steady_inputs();
  std::vector<double> p;
  for (const double x : grid.x)
    p.push_back(inputs.left.pressure + (inputs.right.pressure - inputs.left.pressure) * x / grid.width);
  return p;
}

double flux_of_rounding(const film::FilmProblem& problem, const film::FilmInputs& inputs, const film::FilmState& state,
                        double thickest) {
  constexpr double kOfPressures = 1e-8, kMinPressure = 1.0, kOfOil = 1e-8;  // shares, but for the second [Pa]
  const auto [low, high] = std::minmax_element(state.p.begin(), state.p.end());
  const double h = thickest, L = problem.grid.width;
  const double rho = inputs.oil->density(state.p.front()), K = rho / inputs.oil->viscosity(state.p.front());
  const double pressure = std::max({std::abs(*low), std::abs(*high), kMinPressure});
  return std::max(kOfPressures * pressure * h * h * h * K / (12 * L), kOfOil * rho * h * L / inputs.time_step);
}

Peak top_of_parabola(Peak node, double p_before, double p_after, double spacing) {
  const double bend = p_before - 2 * node.pressure + p_after;
  if (!(bend < 0)) return node;
  const double cells = std::clamp(0.5 * (p_before - p_after) / bend, -0.5, 0.5);
  return {node.pressure - 0.25 * (p_before - p_after) * cells, node.position + cells * spacing};
}

Sample sample_of(const PadSetup& setup, const film::FilmIntegrals& sums, double h_m, double time) {
  const double sense = setup.runs_left() ? -1 : 1;
  const double density = setup.density;
  Sample out;
  out.time = time;
  out.load = sums.hydrodynamic_load + sums.asperity_load;
  out.asperity_load = sums.asperity_load;
  out.mean_film_pressure = sums.hydrodynamic_load / setup.input.pad.length;
  out.separation = h_m - setup.lowest_gap;
  out.min_film_thickness = h_m;
  if (setup.U != 0)
    out.boundary_friction = cycle::boundary_friction(setup.input.contact, sums.asperity_load, sums.asperity_area);
  out.friction_moving = sense * (sums.shear_couette + sums.shear_poiseuille) + out.boundary_friction;
  out.friction_fixed = sense * (sums.shear_couette - sums.shear_poiseuille) + out.boundary_friction;
  out.friction_coefficient = friction_coefficient(out.friction_moving, out.load);
  out.mass_flow_left = sums.flow_left;
  out.mass_flow_right = sums.flow_right;
  out.flow_left = sums.flow_left / density;
  out.flow_right = sums.flow_right / density;
  out.cavitated_fraction = sums.cavitated_fraction;
  const double L = setup.input.pad.length;
  out.wetted_left = std::clamp(sums.wetted_begin, 0.0, L);
  out.wetted_right = std::clamp(sums.wetted_end, 0.0, L);
  out.gas_load =
      setup.input.pad.left_pressure * out.wetted_left + setup.input.pad.right_pressure * (L - out.wetted_right);
  out.film_load = sums.hydrodynamic_load - out.gas_load;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  out.film_temperature = setup.film_temperature.value_or(kNaN);
  out.viscous_heating_rise = kNaN;
  out.film_left_behind = setup.U == 0 ? kNaN : (setup.U > 0 ? out.flow_right : out.flow_left) / setup.U;
  out.gas_breakthrough = sums.is_broken_through ? 1 : 0;
  out.stable_solutions = kNaN;
  out.journal_load = out.journal_load_angle = out.attitude_angle = kNaN;
  return out;
}

void add_journal_load(const PadSetup& setup, const film::FilmGrid& grid, const std::vector<double>& across,
                      const std::vector<double>& p, Sample& sample) {
  const std::optional<double>& radius = setup.input.pad.journal_radius;
  if (!radius) return;
  double along_cosine = 0, along_sine = 0, width = 0;
  const double* pressure = p.data();
  for (const double share : across) {
    for (int i = 0; i <= grid.n_cells(); ++i) {
      const double force = share * grid.share[i] * *pressure++, angle = grid.x[i] / *radius;
      along_cosine += force * std::cos(angle);
      along_sine += force * std::sin(angle);
    }
    width += share;
  }
  constexpr double kDegree = 180 / std::numbers::pi;
  const double sense = setup.runs_left() ? -1 : 1;
  sample.journal_load = std::hypot(along_cosine, along_sine) / width;
  sample.journal_load_angle = kDegree * std::atan2(along_sine, along_cosine);
  sample.attitude_angle =
      std::remainder(sense * (kDegree * setup.lowest_x / *radius - sample.journal_load_angle), 360.0);
  sample.friction_coefficient = friction_coefficient(sample.friction_moving, sample.journal_load);
}

void add_fronts(const PadSetup& setup, const film::FilmInputs& inputs, const std::vector<double>& deficit,
                const film::FilmIntegrals& sums, Sample& sample) {
  const double L = setup.input.pad.length;
  const bool leftwards = inputs.U < 0;
  const std::size_t n = deficit.size();
  const bool open_left = leftwards && deficit[1] > 0 && inputs.left.pressure <= inputs.p_cavitation;
  const bool open_right = !leftwards && deficit[n - 2] > 0 && inputs.right.pressure <= inputs.p_cavitation;
  for (const film::Cavity& cavity : sums.cavities) {
    const double begin = std::clamp(cavity.begin, 0.0, L), end = std::clamp(cavity.end, 0.0, L);
    sample.rupture_positions.push_back(leftwards ? end : begin);
    const bool is_first = &cavity == &sums.cavities.front(), is_last = &cavity == &sums.cavities.back();
    if ((is_first && open_left) || (is_last && open_right)) continue;
    sample.reformation_positions.push_back(leftwards ? begin : end);
  }
}

std::vector<double> places_with_steps(const std::vector<double>& nodes, const std::vector<int>& steps,
                                      std::optional<double> last) {
  std::vector<double> places = nodes;
  if (last) places.push_back(*last);
  for (const int node : steps) places.push_back(nodes[node]);
  std::sort(places.begin(), places.end());
  return places;
}

void append_node(Profile& along, const ProfilePoint& point) {
  along.film_thickness.push_back(point.film_thickness);
  along.pressure.push_back(point.pressure);
  along.film_content.push_back(point.film_content);
}

void append_step(const PadSetup& setup, Profile& along, double left, double right, double pressure,
                 double film_content) {
  // In a cavity the liner carries the same oil past both heights; a full film fills both.
  const bool is_cavity = film::is_cavity(1 - film_content);
  append_node(along,
              {left, pressure, is_cavity && setup.U > 0 ? std::min(1.0, film_content * right / left) : film_content});
  append_node(along,
              {right, pressure, is_cavity && setup.U < 0 ? std::min(1.0, film_content * left / right) : film_content});
}

}  // namespace ringfilm::pad
