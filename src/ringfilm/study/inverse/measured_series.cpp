#include "ringfilm/study/inverse/measured_series.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::study {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Distance of two crank angles in the cycle [degree].
double angle_between(double a, double b) { return std::abs(std::remainder(a - b, cycle::kCycleDeg)); }

/// A curve over the cycle at a crank angle, straight between its samples. @param axis rising, within one cycle
double at_angle(const std::vector<double>& axis, const std::vector<double>& curve, double angle) {
  const double first = axis.front();
  const double x = first + (angle - first) - cycle::kCycleDeg * std::floor((angle - first) / cycle::kCycleDeg);
  const auto after = std::upper_bound(axis.begin(), axis.end(), x);
  const auto left = static_cast<std::size_t>(after - axis.begin()) - 1;
  const std::size_t right = after == axis.end() ? 0 : left + 1;
  const double end = after == axis.end() ? first + cycle::kCycleDeg : axis[right];
  const double share = (x - axis[left]) / (end - axis[left]);
  return curve[left] + share * (curve[right] - curve[left]);
}

/// Correlation of the discrepancy between the values of a series.
MatrixXd discrepancy_correlation(const Measured& measured) {
  const auto n = static_cast<Eigen::Index>(measured.values.size());
  MatrixXd correlation = MatrixXd::Identity(n, n);
  if (!measured.is_curve()) return correlation;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double apart = angle_between(measured.crank_angle_deg[static_cast<std::size_t>(i)],
                                         measured.crank_angle_deg[static_cast<std::size_t>(j)]) /
                           measured.discrepancy_length_deg;
      correlation(i, j) = correlation(j, i) = std::exp(-apart * apart / 2);
    }
  }
  return correlation;
}

VectorXd deviations_of(const Measured& measured) {
  return Eigen::Map<const VectorXd>(measured.deviations.data(), static_cast<Eigen::Index>(measured.deviations.size()));
}

}  // namespace

VectorXd computed_series(const Measured& measured, const ModelOutput& output, std::size_t i,
                         const SeriesErrors& errors) {
  const std::vector<double>& values = output.values[i];
  VectorXd computed(static_cast<Eigen::Index>(measured.values.size()));
  for (Eigen::Index k = 0; k < computed.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double value = measured.is_curve()
                             ? at_angle(output.axes[i], values, measured.crank_angle_deg[at] + errors.angle_shift_deg)
                             : values[at];
    computed[k] = (1 + errors.scale) * value + errors.offset;
  }
  return computed;
}

Whitening::Whitening(const Measured& measured, double discrepancy) : factor_(deviations_of(measured)) {
  if (!(discrepancy > 0)) return;
  const VectorXd variances = factor_.col(0).cwiseAbs2();
  MatrixXd covariance = discrepancy * discrepancy * discrepancy_correlation(measured);
  covariance.diagonal() += variances;
  factor_ = covariance.llt().matrixL();
}

MatrixXd Whitening::operator()(const MatrixXd& residuals) const {
  if (factor_.cols() == 1) return factor_.col(0).cwiseInverse().asDiagonal() * residuals;
  return factor_.triangularView<Eigen::Lower>().solve(residuals);
}

MatrixXd Whitening::restored(const MatrixXd& independent) const {
  if (factor_.cols() == 1) return factor_.col(0).asDiagonal() * independent;
  return factor_.triangularView<Eigen::Lower>() * independent;
}

double likely_discrepancy(const Measured& measured, const VectorXd& residuals) {
  constexpr int kSteps = 120;  // from a hundredth of the scatter of the residuals to ten times it, 6 % each
  const VectorXd inverse = deviations_of(measured).cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(inverse.asDiagonal() * discrepancy_correlation(measured) *
                                                      inverse.asDiagonal());
  const VectorXd scores = modes.eigenvectors().transpose() * (inverse.asDiagonal() * residuals);
  const double scatter = std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
  // Twice the negative logarithm of the likelihood, but for a constant.
  const auto unlikelihood = [&](double deviation) {
    const Eigen::ArrayXd variances = 1 + deviation * deviation * modes.eigenvalues().array().max(0);
    return (variances.log() + scores.array().square() / variances).sum();
  };
  double best = 0, least = unlikelihood(0);
  for (int i = 0; i <= kSteps; ++i) {
    const double deviation = scatter * std::pow(10., -2 + 3. * i / kSteps);
    const double here = unlikelihood(deviation);
    if (here < least) {
      best = deviation;
      least = here;
    }
  }
  return best;
}

}  // namespace ringfilm::study
