#include "ringfilm/film/factors/factor_laws.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/factors/average_shear.hpp"
#include "ringfilm/film/reynolds.hpp"

namespace ringfilm::film {
namespace {

void add_thinning(const ThinningOil& oil, const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state,
                  double h_m, FlowFactors& factors) {
  const double eta_T = viscosity_at(*inputs.oil, state.laws, oil.reference_pressure);
  const double per_rate = eta_T / oil.critical_stress;  // 1/g_c at this temperature
  factors.thinning.reserve(state.p.size());
  for (int i = 0; i <= problem.grid.n_cells(); ++i) {
    const double h = h_m + problem.grid.node_height[i];
    const double eta = viscosity_at(*inputs.oil, state.laws, state.p[i]);
    const double stress = pressure_shear(h, pressure_slope(problem, state, i));
    factors.thinning.push_back(oil.law.ratio(std::abs(inputs.U) / h * per_rate, stress / eta * per_rate));
  }
}

/// From heights along the grid.
template <class Factor>
std::vector<double> along(const std::vector<double>& heights, double h_m, const Factor& factor) {
  std::vector<double> values;
  values.reserve(heights.size());
  for (const double height : heights) values.push_back(factor(h_m + height));
  return values;
}

void add_stress(const FactorLaws& laws, const FilmGrid& grid, double h_m, FlowFactors& factors) {
  const auto at_faces = [&](const auto& factor) {
    return along(grid.face_height, h_m, [&](double h) { return factor(h / laws.sigma); });
  };
  factors.sliding_stress = at_faces(models::mean_inverse_film);
  factors.pressure_stress = at_faces([&](double H) { return laws.stress->pressure_stress(H); });
  if (laws.share_difference == 0) return;
  factors.stress_difference = at_faces([&](double H) { return laws.share_difference * laws.stress->shear_stress(H); });
}

/// Adds the stress factors of the gap of a measured pair, whose stress by sliding depends on the oil.
void add_measured_stress(const FactorLaws& laws, const FilmProblem& problem, const FilmInputs& inputs,
                         const FilmState& state, double h_m, FlowFactors& factors) {
  const models::MeasuredFlow& law = *laws.measured.stress;
  const auto& heights = problem.grid.face_height;
  factors.pressure_stress = along(heights, h_m, [&](double h) { return law.pressure_stress(h); });
  factors.inverse_gap = along(heights, h_m, [&](double h) { return law.mean_inverse_gap(h); });
  const auto eta = [&](int i) {
    const double newtonian = viscosity_at(*inputs.oil, state.laws, state.p[i]);
    return factors.thinning.empty() ? newtonian : factors.thinning[i] * newtonian;
  };
  for (int i = 0; i < problem.grid.n_cells(); ++i) {
    const double length = 0.5 * (eta(i) + eta(i + 1)) * inputs.U / laws.measured.eyring_stress;
    factors.sliding_stress.push_back(law.sliding_stress(h_m + heights[i], length));
  }
}

/// phi_x at the nodes; empty: 1.
std::vector<double> pressure_flow(const FactorLaws& laws, const FilmGrid& grid, double h_m) {
  if (laws.measured.pressure_flow) {
    return along(grid.node_height, h_m, [&](double h) { return laws.measured.pressure_flow->pressure_flow(h); });
  }
  if (!laws.pressure_flow) return {};
  return along(grid.node_height, h_m, [&](double h) { return laws.pressure_flow->pressure_flow(h / laws.sigma); });
}

/// phi_y at the nodes; empty: 1.
std::vector<double> cross_flow(const FactorLaws& laws, const FilmGrid& grid, double h_m) {
  if (const auto& measured = laws.measured.pressure_flow) {
    return along(grid.node_height, h_m, [&](double h) { return measured->pressure_flow_across(h); });
  }
  if (!laws.cross_flow) return {};
  return along(grid.node_height, h_m, [&](double h) { return laws.cross_flow->pressure_flow(h / laws.sigma); });
}

/// By how much the mean gap exceeds the film thickness; empty: nowhere [m].
std::vector<double> gap_excess(const FactorLaws& laws, const std::vector<double>& heights, double h_m) {
  if (const auto& measured = laws.measured.average_gap) {
    return along(heights, h_m, [&](double h) { return measured->mean_gap(h) - h; });
  }
  if (laws.average_gap != AverageGap::kTruncated) return {};
  return along(heights, h_m, [&](double h) { return laws.sigma * models::average_gap_excess(h / laws.sigma); });
}

/// What roughness adds to the film that the moving wall carries; empty: nothing [m].
std::vector<double> shear_flow(const FactorLaws& laws, const std::vector<double>& heights, double h_m) {
  if (const auto& measured = laws.measured.shear_flow) {
    return along(heights, h_m, [&](double h) { return -measured->sigma() * measured->shear_flow(h); });
  }
  if (!laws.shear_flow || laws.share_difference == 0) return {};
  return along(heights, h_m, [&](double h) {
    return laws.sigma * laws.share_difference * laws.shear_flow->shear_flow(h / laws.sigma);
  });
}

}  // namespace

std::shared_ptr<const FlowFactors> flow_factors(const FactorLaws& laws, const FilmProblem& problem,
                                                const FilmInputs& inputs, const FilmState& state, double h_m,
                                                FlowDirections directions) {
  const FilmGrid& grid = problem.grid;
  auto factors = std::make_shared<FlowFactors>();
  if (laws.thinning) add_thinning(*laws.thinning, problem, inputs, state, h_m, *factors);
  factors->mobility = pressure_flow(laws, grid, h_m);
  if (laws.thinning && factors->mobility.empty()) factors->mobility.assign(grid.x.size(), 1.0);
  for (std::size_t i = 0; i < factors->thinning.size(); ++i) factors->mobility[i] /= factors->thinning[i];
  if (directions == FlowDirections::kBoth) factors->mobility_across = cross_flow(laws, grid, h_m);
  factors->stored = gap_excess(laws, grid.node_height, h_m);
  factors->carried = gap_excess(laws, grid.face_height, h_m);
  const std::vector<double> by_shear = shear_flow(laws, grid.face_height, h_m);
  factors->carried.resize(std::max(factors->carried.size(), by_shear.size()));
  for (std::size_t i = 0; i < by_shear.size(); ++i) factors->carried[i] += by_shear[i];
  if (laws.measured.stress) {
    add_measured_stress(laws, problem, inputs, state, h_m, *factors);
  } else if (laws.stress) {
    add_stress(laws, grid, h_m, *factors);
  }
  return factors;
}

FilmHeights film_heights(const FilmGrid& grid, double h_m) {
  FilmHeights film{grid.node_height, grid.face_height};
  for (auto* const heights : {&film.node, &film.face}) {
    for (double& height : *heights) height += h_m;
  }
  return film;
}

double difference(const FlowFactors& one, const FlowFactors& other, const FilmHeights& film) {
  double largest = 0;
  const auto compare_factors = [&](const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] / b[i] - 1));
  };
  const auto compare_lengths = [&](const std::vector<double>& a, const std::vector<double>& b,
                                   const std::vector<double>& heights) {
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]) / heights[i]);
  };
  compare_factors(one.mobility, other.mobility);
  compare_factors(one.mobility_across, other.mobility_across);
  compare_lengths(one.stored, other.stored, film.node);
  compare_lengths(one.carried, other.carried, film.face);
  return largest;
}

}  // namespace ringfilm::film
