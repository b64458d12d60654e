#include "ringfilm/film/film_heating.hpp"

#include <cmath>
#include <span>
#include <vector>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/fronts.hpp"
#include "ringfilm/models/oil/oil_fit.hpp"

namespace ringfilm::film {
namespace {

/// Of the oil at the nodes of a strip.
struct StripOil {
  std::vector<double> rho, eta;  ///< [kg/m3], [Pa s]
};

StripOil oil_at(const models::OilAtTemperature& oil, LaneLaws laws, std::span<const double> p) {
  StripOil at{std::vector<double>(p.size()), std::vector<double>(p.size())};
  if (laws == LaneLaws::kFitted) {
    const models::OilFit& fit = *oil.fit();
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double t = (p[i] - fit.centre) * (1 / fit.half_width);
      at.rho[i] = models::polynomial(fit.rho, t);
      at.eta[i] = at.rho[i] / models::polynomial(fit.K, t);
    }
    return at;
  }
  std::vector<double> drho_dp(p.size()), deta_dp(p.size());
  oil.properties(p, {at.rho, drho_dp, at.eta, deta_dp});
  return at;
}

/// Of the cell behind node `i`, in which the film ends or begins [m].
double filled_length(const FilmGrid& grid, const FilmInputs& inputs, const double* p, int i, bool ends) {
  const int inside = ends ? i : i + 1, outside = ends ? i + 1 : i;
  const double front = front_position(grid, p, inputs.pressure_bound(grid, outside), inside, outside);
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
  const FilmGrid& grid = problem.grid;
  const std::size_t n_nodes = grid.x.size(), first = strip * n_nodes;
  const std::span<const double> p(state.p.data() + first, n_nodes), deficit(state.deficit.data() + first, n_nodes);
  const StripOil oil = oil_at(*inputs.oil, state.laws, p);
  FilmHeating sums;
  double length = 0, flow = 0;
  for (std::size_t i = 0; i + 1 < n_nodes; ++i) {
    const bool ends = is_cavity(deficit[i + 1]), begins = is_cavity(deficit[i]);
    if (ends && begins) continue;
    const double cell =
        ends || begins ? filled_length(grid, inputs, p.data(), static_cast<int>(i), ends) : grid.spacing[i];
    const double h = state.h_m + rise + grid.face_height[i];
    const double slope = ends || begins ? 0 : (p[i + 1] - p[i]) / cell;
    const double eta = 0.5 * (oil.eta[i] + oil.eta[i + 1]), rho = 0.5 * (oil.rho[i] + oil.rho[i + 1]);
    const double pressure_flow = h * h * h * slope / (12 * eta);
    sums.dissipation += cell * (eta * inputs.U * inputs.U / h + pressure_flow * slope);
    sums.conductance += cell / h;
    flow += cell * rho * (0.5 * inputs.U * h - pressure_flow);
    length += cell;
  }
  if (length > 0) sums.mass_flow = std::abs(flow) / length;
  return sums;
}

}  // namespace ringfilm::film
