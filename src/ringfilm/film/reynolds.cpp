#include "ringfilm/film/reynolds.hpp"

#include "ringfilm/film/cavitation.hpp"

namespace ringfilm::film {
namespace {

/// Flux through one face and its derivatives in (p, theta) of both sides and in h_m.
struct FaceFlux {
  double value;
  double dp_left, dp_right;
  double dtheta_left, dtheta_right;
  double dh;
};

struct NodeView {
  double p, theta, rho, drho, K, dK;
};

NodeView node_view(const FilmProblem& problem, const FilmState& state, const NodalOil& oil, int i) {
  return {state.p[i], fill(problem.cavitation, state.deficit[i]), oil.rho[i], oil.drho_dp[i], oil.K[i], oil.dK_dp[i]};
}

FaceFlux face_flux(double U, double h, double dx, const NodeView& left, const NodeView& right) {
  const bool upstream_is_left = U >= 0;
  const double theta = upstream_is_left ? left.theta : right.theta;
  const double rho = 0.5 * (left.rho + right.rho);
  const double conductance = h * h * h / (12 * dx);
  const double K = 0.5 * (left.K + right.K);
  const double dp = right.p - left.p;
  const double couette = 0.5 * U * h * theta;

  FaceFlux flux;
  flux.value = couette * rho - conductance * K * dp;
  flux.dp_left = 0.5 * couette * left.drho + conductance * (K - 0.5 * left.dK * dp);
  flux.dp_right = 0.5 * couette * right.drho - conductance * (K + 0.5 * right.dK * dp);
  flux.dtheta_left = upstream_is_left ? 0.5 * U * h * rho : 0.0;
  flux.dtheta_right = upstream_is_left ? 0.0 : 0.5 * U * h * rho;
  flux.dh = 0.5 * U * theta * rho - 3 * conductance / h * K * dp;
  return flux;
}

}  // namespace

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
  const auto view = [&](int node) -> NodeView {
    return {state.p[node],
            fill(problem.cavitation, state.deficit[node]),
            state.rho[node],
            0,
            state.rho[node] / state.eta[node],
            0};
  };
  return face_flux(inputs.U, state.h_m + problem.grid.face_height[i], problem.grid.spacing[i], view(i), view(i + 1))
      .value;
}

void assemble_balance(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& previous,
                      const FilmState& state, const NodalOil& oil, double scale, const std::vector<double>& multiplier,
                      base::BorderedTridiagonal& system) {
  const FilmGrid& grid = problem.grid;
  // Where nothing moves and nothing changes, no equation holds the fill: a node that the iteration put below p_c is
  // held there by the multiplier, as in Reynolds' exit, until its pressure comes back.
  const bool at_rest = inputs.U == 0 && inputs.time_step == kSteady;
  const bool conserving = problem.cavitation == Cavitation::kMassConserving && !at_rest;
  const int n = grid.n_cells();

  NodeView left = node_view(problem, state, oil, 0);
  NodeView here = node_view(problem, state, oil, 1);
  FaceFlux in = face_flux(inputs.U, state.h_m + grid.face_height[0], grid.spacing[0], left, here);
  for (int i = 1; i < n; ++i) {
    const NodeView right = node_view(problem, state, oil, i + 1);
    const FaceFlux out = face_flux(inputs.U, state.h_m + grid.face_height[i], grid.spacing[i], here, right);
    const double h = state.h_m + grid.node_height[i];
    const double volume_rate = grid.share[i] / inputs.time_step;  // 0 when steady
    double residual = volume_rate * (here.rho * here.theta * h - previous.content[i]) + out.value - in.value;
    if (!inputs.source.empty()) residual -= grid.share[i] * inputs.source[i];

    // d/dz of a node is d/dp in the film and d/dtheta (or the multiplier) in the cavity.
    const auto slope = [&](int node, double dp, double dtheta) {
      if (state.deficit[node] == 0) return dp;
      return conserving ? dtheta / scale : 0.0;
    };
    double diagonal = slope(i, volume_rate * here.drho * here.theta * h + out.dp_left - in.dp_right,
                            volume_rate * here.rho * h + out.dtheta_left - in.dtheta_right);
    if (!conserving && state.deficit[i] > 0) {
      residual -= multiplier[i] * state.deficit[i] * scale;
      diagonal = multiplier[i];
    }
    const int row = i - 1;
    system.lower[row] = slope(i - 1, -in.dp_left, -in.dtheta_left);
    system.diagonal[row] = diagonal;
    system.upper[row] = slope(i + 1, out.dp_right, out.dtheta_right);
    system.column[row] = (volume_rate * here.rho * here.theta + out.dh - in.dh) * state.h_m;
    system.rhs[row] = -residual;
    left = here;
    here = right;
    in = out;
  }
  system.lower[0] = 0;  // the edges are given
  system.upper[n - 2] = 0;
}

void cavity_multiplier(const FilmProblem& problem, const FilmState& state, const NodalOil& oil,
                       std::vector<double>& multiplier) {
  multiplier.resize(state.p.size());
  for (std::size_t i = 0; i < state.p.size(); ++i) {
    const double h = state.h_m + problem.grid.node_height[i];
    multiplier[i] = h * h * h / (6 * problem.grid.share[i]) * oil.rho[i] / oil.eta[i];
  }
}

void complete_state(const FilmProblem& problem, const NodalOil& oil, FilmState& state) {
  state.rho = oil.rho;
  state.eta = oil.eta;
  state.content.resize(state.p.size());
  for (std::size_t i = 0; i < state.p.size(); ++i) {
    state.content[i] =
        oil.rho[i] * fill(problem.cavitation, state.deficit[i]) * (state.h_m + problem.grid.node_height[i]);
  }
}

}  // namespace ringfilm::film
