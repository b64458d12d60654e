#include "ringfilm/gas_path/radau.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::gas_path {
namespace {

constexpr double kRoot6 = 2.449489742783178098;
constexpr double kTableau[3][3] = {{(88 - 7 * kRoot6) / 360, (296 - 169 * kRoot6) / 1800, (-2 + 3 * kRoot6) / 225},
                                   {(296 + 169 * kRoot6) / 1800, (88 + 7 * kRoot6) / 360, (-2 - 3 * kRoot6) / 225},
                                   {(16 - kRoot6) / 36, (16 + kRoot6) / 36, 1.0 / 9}};
/// The real eigenvalue of the inverse of the tableau, and weights of the embedded formula.
constexpr double kRealEigenvalue = 3.637834252744496;
constexpr double kEmbedded[3] = {-(13 + 7 * kRoot6) / 3, (-13 + 7 * kRoot6) / 3, -1.0 / 3};

constexpr int kMaxIterations = 12;
/// Iterations with new slopes at each stage: a pressure that falls from the peak of a cycle to that of the crankcase
/// takes some five of them until it is near, and as many to converge.
constexpr int kMaxFullIterations = 20;
/// Share of the tolerance of a step that its iteration may leave.
constexpr double kIterationShare = 1e-4;
/// A change of an unknown beyond that is an iteration that diverges.
constexpr double kMaxChange = 1e6;

/// Lagrange weights at `x` of the polynomial through 0 and the nodes of the stages.
void lagrange_weights(double x, double (&weight)[4]) {
  const double at[4] = {0, RadauStep::kNodes[0], RadauStep::kNodes[1], RadauStep::kNodes[2]};
  for (int i = 0; i < 4; ++i) {
    weight[i] = 1;
    for (int k = 0; k < 4; ++k) {
      if (k != i) weight[i] *= (x - at[k]) / (at[i] - at[k]);
    }
  }
}

}  // namespace

const double RadauStep::kNodes[3] = {(4 - kRoot6) / 10, (4 + kRoot6) / 10, 1};
const double RadauStep::kWeights[3] = {kTableau[2][0], kTableau[2][1], kTableau[2][2]};

bool LuFactors::factorize(const std::vector<double>& matrix, std::size_t n) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  lu_.compute(Rows::Map(matrix.data(), n, n));
  return (lu_.matrixLU().diagonal().array().abs() > 1e-300).all();
}

void LuFactors::solve(std::span<double> x) const {
  auto unknowns = Eigen::VectorXd::Map(x.data(), x.size());
  unknowns = lu_.solve(unknowns);
}

RadauStep::Outcome RadauStep::solve(OdeSystem& system, double t, std::span<const double> y, double h,
                                    std::span<const double> scale) {
  if (system.size() != n_) has_guess_ = false;
  n_ = system.size();
  guess(y, h);
  begin_.assign(y.begin(), y.end());
  if (n_ == 0) return {true, 0};
  rates_.resize(kStages * n_);
  change_.resize(kStages * n_);
  jacobian_.assign(n_ * n_, 0);
  system.jacobian(t, y, jacobian_);
  first_ = stages_;
  has_guess_ = factorize(h) &&
               (iterate(system, t, h, scale, Slopes::kOfBegin) || iterate(system, t, h, scale, Slopes::kOfStages));
  if (!has_guess_) return {};
  last_step_ = h;
  return {true, error(system, t, h, scale)};
}

/// First values of the stages: the polynomial of the step before, which ends where this one begins.
void RadauStep::guess(std::span<const double> y, double h) {
  if (!has_guess_) {
    stages_.resize(kStages * n_);
    for (std::size_t j = 0; j < kStages; ++j) std::copy(y.begin(), y.end(), stages_.begin() + j * n_);
    return;
  }
  before_ = stages_;
  double weight[4];
  for (std::size_t j = 0; j < kStages; ++j) {
    lagrange_weights(1 + kNodes[j] * std::min(h / last_step_, 5.0), weight);
    for (std::size_t i = 0; i < n_; ++i) {
      stages_[j * n_ + i] = weight[0] * begin_[i] + weight[1] * before_[i] + weight[2] * before_[n_ + i] +
                            weight[3] * before_[2 * n_ + i];
    }
  }
}

