#include "ringfilm/film/film_integrals.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

/// From this film parameter on, the F5/2 polynomial as printed rises again (docs/theory/paper-errata.md).
constexpr double kPolynomialTurns = 1.911;

void add_load(const FilmProblem& problem, const FilmState& state, FilmIntegrals& sums) {
  const FilmGrid& grid = problem.grid;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    sums.hydrodynamic_load += grid.share[i] * state.p[i];
    if (problem.contact == nullptr) continue;
    const double h = problem.contact_spread == ContactSpread::kNominal ? state.h_m : state.h_m + grid.node_height[i];
    const auto contact = problem.contact->contact(h);
    sums.asperity_load += grid.share[i] * contact.pressure;
    sums.asperity_area += grid.share[i] * contact.area_share;
    if (h > kPolynomialTurns * problem.contact->parameters().sigma) {
      sums.asperity_load_beyond_polynomial += grid.share[i] * contact.pressure;
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
    sums.shear_couette += grid.spacing[i] * theta * eta * inputs.U / h;
    sums.shear_poiseuille += 0.5 * h * (state.p[i + 1] - state.p[i]);
  }
}

/// Mass flux through the middle of the gap: of the face that lies there, or between two faces.
double middle_flux(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state) {
  const FilmGrid& grid = problem.grid;
  const double middle = 0.5 * grid.width;
  int i = 0;  // the last face not beyond the middle
  while (i + 2 < grid.n_cells() && grid.x[i + 1] + 0.5 * grid.spacing[i + 1] <= middle) ++i;
  const double left = grid.x[i] + 0.5 * grid.spacing[i];
  const double right = grid.x[i + 1] + 0.5 * grid.spacing[i + 1];
  const double share = (middle - left) / (right - left);
  const double flux = mass_flux(problem, inputs, state, i);
  return flux + share * (mass_flux(problem, inputs, state, i + 1) - flux);
}

void add_flow(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, const FilmState& state,
              FilmIntegrals& sums) {
  const int n = problem.grid.n_cells();
  const auto storage = [&](int i) {
    return problem.grid.share[i] / inputs.time_step * (state.content[i] - previous.content[i]);
  };
  sums.flow_left = mass_flux(problem, inputs, state, 0) + storage(0);
  sums.flow_right = mass_flux(problem, inputs, state, n - 1) - storage(n);
  sums.flow_middle = middle_flux(problem, inputs, state);
  sums.mass_defect = sums.flow_right - sums.flow_left;
  for (int i = 0; i <= n; ++i) sums.mass_defect += storage(i);
}

enum class Front { kRupture, kReformation };

/// Where the film that ends at node `i` ends, by its pressure there and at the node before (`inner`); `outer` is the
/// first node of the cavity (docs/theory/film.md, "fronts between nodes").
double front_position(const FilmProblem& problem, const FilmState& state, double p_c, int i, int outer, Front front) {
  const FilmGrid& grid = problem.grid;
  const int inner = 2 * i - outer;
  const double near = state.p[i] - p_c;
  const double cell = grid.x[outer] - grid.x[i];  // negative where the film lies on the right
  if (inner < 0 || inner > grid.n_cells()) return grid.x[i] + (near > 0 ? 0.5 * cell : 0.0);  // node i is an edge
  const double far = state.p[inner] - p_c;
  const double ratio = far > 0 ? near / far : 1.0;  // a film of a single node has no slope
  if (front == Front::kReformation) {
    // The pressure rises from the front in a straight line.
    const double cells = ratio < 1 ? std::abs((grid.x[i] - grid.x[inner]) / cell) * ratio / (1 - ratio) : 1.0;
    return grid.x[i] + std::min(cells, 1.0) * cell;
  }
  // It comes down to the front in a parabola, of which the balance of mass holds at nodes i and inner.
  const auto is_outer = [outer](const GapJump& jump) { return jump.node == outer; };
  const bool at_jump = std::any_of(grid.jumps.begin(), grid.jumps.end(), is_outer);
  const double cells = 0.5 + (ratio < 1.0 / 3.0 ? ratio / (1 - 2 * ratio) : 1.0);
  return grid.x[i] + (at_jump ? std::min(cells, 1.0) : cells) * cell;
}

void add_cavities(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state, FilmIntegrals& sums) {
  const FilmGrid& grid = problem.grid;
  const int n = grid.n_cells();
  const Front at_left = inputs.U >= 0 ? Front::kRupture : Front::kReformation;
  const Front at_right = inputs.U >= 0 ? Front::kReformation : Front::kRupture;
  sums.peak_pressure = *std::max_element(state.p.begin(), state.p.end());
  for (int i = 1; i < n; ++i) {
    if (state.deficit[i] == 0) continue;
    if (state.deficit[i - 1] == 0) {
      sums.cavities.push_back({front_position(problem, state, inputs.p_cavitation, i - 1, i, at_left), 0});
    }
    if (state.deficit[i + 1] == 0) {
      const double end = front_position(problem, state, inputs.p_cavitation, i + 1, i, at_right);
      Cavity& cavity = sums.cavities.back();
      cavity.end = std::max(end, cavity.begin);
      sums.cavitated_fraction += (cavity.end - cavity.begin) / grid.width;
    }
  }
}

}  // namespace

FilmIntegrals film_integrals(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                             const FilmState& state) {
  FilmIntegrals sums;
  add_load(problem, state, sums);
  add_shear(problem, inputs, state, sums);
  add_flow(problem, inputs, previous, state, sums);
  add_cavities(problem, inputs, state, sums);
  return sums;
}

}  // namespace ringfilm::film
