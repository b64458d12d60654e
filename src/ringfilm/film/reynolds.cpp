#include "ringfilm/film/reynolds.hpp"

#include <algorithm>

#include "ringfilm/film/cavitation.hpp"
#include "ringfilm/film/gas_reach.hpp"
#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {

void NodalOil::update(const models::OilAtTemperature& oil, std::span<const double> p) {
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

bool runs_away(const models::OilAtTemperature& oil, double p_low, double p_high) {
  constexpr double kRatio =
      1e60;  // ratio of viscosities: 44 decades beyond the resolution of a node's balance in double precision
  return !(oil.viscosity(p_high) < kRatio * oil.viscosity(p_low));
}

namespace {

double viscosity_ratio(const models::OilAtTemperature& oil, double p_low, double p_high) {
  return oil.viscosity(p_high) / oil.viscosity(p_low);
}

/// Oils are a glass at 1e12 Pa s, some 1e14 times their usual viscosity. Films at the limit of Barus' law show 1e28 and
/// more, others below 1e3.
constexpr double kGlass = 1e10;

/// With Barus' law (1 - e^(-alpha p))/alpha is then within 1 in 1000 of the most that it can be.
constexpr double kNearLimit = 1e3;

}  // namespace

bool is_glass(const models::OilAtTemperature& oil, double p_low, double p_high) {
  return viscosity_ratio(oil, p_low, p_high) > kGlass;
}

bool accept(const models::OilAtTemperature& oil, double p_cavitation, const FilmState& solved, FilmReport& report) {
  const double peak = *std::max_element(solved.p.begin(), solved.p.end());
  report.converged = solved.laws == LaneLaws::kFitted || !is_glass(oil, p_cavitation, peak);
  report.failure = report.converged ? Failure::kNone : Failure::kRunsAway;
  if (!report.converged) report.thinnest_film = solved.h_m;
  return report.converged;
}

void explain_failure(const models::OilAtTemperature& oil, double p_cavitation, const FilmState& found,
                     Patience patience, FilmReport& report) {
  if (report.failure == Failure::kOverloaded || report.failure == Failure::kLiftedOff) return;
  if (found.h_m < kAtom) {
    report.failure = Failure::kOverloaded;
    return;
  }
  const double ratio = viscosity_ratio(oil, p_cavitation, *std::max_element(found.p.begin(), found.p.end()));
  const bool is_cause = ratio > (patience == Patience::kLittle ? kGlass : kNearLimit);
  report.failure = is_cause ? Failure::kRunsAway : Failure::kNotConverged;
  report.thinnest_film = found.h_m;
}

namespace {

struct OilHere {
  double rho, K;
};

OilHere oil_at(const models::OilAtTemperature& oil, const FilmState& state, int i) {
  const double p = state.p[i];
  if (state.laws == LaneLaws::kFitted) {
    const auto fitted = oil.fit()->at(p);
    return {fitted.rho, fitted.K};
  }
  const double rho = oil.density(p);
  return {rho, rho / oil.viscosity(p)};
}

}  // namespace

double viscosity_at(const models::OilAtTemperature& oil, LaneLaws laws, double p) {
  if (laws != LaneLaws::kFitted) return oil.viscosity(p);
  const auto fitted = oil.fit()->at(p);
  return fitted.rho / fitted.K;
}

double density_at(const models::OilAtTemperature& oil, LaneLaws laws, double p) {
  return laws == LaneLaws::kFitted ? oil.fit()->at(p).rho : oil.density(p);
}

double mass_flux(const FilmView& view, const FilmInputs& inputs, const FilmState& state, int i) {
  const OilHere left = oil_at(*inputs.oil, state, i), right = oil_at(*inputs.oil, state, i + 1);
  const double rho[] = {left.rho, right.rho}, K[] = {left.K, right.K};
  return flux_through(view, inputs.U, rho, K, i);
}

void cavity_multiplier(const FilmProblem& problem, const FilmState& state, const NodalOil& oil,
                       std::vector<double>& multiplier) {
  const FilmGrid& grid = problem.grid;
  multiplier.assign(state.p.size(), 0.0);
  for (int i = 1; i < grid.n_cells(); ++i) {
    const double conductances = conductance(1, grid.spacing[i - 1]) + conductance(1, grid.spacing[i]);
    multiplier[i] = multiplier_weight(conductances, state.h_m + grid.node_height[i], oil.K[i]);
  }
}

void complete_state(const FilmProblem& problem, const FilmInputs& inputs, LaneLaws laws, FilmState& state) {
  const std::size_t n_nodes = state.p.size();
  const std::vector<double>& rise = problem.grid.node_height;
  state.mass_per_area.resize(n_nodes);
  state.laws = laws;
  state.factors = inputs.factors;
  if (laws == LaneLaws::kFitted) {
    problem.kernels->mass_per_area(film_view(problem, inputs, state), fitted_oil_view(*inputs.oil),
                                   state.mass_per_area.data());
  } else {
    for (std::size_t i = 0; i < n_nodes; ++i) {
      state.mass_per_area[i] =
          inputs.oil->density(state.p[i]) * film_content(problem.cavitation, state.deficit[i]) * (state.h_m + rise[i]);
    }
  }
  if (!state.factors || state.factors->stored.empty()) return;
  for (std::size_t i = 0; i < n_nodes; ++i) {
    state.mass_per_area[i] *= 1 + state.factors->stored[i] / (state.h_m + rise[i]);
  }
}

FilmView film_view(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state) {
  const FilmGrid& grid = problem.grid;
  const GasReach reach(grid, inputs);
  const Throat throat = reach.throat();
  const auto is_on_wall = [&](int node) { return reach.carry(node) == kOnWall; };
  const FlowFactors* factors = state.factors.get();
  const auto given = [factors](std::vector<double> FlowFactors::*list) {
    return factors == nullptr || (factors->*list).empty() ? nullptr : (factors->*list).data();
  };
  return {grid.n_cells(),
          grid.node_height.data(),
          grid.face_height.data(),
          grid.share.data(),
          grid.spacing.data(),
          state.p.data(),
          state.deficit.data(),
          state.mass_per_area.data(),
          state.deficit.data(),
          state.h_m,
          problem.cavitation == Cavitation::kMassConserving ? 1.0 : 0.0,
          is_on_wall(0) ? std::max(reach.begin(), 1) : 0,
          is_on_wall(grid.n_cells()) ? std::min(reach.end() + 1, grid.n_cells()) : grid.n_cells() + 1,
          std::min(4 * inputs.left_supply(), kUnlimited),
          std::min(4 * inputs.right_supply(), kUnlimited),
          inputs.is_steady(),
          throat.first_face,
          throat.last_face,
          throat.pressure,
          throat.reach,
          throat.place,
          reach.outlet(),
          given(&FlowFactors::mobility),
          given(&FlowFactors::carried),
          given(&FlowFactors::thinning),
          given(&FlowFactors::sliding_stress),
          given(&FlowFactors::inverse_gap)};
}

FittedOilView fitted_oil_view(const models::OilAtTemperature& oil) {
  const models::OilFit& fit = *oil.fit();
  return {fit.K.data(), fit.rho.data(), fit.centre, 1 / fit.half_width};
}

}  // namespace ringfilm::film