/// I - h A x J, and the matrix of the error estimate.
bool RadauStep::factorize(double h) {
  const std::size_t m = kStages * n_;
  matrix_.assign(m * m, 0);
  for (std::size_t a = 0; a < kStages; ++a) {
    for (std::size_t b = 0; b < kStages; ++b) {
      for (std::size_t i = 0; i < n_; ++i) {
        double* const row = matrix_.data() + (a * n_ + i) * m + b * n_;
        for (std::size_t k = 0; k < n_; ++k) row[k] = -h * kTableau[a][b] * jacobian_[i * n_ + k];
        if (a == b) row[i] += 1;
      }
    }
  }
  if (!all_.factorize(matrix_, m)) return false;
  matrix_.resize(n_ * n_);
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < n_; ++k) {
      matrix_[i * n_ + k] = (i == k ? kRealEigenvalue / h : 0.0) - jacobian_[i * n_ + k];
    }
  }
  return one_.factorize(matrix_, n_);
}

/// I - h A x J with the Jacobians of the stages.
bool RadauStep::factorize_at_stages(OdeSystem& system, double t, double h) {
  const std::size_t m = kStages * n_;
  matrix_.assign(m * m, 0);
  for (std::size_t b = 0; b < kStages; ++b) {
    jacobian_.assign(n_ * n_, 0);
    system.jacobian(t + kNodes[b] * h, stage(b), jacobian_);
    for (std::size_t a = 0; a < kStages; ++a) {
      for (std::size_t i = 0; i < n_; ++i) {
        double* const row = matrix_.data() + (a * n_ + i) * m + b * n_;
        for (std::size_t k = 0; k < n_; ++k) row[k] = -h * kTableau[a][b] * jacobian_[i * n_ + k];
        if (a == b) row[i] += 1;
      }
    }
  }
  return all_.factorize(matrix_, m);
}

bool RadauStep::iterate(OdeSystem& system, double t, double h, std::span<const double> scale, Slopes slopes) {
  double norm_before = 0;
  const bool at_stages = slopes == Slopes::kOfStages;
  stages_ = first_;
  for (int iteration = 0; iteration < (at_stages ? kMaxFullIterations : kMaxIterations); ++iteration) {
    if (at_stages && !factorize_at_stages(system, t, h)) return false;
    for (std::size_t j = 0; j < kStages; ++j) {
      system.rates(t + kNodes[j] * h, stage(j), {rates_.data() + j * n_, n_});
    }
    for (std::size_t j = 0; j < kStages; ++j) {
      for (std::size_t i = 0; i < n_; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < kStages; ++k) sum += kTableau[j][k] * rates_[k * n_ + i];
        change_[j * n_ + i] = begin_[i] + h * sum - stages_[j * n_ + i];
      }
    }
    all_.solve(change_);
    if (at_stages) {
      for (std::size_t j = 0; j < kStages; ++j) system.limit(stage(j), {change_.data() + j * n_, n_});
    }
    double norm = 0;
    for (std::size_t k = 0; k < change_.size(); ++k) {
      const double change = std::abs(change_[k]);
      if (!(change < kMaxChange)) return false;
      stages_[k] += change_[k];
      norm = std::max(norm, change / scale[k % n_]);
    }
    if (norm < kIterationShare) return true;
    if (iteration > 0) {
      const double rate = norm / norm_before;
      if (!at_stages && (rate >= 2 || (iteration > 4 && rate > 0.9))) return false;
      if (rate < 1 && norm * rate / (1 - rate) < kIterationShare) return true;
    }
    norm_before = norm;
  }
  return false;
}

double RadauStep::error(OdeSystem& system, double t, double h, std::span<const double> scale) {
  std::vector<double>& estimate = change_;
  const std::span<double> first(estimate.data(), n_);
  system.rates(t, begin_, first);
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = 0; j < kStages; ++j) first[i] += kEmbedded[j] / h * (stages_[j * n_ + i] - begin_[i]);
  }
  one_.solve(first);
  double sum = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    const double share = std::min(std::abs(first[i]) / scale[i], 1e100);
    sum += share * share;
  }
  return std::sqrt(sum / static_cast<double>(n_));
}

void RadauStep::interpolate(double share, std::span<double> y) const {
  double weight[4];
  lagrange_weights(share, weight);
  for (std::size_t i = 0; i < n_; ++i) {
    y[i] = weight[0] * begin_[i];
    for (std::size_t j = 0; j < kStages; ++j) y[i] += weight[j + 1] * stages_[j * n_ + i];
  }
}

void RadauStep::carry(std::vector<double>& derivatives, std::size_t n_columns) const {
  std::vector<double> column(kStages * n_);
  for (std::size_t c = 0; c < n_columns; ++c) {
    for (std::size_t k = 0; k < column.size(); ++k) column[k] = derivatives[(k % n_) * n_columns + c];
    all_.solve(column);
    for (std::size_t i = 0; i < n_; ++i) derivatives[i * n_columns + c] = column[2 * n_ + i];
  }
}

}  // namespace ringfilm::gas_path
