#include "ringfilm/film/elastic_face.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ringfilm::film {
namespace {

/// Passes at the most; some five are usual.
constexpr int kMaxPasses = 60;
/// Change of the displacement over h_m that is let through, in units of the tolerance, and the least [-].
constexpr double kDisplacementTolerance = 10, kRounding = 1e-12;
/// Shares of the change that a pass takes over [-].
constexpr double kMinShare = 0.05, kMaxShare = 2;

/// Integral of ln|t| from 0 to t.
double integral_of_log(double t) { return t == 0 ? 0 : t * (std::log(std::abs(t)) - 1); }

/// Aitken's factor of a vector: the share of the next change that would have brought the last two to zero.
double next_share(double share, const std::vector<double>& change, const std::vector<double>& before) {
  double along = 0, squares = 0;
  for (std::size_t i = 0; i < change.size(); ++i) {
    const double difference = change[i] - before[i];
    along += before[i] * difference;
    squares += difference * difference;
  }
  return squares > 0 ? std::clamp(-share * along / squares, kMinShare, kMaxShare) : share;
}

}  // namespace

ElasticFace::ElasticFace(const FilmGrid& grid, double E_prime)
    : unloaded_(grid), lowest_(*std::min_element(grid.node_height.begin(), grid.node_height.end())) {
  const std::size_t n = grid.x.size();
  const double compliance = 4 / (std::numbers::pi * E_prime);
  influence_.reserve(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double begin = j == 0 ? grid.x[0] : 0.5 * (grid.x[j - 1] + grid.x[j]);
      const double end = j + 1 == n ? grid.x[j] : 0.5 * (grid.x[j] + grid.x[j + 1]);
      // In units of the width: the constant that this leaves belongs to the separation.
      const double from = (grid.x[i] - end) / grid.width, to = (grid.x[i] - begin) / grid.width;
      influence_.push_back(-compliance * grid.width * (integral_of_log(to) - integral_of_log(from)));
    }
  }
}

std::vector<double> ElasticFace::displacement(const FilmProblem& problem, const FilmInputs& inputs,
                                              const FilmState& state) const {
  const FilmGrid& grid = problem.grid;
  const std::size_t n = grid.x.size();
  std::vector<double> pressure(n), displaced(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double at = grid.x[i] / grid.width;
    pressure[i] = state.p[i] - (1 - at) * inputs.left.pressure - at * inputs.right.pressure;
    if (problem.contact == nullptr) continue;
    const bool is_local = problem.contact_spread == ContactSpread::kLocal;
    pressure[i] += problem.contact->contact(is_local ? state.h_m + grid.node_height[i] : state.h_m).pressure;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double* row = influence_.data() + i * n;
    for (std::size_t j = 0; j < n; ++j) displaced[i] += row[j] * pressure[j];
  }
  const double at_edges = 0.5 * (displaced.front() + displaced.back());
  for (double& one : displaced) one -= at_edges;
  return displaced;
}

void ElasticFace::lay(const std::vector<double>& displacement, FilmGrid& grid) const {
  const std::size_t n = unloaded_.x.size();
  double lowest = unloaded_.node_height[0] + displacement[0];
  for (std::size_t i = 0; i < n; ++i) {
    grid.node_height[i] = unloaded_.node_height[i] + displacement[i];
    lowest = std::min(lowest, grid.node_height[i]);
  }
  const double lower = lowest - lowest_;
  for (std::size_t i = 0; i < n; ++i) grid.node_height[i] -= lower;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    grid.face_height[i] = unloaded_.face_height[i] + 0.5 * (displacement[i] + displacement[i + 1]) - lower;
  }
  complete_grid(grid);
}

FilmReport ElasticFace::solve(FilmProblem& problem, const FilmInputs& inputs, FilmState& state,
                              const Solve& solve) const {
  const double enough = std::max(kDisplacementTolerance * problem.tolerance, kRounding);
  std::vector<double> held = state.deformation, before;
  if (held.empty()) held.assign(unloaded_.x.size(), 0.0);
  FilmReport total;
  double share = 1;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    lay(held, problem.grid);
    total.add(solve(state));
    if (!total.converged) return total;
    std::vector<double> change = displacement(problem, inputs, state);
    double largest = 0;
    for (std::size_t i = 0; i < change.size(); ++i) {
      change[i] -= held[i];
      largest = std::max(largest, std::abs(change[i]));
    }
    state.deformation = held;
    if (largest <= enough * state.h_m) return total;
    if (!before.empty()) share = next_share(share, change, before);
    for (std::size_t i = 0; i < change.size(); ++i) held[i] += share * change[i];
    before = std::move(change);
  }
  total.converged = false;
  total.failure = Failure::kNotConverged;
  return total;
}

}  // namespace ringfilm::film
