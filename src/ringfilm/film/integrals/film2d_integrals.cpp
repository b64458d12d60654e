#include "ringfilm/film/integrals/film2d_integrals.hpp"

#include <algorithm>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

/// A strip of the two-dimensional film as a film of its own.
class Strips {
 public:
  Strips(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous, const FilmState& state)
      : problem_(problem),
        inputs_(inputs),
        previous_(previous),
        state_(state),
        rise_(rise_of_strips(problem, inputs, state.ring)),
        closed_(closed_film(problem)),
        strip_(problem.strip) {}

  FilmIntegrals integrals(int j) {
    const int n_across = problem_.n_across();
    const auto row = [&](const std::vector<double>& from) { return row_of_strip(from, j, n_across); };
    strip_.grid.node_height = row(problem_.gap.node);
    strip_.grid.face_height = row_of_strip(problem_.gap.face_x, j, n_across - 1);
    now_.h_m = state_.h_m + (rise_.empty() ? 0.0 : rise_[j]);
    now_.laws = state_.laws;
    now_.p = row(state_.p);
    now_.deficit = row(state_.deficit);
    now_.mass_per_area = row(state_.mass_per_area);
    before_.mass_per_area = row(previous_.mass_per_area);
    if (state_.factors) {
      now_.factors =
          std::make_shared<const FlowFactors>(factors_of_strip(*state_.factors, j, problem_.around.n_strips()));
    }
    FilmIntegrals sums = film_integrals(strip_, inputs_.strip, before_, now_);
    if (!problem_.gap.face_x_second.empty()) add_steps(j, sums);
    if (now_.h_m < 2 * closed_) set_contact(strip_, closed_separation(now_.h_m, closed_), sums);
    return sums;
  }
  double lowest() const {
    return now_.h_m + *std::min_element(strip_.grid.node_height.begin(), strip_.grid.node_height.end());
  }

  /// Mass flow in +y through the cell between strips, where the balance of mass counts it [kg/s].
  double cross_flow(int cell) const {
    const CircumferentialGrid& around = problem_.around;
    const int n_across = problem_.n_across();
    const int high = (cell + 1) % around.n_strips();
    const auto low_row = static_cast<std::size_t>(cell) * n_across,
               high_row = static_cast<std::size_t>(high) * n_across;
    const double h_m = state_.h_m + (rise_.empty() ? 0.0 : 0.5 * (rise_[cell] + rise_[high]));
    double flow = 0;
    for (int i = 1; i + 1 < n_across; ++i) {
      const double h = h_m + problem_.gap.face_y[low_row + i];
      double cube = h * h * h;
      if (!problem_.gap.face_y_second.empty()) {
        cube += 3 * h * problem_.gap.face_y_second[low_row + i] + problem_.gap.face_y_third[low_row + i];
      }
      const double K = mobility_across(low_row + i) * fluidity(state_.p[low_row + i]) +
                       mobility_across(high_row + i) * fluidity(state_.p[high_row + i]);
      flow += problem_.strip.grid.share[i] *
              pressure_flux(conductance(cube, around.spacing[cell]), K, state_.p[high_row + i] - state_.p[low_row + i]);
    }
    return flow;
  }

 private:
  double mobility_across(std::size_t node) const {
    return state_.factors && !state_.factors->mobility_across.empty() ? state_.factors->mobility_across[node] : 1;
  }
  double fluidity(double p) const {
    const models::OilAtTemperature& oil = *inputs_.strip.oil;
    return state_.laws == LaneLaws::kFitted ? oil.fit()->at(p).K : oil.density(p) / oil.viscosity(p);
  }
  double viscosity(double p) const {
    const models::OilAtTemperature& oil = *inputs_.strip.oil;
    return state_.laws == LaneLaws::kFitted ? oil.fit()->at(p).rho / oil.fit()->at(p).K : oil.viscosity(p);
  }

