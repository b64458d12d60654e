#include "ringfilm/film/integrals/film_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/factors/average_shear.hpp"
#include "ringfilm/film/fronts.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

/// Contact by the fits of its law or by its cubics; nothing where it has neither.
std::optional<ContactSums> contact_of_kernels(const FilmProblem& problem, const FilmInputs& inputs,
                                              const FilmView& film) {
  if (problem.contact == nullptr) return std::nullopt;
  const double spread = problem.contact_spread == ContactSpread::kLocal ? 1 : 0;
  const double turning_gap = problem.contact->trusted_up_to();
  const auto fitted = problem.contact->fitted();
  if (fitted && inputs.oil->fit() != nullptr) {
    return problem.kernels->contact(film,
                                    {fitted->fit->P52.data(), fitted->fit->P2.data(), fitted->reach, 2 / fitted->reach,
                                     fitted->pressure_scale, fitted->area_scale, spread, turning_gap});
  }
  const models::ContactPieces* law = problem.contact->pieces();
  if (law == nullptr || !(film.h_m >= 0)) return std::nullopt;
  const auto pieces = static_cast<double>(law->pressure.size());
  return problem.kernels->tabulated_contact(
      film, {law->pressure.front().data(), law->area.front().data(), law->reach, pieces / law->reach,
             law->pressure_scale, law->area_scale, std::nextafter(pieces, 0.0), spread, turning_gap});
}

/// Where the flow is reported: through the first and the last face, and through the middle of the gap, which lies
/// between two faces or in one.
class FlowFaces {
 public:
  explicit FlowFaces(const FilmGrid& grid) {
    const double middle = 0.5 * grid.width;
    const auto place = [&](int i) { return grid.x[i] + 0.5 * grid.spacing[i]; };
    const int n = grid.n_cells();
    // The last face that is neither beyond the middle nor the last of all.
    const auto node = std::lower_bound(grid.x.begin(), grid.x.end(), middle) - grid.x.begin();
    int i = std::clamp(static_cast<int>(node), 0, n - 2);
    while (i > 0 && place(i) > middle) --i;
    face_ = {0, i, i + 1, n - 1};
    share_ = (middle - place(i)) / (place(i + 1) - place(i));
  }
  FluxRequest requested() { return {face_.data(), flux_.data(), static_cast<int>(face_.size())}; }
  double left() const { return flux_[0]; }
  double middle() const { return flux_[1] + share_ * (flux_[2] - flux_[1]); }
  double right() const { return flux_[3]; }

 private:
  std::array<int, 4> face_;
  std::array<double, 4> flux_;
  double share_;  ///< weight of the second face at the middle
};

void add_flow(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous, const FilmState& state,
              const FlowFaces& flow, FilmIntegrals& sums) {
  const int n = problem.grid.n_cells();
  const auto storage = [&](int i) {
    return problem.grid.share[i] / inputs.time_step * (state.mass_per_area[i] - previous.mass_per_area[i]);
  };
  // Next to an edge of gas the film lies on the wall: its flow is that of the first face, before the edge's half cell.
  const auto stored_at = [&](const EdgeState& edge, int i) { return edge.fluid == EdgeFluid::kGas ? 0 : storage(i); };
  sums.flow_left = flow.left() + stored_at(inputs.left, 0);
  sums.flow_right = flow.right() - stored_at(inputs.right, n);
  sums.flow_middle = flow.middle();
  if (inputs.left.fluid == EdgeFluid::kGas) sums.mass_defect -= storage(0);
  if (inputs.right.fluid == EdgeFluid::kGas) sums.mass_defect -= storage(n);
  sums.mass_defect += sums.flow_right - sums.flow_left;
}

