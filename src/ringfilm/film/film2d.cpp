#include "ringfilm/film/film2d.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {

int CircumferentialGrid::halfway() const {
  const double middle = 0.5 * length;
  const auto nearest = std::min_element(
      y.begin(), y.end(), [middle](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); });
  return static_cast<int>(nearest - y.begin());
}

CircumferentialGrid around_at(std::vector<double> y, double length, Ends ends) {
  CircumferentialGrid around;
  around.ends = ends;
  around.length = length;
  around.y = std::move(y);
  const int n = around.n_strips();
  for (int j = 0; j + 1 < n; ++j) around.spacing.push_back(around.y[j + 1] - around.y[j]);
  if (ends == Ends::kJoined) around.spacing.push_back(length - around.y.back());
  around.share.assign(n, 0.0);
  for (int c = 0; c < around.n_cells(); ++c) {
    around.share[c] += 0.5 * around.spacing[c];
    around.share[(c + 1) % n] += 0.5 * around.spacing[c];
  }
  return around;
}

CircumferentialGrid uniform_around(int n_cells, double length, Ends ends) {
  std::vector<double> y;
  const int n_strips = ends == Ends::kJoined ? n_cells : n_cells + 1;
  for (int j = 0; j < n_strips; ++j) y.push_back(length * j / n_cells);
  return around_at(std::move(y), length, ends);
}

CircumferentialGrid refined_around(int n_cells, double length, double end_cell) {
  if (end_cell * n_cells >= length) return uniform_around(n_cells, length, Ends::kOpen);
  // Cells grow by `factor` up to `middle`; the more they may grow, the smaller the middle's can be.
  const auto cells = [&](double factor, double middle) {
    std::vector<double> spacing(n_cells, middle);
    double cell = end_cell;
    for (int c = 0; 2 * c < n_cells && cell < middle; ++c, cell *= factor) spacing[c] = spacing[n_cells - 1 - c] = cell;
    return spacing;
  };
  const auto reached = [&](double factor, double middle) {
    double sum = 0;
    for (const double cell : cells(factor, middle)) sum += cell;
    return sum;
  };
  double low = end_cell, high = length;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (reached(kSteepestGrowth, middle) < length ? low : high) = middle;
  }
  // A few cells more may be given to the ends: grow as gently as keeps the middle's cells within a tenth of the least.
  constexpr double kWider = 1.1;
  const double middle = std::min(kWider * high, length);
  double gentle = 1, steep = kSteepestGrowth;
  for (int k = 0; k < 200; ++k) {
    const double factor = 0.5 * (gentle + steep);
    (reached(factor, middle) < length ? gentle : steep) = factor;
  }
  std::vector<double> spacing = cells(steep, middle);
  const double scale = length / reached(steep, middle);
  std::vector<double> y = {0};
  for (int c = 0; c < n_cells; ++c) y.push_back(y.back() + scale * spacing[c]);
  y.back() = length;
  return around_at(std::move(y), length, Ends::kOpen);
}

std::vector<double> row_of_strip(const std::vector<double>& all, int j, int width) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(j) * width;
  return {begin, begin + width};
}

FlowFactors factors_of_strip(const FlowFactors& all, int j, int n_strips) {
  FlowFactors of;
  for (const auto list : kFactorLists) {
    of.*list = row_of_strip(all.*list, j, static_cast<int>((all.*list).size()) / n_strips);
  }
  return of;
}

std::vector<double> rise_of_strips(const Film2dProblem& problem, const Film2dInputs& inputs,
                                   const std::vector<double>& ring) {
  std::vector<double> rise = inputs.rise;
  if (ring.empty()) return rise;
  rise.resize(problem.around.y.size(), 0.0);
  for (std::size_t j = 0; j < rise.size(); ++j) rise[j] += ring[problem.ring.of_strip(static_cast<int>(j))];
  return rise;
}