  /// What strips on a step of the gap let through and shear beyond those of one mean height. A face there has two
  /// heights, which follow from its moments: with q = mu_3/mu_2 the mean of 1/h is (h + q)/(h^2 + h q - mu_2)
  /// (eq-pad-step-shear).
  void add_steps(int j, FilmIntegrals& sums) const {
    const FilmGrid& grid = problem_.strip.grid;
    const int n = grid.n_cells();
    const double* second = problem_.gap.face_x_second.data() + static_cast<std::size_t>(j) * n;
    const double* third = problem_.gap.face_x_third.data() + static_cast<std::size_t>(j) * n;
    const auto height = [&](int i) { return now_.h_m + strip_.grid.face_height[i]; };
    const auto flow = [&](int i) {
      return pressure_flux(conductance(3 * height(i) * second[i] + third[i], grid.spacing[i]),
                           fluidity(now_.p[i]) + fluidity(now_.p[i + 1]), now_.p[i + 1] - now_.p[i]);
    };
    const int upstream = inputs_.strip.U >= 0 ? 0 : 1;  // index of the upstream one of the two nodes of a face
    const auto film_content = [&](int i) { return film::film_content(strip_.cavitation, now_.deficit[i + upstream]); };
    for (int i = 0; i < n; ++i) {
      if (!(second[i] > 0)) continue;
      const double h = height(i), q = third[i] / second[i];
      const double beyond = (h + q) / (h * h + h * q - second[i]) - 1 / h;
      sums.shear_couette += 0.5 * inputs_.strip.U * grid.spacing[i] * film_content(i) *
                            (viscosity(now_.p[i]) + viscosity(now_.p[i + 1])) * beyond;
    }
    const auto middle = std::upper_bound(grid.x.begin(), grid.x.end() - 1, 0.5 * grid.width) - grid.x.begin();
    sums.flow_left += flow(0);
    sums.flow_middle += flow(static_cast<int>(middle) - 1);
    sums.flow_right += flow(n - 1);
    sums.mass_defect += flow(n - 1) - flow(0);
  }

  const Film2dProblem& problem_;
  const Film2dInputs& inputs_;
  const FilmState &previous_, &state_;
  const std::vector<double> rise_;
  const double closed_;
  FilmProblem strip_;
  FilmState now_, before_;
};

}  // namespace

Film2dIntegrals film2d_integrals(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& previous,
                                 const FilmState& state) {
  const CircumferentialGrid& around = problem.around;
  const int n_strips = around.n_strips(), halfway = around.halfway();
  Film2dIntegrals sums;
  Strips strips(problem, inputs, previous, state);
  for (int j = 0; j < n_strips; ++j) {
    const FilmIntegrals of = strips.integrals(j);
    sums.strips.push_back({of.hydrodynamic_load, of.asperity_load, of.asperity_area, of.shear_couette,
                           of.shear_poiseuille, of.flow_left, of.flow_middle, of.flow_right, of.peak_pressure,
                           of.cavitated_fraction, strips.lowest()});
    const double share = around.share[j] / around.length;
    FilmIntegrals& mean = sums.mean;
    for (double FilmIntegrals::*sum :
         {&FilmIntegrals::hydrodynamic_load, &FilmIntegrals::land_lift, &FilmIntegrals::asperity_load,
          &FilmIntegrals::asperity_load_beyond_polynomial, &FilmIntegrals::asperity_area, &FilmIntegrals::shear_couette,
          &FilmIntegrals::shear_poiseuille, &FilmIntegrals::flow_left, &FilmIntegrals::flow_middle,
          &FilmIntegrals::flow_right, &FilmIntegrals::cavitated_fraction}) {
      mean.*sum += share * (of.*sum);
    }
    mean.peak_pressure = j == 0 ? of.peak_pressure : std::max(mean.peak_pressure, of.peak_pressure);
    mean.peak_shear_rate = std::max(mean.peak_shear_rate, of.peak_shear_rate);
    if (j == halfway) {
      mean.cavities = of.cavities;
      mean.heating = of.heating;
    }
    mean.wetted_end = of.wetted_end;  // no gas at the edges of a film in two dimensions
    // What a strip misses, its neighbours have, or it left through an end.
    const bool is_end = around.ends == Ends::kOpen && (j == 0 || j == n_strips - 1);
    if (!is_end) mean.mass_defect += share * of.mass_defect;
    if (is_end) (j == 0 ? sums.flow_low : sums.flow_high) -= around.share[j] * of.mass_defect;
  }
  if (around.ends == Ends::kOpen) {
    const double low = strips.cross_flow(0), high = strips.cross_flow(around.n_cells() - 1);
    sums.flow_low -= low;
    sums.flow_high += high;
    sums.mean.mass_defect += (high - low) / around.length;
  }
  return sums;
}

}  // namespace ringfilm::film