void add_cavities(const FilmProblem& problem, const FilmInputs& inputs, const GasReach& reach, const FilmState& state,
                  FilmIntegrals& sums) {
  const FilmGrid& grid = problem.grid;
  const int n = grid.n_cells();
  const double* deficit = state.deficit.data();
  const auto next = [&](int i, bool cavity) { return problem.kernels->next_node(deficit, i, n, cavity); };
  const auto front = [&](int inside, int outside) {
    const double bound = reach.pressure_bound(outside);
    return front_position(grid, state.p.data(), bound, inside, outside, ends_level(problem, inputs, inside < outside));
  };
  const bool left_presses = inputs.left.pressure > inputs.right.pressure;
  const bool right_presses = inputs.right.pressure > inputs.left.pressure;
  // The narrowest stretch, or the nodes about a place: gas has to come past both of them.
  const int first_of_all = std::min(reach.begin(), reach.end()), last = std::max(reach.begin(), reach.end());
  sums.wetted_end = grid.width;
  for (int i = next(1, true); i < n; i = next(i, true)) {
    Cavity cavity;
    const int first = i;
    cavity.begin = front(i - 1, i);
    i = next(i, false);
    cavity.end = std::max(front(i, i - 1), cavity.begin);
    // Gas fills it from its edge up to the end of the narrowest stretch at most; what is beyond is a cavity of its own.
    // The gas of the higher pressure that has come to that stretch blows through it; where the stretch begins at the
    // edge itself, gas that fills the whole gap.
    if (first == 1 && inputs.left.fluid == EdgeFluid::kGas && reach.is_filled(1) && reach.gas_at(1) != &inputs.right) {
      const int through = reach.begin() == 0 ? n : left_presses ? reach.begin() : last;
      sums.is_broken_through = sums.is_broken_through || i >= through;
      sums.wetted_begin = i > reach.end() ? reach.end_place() : cavity.end;
      cavity.begin = sums.wetted_begin;
    }
    const bool from_right = reach.is_filled(n - 1) && reach.gas_at(n - 1) != &inputs.left;
    if (i == n && inputs.right.fluid == EdgeFluid::kGas && from_right) {
      const int through = reach.end() == n ? 0 : right_presses ? reach.end() : first_of_all;
      sums.is_broken_through = sums.is_broken_through || first <= through + 1;
      sums.wetted_end = first <= reach.begin() ? reach.begin_place() : cavity.begin;
      cavity.end = sums.wetted_end;
    }
    if (inputs.has_gas() && cavity.end <= cavity.begin) continue;
    sums.cavitated_fraction += (cavity.end - cavity.begin) / grid.width;
    sums.cavities.push_back(cavity);
  }
  const Throat throat = reach.throat();
  if (reach.is_place() && throat.first_face <= throat.last_face) {
    // Oil that fills the gap behind the place presses against the film there, and not gas.
    const MeetingPlace at = reach.meeting_place();
    const int before = inputs.U >= 0 ? at.before : at.after, behind = inputs.U >= 0 ? at.after : at.before;
    const bool is_gas_behind = behind == 0 || behind == n || is_cavity(state.deficit[behind]);
    sums.is_broken_through = sums.is_broken_through || (is_gas_behind && state.p[before] < throat.pressure);
  }
  if (sums.wetted_begin > sums.wetted_end) {  // both gases fill the narrowest stretch
    sums.wetted_begin = sums.wetted_end = 0.5 * (sums.wetted_begin + sums.wetted_end);
  }
}

/// The deficit where shear is counted by it; 1 where gas fills the gap: the thin film there lies on the liner. Where
/// both gases may be, so does what is less than half of the gap.
std::vector<double> shear_deficit(const GasReach& reach, const FilmState& state) {
  std::vector<double> sheared = state.deficit;
  for (std::size_t i = 0; i < sheared.size(); ++i) {
    const int node = static_cast<int>(i);
    if (!is_cavity(sheared[i]) || !reach.is_filled(node)) continue;
    sheared[i] = reach.gas_at(node) != nullptr ? 1 : std::min(2 * sheared[i], 1.0);
  }
  return sheared;
}

