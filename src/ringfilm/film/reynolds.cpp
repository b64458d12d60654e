#include "ringfilm/film/reynolds.hpp"

#include "ringfilm/film/cavitation.hpp"

namespace ringfilm::film {

void NodalOil::update(const models::OilAtTemperature& oil, const std::vector<double>& p) {
  rho.resize(p.size());
  drho_dp.resize(p.size());
  eta.resize(p.size());
  deta_dp.resize(p.size());
  oil.properties(p, {rho, drho_dp, eta, deta_dp});
  K.resize(p.size());
  dK_dp.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double fluidity = 1 / eta[i];
    K[i] = rho[i] * fluidity;
    dK_dp[i] = (drho_dp[i] - K[i] * deta_dp[i]) * fluidity;
  }
}

double mass_flux(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state, int i) {
  const double h = state.h_m + problem.grid.face_height[i];
  const double upstream = state.deficit[inputs.U >= 0 ? i : i + 1];
  const double rho = 0.5 * (state.rho[i] + state.rho[i + 1]);
  const double K = 0.5 * (state.K[i] + state.K[i + 1]);
  return 0.5 * inputs.U * h * fill(problem.cavitation, upstream) * rho -
         h * h * h / (12 * problem.grid.spacing[i]) * K * (state.p[i + 1] - state.p[i]);
}

void cavity_multiplier(const FilmProblem& problem, const FilmState& state, const NodalOil& oil,
                       std::vector<double>& multiplier) {
  multiplier.resize(state.p.size());
  for (std::size_t i = 0; i < state.p.size(); ++i) {
    const double h = state.h_m + problem.grid.node_height[i];
    multiplier[i] = h * h * h / (6 * problem.grid.share[i]) * oil.rho[i] / oil.eta[i];
  }
}

void complete_state(const FilmProblem& problem, LaneLaws laws, FilmState& state) {
  const std::size_t n_nodes = state.p.size();
  for (auto* array : {&state.rho, &state.K, &state.content}) array->resize(n_nodes);
  if (laws == LaneLaws::kFitted) {
    const models::OilFit& fit = *problem.oil->fit();
    problem.kernels->complete(film_view(problem, state), {fit.K.data(), fit.rho.data(), fit.centre, 1 / fit.half_width},
                              {state.rho.data(), state.K.data(), state.content.data()});
    return;
  }
  std::vector<double> slope(n_nodes);
  problem.oil->properties(state.p, {state.rho, slope, state.K, slope});
  for (std::size_t i = 0; i < n_nodes; ++i) {
    state.K[i] = state.rho[i] / state.K[i];  // until here the viscosity
    state.content[i] =
        state.rho[i] * fill(problem.cavitation, state.deficit[i]) * (state.h_m + problem.grid.node_height[i]);
  }
}

FilmView film_view(const FilmProblem& problem, const FilmState& state) {
  const FilmGrid& grid = problem.grid;
  return {grid.n_cells(),
          grid.node_height.data(),
          grid.face_height.data(),
          grid.share.data(),
          grid.spacing.data(),
          state.p.data(),
          state.deficit.data(),
          state.rho.data(),
          state.K.data(),
          state.content.data(),
          state.h_m,
          problem.cavitation == Cavitation::kMassConserving ? 1.0 : 0.0};
}

}  // namespace ringfilm::film
