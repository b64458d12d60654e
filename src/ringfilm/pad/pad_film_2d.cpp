#include "ringfilm/pad/pad_film_2d.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/solver2d/steady_film2d.hpp"
#include "ringfilm/pad/recording.hpp"

namespace ringfilm::pad {
namespace {

film::Ends ends_of(cycle::Sides sides) {
  if (sides == cycle::Sides::kPeriodic) return film::Ends::kJoined;
  return sides == cycle::Sides::kClosed ? film::Ends::kClosed : film::Ends::kOpen;
}

bool contains(const std::vector<int>& numbers, int number) {
  return std::binary_search(numbers.begin(), numbers.end(), number);
}

}  // namespace

PadFilm2d::PadFilm2d(const PadSetup& setup, Cells cells)
    : PadFilm(setup),
      grid_(pad_grid_2d(*setup.surface, cells, ends_of(setup.input.pad.sides))),
      problem_{setup.problem(grid_.grid), grid_.around, grid_.gap, {}},
      workspace_(problem_) {}

film::Film2dInputs PadFilm2d::inputs_of(const film::FilmInputs& inputs) const {
  film::Film2dInputs of_film2d;
  of_film2d.strip = inputs;
  const bool open = problem_.around.ends == film::Ends::kOpen;
  of_film2d.p_low = open ? setup().input.pad.front_pressure : inputs.p_cavitation;
  of_film2d.p_high = open ? setup().input.pad.back_pressure : inputs.p_cavitation;
  return of_film2d;
}

film::FilmReport PadFilm2d::solve_at_separation(const film::FilmInputs& inputs, const film::FilmState& previous,
                                                film::FilmState& state) {
  const film::FilmState guess = state;
  const film::Film2dInputs of_film2d = inputs_of(inputs);
  film::FilmReport report = film::solve_film2d_at_separation(problem_, of_film2d, previous, state, workspace_);
  if (report.converged || !film::has_active_set(problem_, of_film2d)) return report;
  // Gaps that differ much, and many small cavities: GMRES ends early, or fronts that advance cell by cell do.
  state = guess;
  report.add(film::solve_steady_film2d(problem_, of_film2d, state));
  return report;
}

film::FilmReport PadFilm2d::solve(const film::FilmInputs& inputs, const film::FilmState& previous,
                                  film::FilmState& state) {
  return film::solve_film2d(problem_, inputs_of(inputs), previous, state, workspace_);
}

film::FilmState PadFilm2d::full(double h_m) const {
  const std::vector<double> along = pressures_between_edges(setup(), problem_.strip.grid);
  const int n_strips = problem_.around.n_strips(), n = problem_.n_across();
  film::FilmState state;
  state.h_m = h_m;
  for (int j = 0; j < n_strips; ++j) state.p.insert(state.p.end(), along.begin(), along.end());
  if (problem_.around.ends == film::Ends::kOpen) {
    // Whole strips, corners too, as in film/ (eq-film-2d-ends).
    std::fill(state.p.begin(), state.p.begin() + n, setup().input.pad.front_pressure);
    std::fill(state.p.end() - n, state.p.end(), setup().input.pad.back_pressure);
  }
  state.deficit.assign(state.p.size(), 0.0);
  state.mass_per_area.assign(state.p.size(), 0.0);
  return state;
}

double PadFilm2d::load(const film::FilmState& state) const {
  const std::vector<double>& share = problem_.strip.grid.share;
  const double* p = state.p.data();
  double load = 0;
  for (const double across : problem_.around.share) {
    double strip = 0;
    for (const double along : share) strip += along * *p++;
    load += across * strip;
  }
  return load / problem_.around.length;
}

double PadFilm2d::largest_flux(const film::FilmInputs& inputs, const film::FilmState& state,
                               const film::Film2dIntegrals& sums) const {
  const double thickest = state.h_m + *std::max_element(problem_.gap.node.begin(), problem_.gap.node.end());
  const double width = problem_.around.length;
  double largest = std::max({flux_of_rounding(problem_.strip, inputs, state, thickest), std::abs(sums.flow_low) / width,
                             std::abs(sums.flow_high) / width});
  for (const film::StripIntegrals& strip : sums.strips) {
    largest = std::max({largest, std::abs(strip.flow_left), std::abs(strip.flow_middle), std::abs(strip.flow_right)});
  }
  return largest;
}

void PadFilm2d::add_peak(const film::FilmState& state, Sample& sample) const {
  const film::FilmGrid& grid = problem_.strip.grid;
  const film::CircumferentialGrid& around = problem_.around;
  const int n = problem_.n_across(), m = around.n_strips();
  const auto top = std::max_element(state.p.begin(), state.p.end()) - state.p.begin();
  const int i = static_cast<int>(top % n), j = static_cast<int>(top / n);
  const Peak in_x{state.p[top], grid.x[i]}, in_y{state.p[top], around.y[j]};
  Peak along = in_x, across = in_y;
  const auto smooth = [&](std::ptrdiff_t before, std::ptrdiff_t after) {
    return !(state.deficit[before] > 0) && !(state.deficit[after] > 0);
  };
  // In the corners stated pressures meet in a jump: no parabola goes through an edge or along one.
  const bool inside_x = i > 1 && i + 2 < n, on_edge_x = i == 0 || i + 1 == n;
  const bool inside_y = is_joined() || (j > 1 && j + 2 < m), on_edge_y = !is_joined() && (j == 0 || j + 1 == m);
  if (inside_x && !on_edge_y && !contains(grid_.steps_x, i) && smooth(top - 1, top + 1)) {
    along = top_of_parabola(in_x, state.p[top - 1], state.p[top + 1], grid.spacing[i]);
  }
  const std::ptrdiff_t before = static_cast<std::ptrdiff_t>((j + m - 1) % m) * n + i;
  const std::ptrdiff_t after = static_cast<std::ptrdiff_t>((j + 1) % m) * n + i;
  if (inside_y && !on_edge_x && !contains(grid_.steps_y, j) && smooth(before, after)) {
    across = top_of_parabola(in_y, state.p[before], state.p[after], around.spacing[j]);
  }
  sample.peak_film_pressure = along.pressure + (across.pressure - in_y.pressure);
  sample.peak_position = along.position;
  // Just before the first strip of a joined two-dimensional film is the end of the width.
  sample.peak_position_y = across.position < 0 ? across.position + around.length : across.position;
}

Sample PadFilm2d::sample(const film::FilmInputs& inputs, const film::FilmState& previous, const film::FilmState& state,
                         double time) const {
  const film::Film2dIntegrals sums = film::film2d_integrals(problem_, inputs_of(inputs), previous, state);
  const double width = problem_.around.length, density = setup().density;
  Sample out = sample_of(setup(), sums.mean, state.h_m, time);
  add_peak(state, out);
  const double largest_flow = largest_flux(inputs, state, sums);
  out.mass_residual = largest_flow > 0 ? std::abs(sums.mean.mass_defect) / largest_flow : 0.0;
  const auto strip =
      state.deficit.begin() + static_cast<std::ptrdiff_t>(problem_.around.halfway()) * problem_.n_across();
  add_fronts(setup(), inputs, {strip, strip + problem_.n_across()}, sums.mean, out);
  add_journal_load(setup(), problem_.strip.grid, problem_.around.share, state.p, out);
  out.total_load = out.load * width;
  out.total_friction_moving = out.friction_moving * width;
  out.total_friction_fixed = out.friction_fixed * width;
  if (is_joined()) {
    constexpr double kNotReported = std::numeric_limits<double>::quiet_NaN();
    out.mass_flow_front = out.mass_flow_back = out.flow_front = out.flow_back = kNotReported;
    return out;
  }
  out.mass_flow_front = 0 - sums.flow_low;  // what leaves through y = 0 flows in -y; of closed sides +0
  out.mass_flow_back = sums.flow_high;
  out.flow_front = out.mass_flow_front / density;
  out.flow_back = out.mass_flow_back / density;
  return out;
}

std::vector<double> PadFilm2d::places_x() const { return places_with_steps(nodes(), grid_.steps_x, std::nullopt); }

std::vector<double> PadFilm2d::places_y() const {
  std::vector<double> places;
  for (const Row& row : rows()) places.push_back(row.y);
  return places;
}

std::vector<PadFilm2d::Row> PadFilm2d::rows() const {
  const film::CircumferentialGrid& around = problem_.around;
  const int n_cells = around.n_cells();
  std::vector<Row> rows;
  for (int j = 0; j < around.n_strips(); ++j) {
    if (contains(grid_.steps_y, j)) rows.push_back({j, j - 1, around.y[j]});
    rows.push_back({j, std::min(j, n_cells - 1), around.y[j]});
  }
  if (is_joined()) rows.push_back({0, n_cells - 1, around.length});
  return rows;
}

void PadFilm2d::append_row(const film::FilmState& state, const Row& row, Profile& to) const {
  const film::FilmGrid& grid = problem_.strip.grid;
  const auto thickness = [&](int i, int cell) {
    return state.h_m + setup().surface->height(grid_.piece_of_x[cell], grid_.piece_of_y[row.cell], grid.x[i], row.y);
  };
  for (int i = 0; i <= grid.n_cells(); ++i) {
    const std::size_t node = static_cast<std::size_t>(row.strip) * problem_.n_across() + i;
    const double film_content = film::film_content(problem_.strip.cavitation, state.deficit[node]);
    if (contains(grid_.steps_x, i)) {
      append_step(setup(), to, thickness(i, i - 1), thickness(i, i), state.p[node], film_content);
    } else {
      append_node(to, {thickness(i, std::min(i, grid.n_cells() - 1)), state.p[node], film_content});
    }
  }
}

Profile PadFilm2d::profile(const film::FilmState& state, double time) const {
  const int middle = problem_.around.halfway();
  Profile along;
  along.time = time;
  for (const Row& row : rows()) {
    if (row.strip != middle) continue;
    append_row(state, row, along);
    break;
  }
  return along;
}

std::optional<Profile> PadFilm2d::field(const film::FilmState& state, double time) const {
  Profile field;
  field.time = time;
  for (const Row& row : rows()) append_row(state, row, field);
  return field;
}

}  // namespace ringfilm::pad