/// The vertex of the parabola through the highest node and its neighbours. @param highest of the nodes
double peak_pressure(const FilmGrid& grid, const std::vector<double>& p, double highest) {
  const auto i = static_cast<std::size_t>(std::find(p.begin(), p.end(), highest) - p.begin());
  if (i == 0 || i + 1 >= p.size()) return highest;
  for (const GapJump& jump : grid.jumps) {
    if (std::abs(jump.node - static_cast<int>(i)) <= 1) return highest;  // pressure has a kink there
  }
  const double left = grid.spacing[i - 1], right = grid.spacing[i];
  const double rise = (highest - p[i - 1]) / left, fall = (highest - p[i + 1]) / right;
  const double slope = (rise * right - fall * left) / (left + right), bend = (rise + fall) / (left + right);
  return bend > 0 ? highest + slope * slope / (4 * bend) : highest;
}

FilmSums sums_of_film(const FilmProblem& problem, const models::OilAtTemperature& oil, const FilmState& state,
                      const FilmView& film, const StepView& step, const FluxRequest& fluxes) {
  if (state.laws == LaneLaws::kFitted) return problem.kernels->sums(film, fitted_oil_view(oil), step, fluxes);
  NodalOil nodal;
  nodal.update(oil, state.p);
  return problem.kernels->sums_of_given_oil(film, {nodal.rho.data(), nodal.K.data()}, step, fluxes);
}

}  // namespace

void set_contact(const FilmProblem& problem, double h_m, FilmIntegrals& sums) {
  const FilmGrid& grid = problem.grid;
  const bool local = problem.contact_spread == ContactSpread::kLocal;
  const double turning_gap = problem.contact->trusted_up_to();
  sums.asperity_load = sums.asperity_area = sums.asperity_load_beyond_polynomial = 0;
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const double h = local ? h_m + grid.node_height[i] : h_m;
    const auto contact = problem.contact->contact(h);
    sums.asperity_load += grid.share[i] * contact.pressure;
    sums.asperity_area += grid.share[i] * contact.area_share;
    if (h > turning_gap) sums.asperity_load_beyond_polynomial += grid.share[i] * contact.pressure;
  }
}

FilmIntegrals film_integrals(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                             const FilmState& state) {
  FilmIntegrals sums;
  FilmView film = film_view(problem, inputs, state);
  const GasReach reach(problem.grid, inputs);
  std::vector<double> sheared;
  if (inputs.has_gas()) {
    sheared = shear_deficit(reach, state);
    film.shear_deficit = sheared.data();
  }
  FlowFaces flow(problem.grid);
  const FilmSums of_film =
      sums_of_film(problem, *inputs.oil, state, film, {inputs.U, 1 / inputs.time_step, previous.mass_per_area.data()},
                   flow.requested());
  sums.hydrodynamic_load = of_film.hydrodynamic_load + reach.load_beyond_place(state.p, state.deficit);
  sums.shear_couette = of_film.shear_couette;
  sums.shear_poiseuille = of_film.shear_poiseuille;
  if (state.factors) {
    const AverageShear shear = average_shear(problem, inputs, state, film.shear_deficit);
    sums.shear_couette = shear.mean;
    sums.shear_poiseuille = shear.half_difference;
  }
  sums.land_lift = land_load(problem, inputs, state.h_m);
  sums.hydrodynamic_load += sums.land_lift;
  sums.shear_couette += land_shear(problem, inputs, state.h_m);
  sums.peak_shear_rate = peak_shear_rate(problem, inputs, state, film.shear_deficit, of_film.peak_shear_squared);
  sums.heating = film_heating(problem, inputs, reach, film, state.laws, of_film.heating);
  sums.mass_defect = of_film.storage;
  sums.peak_pressure = peak_pressure(problem.grid, state.p, of_film.peak_pressure);
  if (const auto contact = contact_of_kernels(problem, inputs, film)) {
    sums.asperity_load = contact->load;
    sums.asperity_load_beyond_polynomial = contact->load_beyond;
    sums.asperity_area = contact->area;
  } else if (problem.contact != nullptr) {
    set_contact(problem, state.h_m, sums);
  }
  add_flow(problem, inputs, previous, state, flow, sums);
  add_cavities(problem, inputs, reach, state, sums);
  return sums;
}

}  // namespace ringfilm::film