std::vector<double> separations(const Film2dProblem& problem, const FilmState& state) {
  if (state.ring.empty()) return {state.h_m};
  std::vector<double> of;
  for (int j = 0; j < problem.around.n_strips(); ++j) of.push_back(state.h_m + state.ring[problem.ring.of_strip(j)]);
  return of;
}

bool factor_band(std::vector<double>& band) {
  constexpr int kWidth = ElasticRing::kWidth;
  const int n = static_cast<int>(band.size()) / kWidth;
  for (int i = 0; i < n; ++i) {
    double* row = band.data() + static_cast<std::size_t>(i) * kWidth;
    if (!(row[0] > 0)) return false;
    for (int k = 1; k < kWidth && i + k < n; ++k) {
      const double share = row[k] / row[0];
      double* other = row + static_cast<std::ptrdiff_t>(k) * kWidth;
      for (int l = k; l < kWidth && i + l < n; ++l) other[l - k] -= share * row[l];
    }
    for (int k = 1; k < kWidth; ++k) row[k] /= row[0];
  }
  return true;
}

void solve_band(const std::vector<double>& factored, double* x) {
  constexpr int kWidth = ElasticRing::kWidth;
  const int n = static_cast<int>(factored.size()) / kWidth;
  for (int i = 0; i < n; ++i) {
    const double* row = factored.data() + static_cast<std::size_t>(i) * kWidth;
    for (int k = 1; k < kWidth && i + k < n; ++k) x[i + k] -= row[k] * x[i];
  }
  for (int i = n - 1; i >= 0; --i) {
    const double* row = factored.data() + static_cast<std::size_t>(i) * kWidth;
    x[i] /= row[0];
    for (int k = 1; k < kWidth && i + k < n; ++k) x[i] -= row[k] * x[i + k];
  }
}

double closed_film(const Film2dProblem& problem) {
  constexpr double kOfRoughness = 0.1;
  const models::AsperityContact* contact = problem.strip.contact;
  if (problem.ring.flattening == 0 || contact == nullptr) return 0;
  return std::max(kMolecules, kOfRoughness * contact->length_scale());
}

double closed_separation(double h, double closed, double* slope) {
  const bool is_open = closed == 0 || h >= 2 * closed;
  const double over = is_open ? 1 : h / closed - 1;
  if (slope != nullptr) *slope = 1 / (over * over);
  return is_open ? h : closed * (3 - 1 / over);
}

std::vector<double> displacements(const Film2dProblem& problem, double h_m, std::vector<double> ring) {
  const double closed = closed_film(problem);
  for (int j = 0; closed > 0 && j < problem.around.n_strips(); ++j) {
    double& strip = ring[problem.ring.of_strip(j)];
    if (h_m + strip < 2 * closed) strip = closed_separation(h_m + strip, closed) - h_m;
  }
  return ring;
}

std::vector<double> bending_force(const ElasticRing& of, const Film2dInputs& inputs,
                                  const std::vector<double>& displacement) {
  constexpr int kWidth = ElasticRing::kWidth;
  const int n = of.n_unknowns();
  std::vector<double> force = inputs.bore_force;
  force.resize(n, 0.0);
  for (int i = 0; i < n; ++i) {
    force[i] -= of.band[i * kWidth] * displacement[i];
    for (int k = 1; k < kWidth && i + k < n; ++k) {
      force[i] -= of.band[i * kWidth + k] * displacement[i + k];
      force[i + k] -= of.band[i * kWidth + k] * displacement[i];
    }
  }
  return force;
}

Film2dGap gap_of_strips(const FilmGrid& across, const CircumferentialGrid& around) {
  Film2dGap gap;
  const auto append = [](std::vector<double>& to, const std::vector<double>& strip) {
    to.insert(to.end(), strip.begin(), strip.end());
  };
  for (int j = 0; j < around.n_strips(); ++j) append(gap.node, across.node_height);
  for (int j = 0; j < around.n_strips(); ++j) append(gap.face_x, across.face_height);
  for (int c = 0; c < around.n_cells(); ++c) append(gap.face_y, across.node_height);
  return gap;
}

}  // namespace ringfilm::film
