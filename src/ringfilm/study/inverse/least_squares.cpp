#include "ringfilm/study/inverse/least_squares.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ringfilm::study {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxSteps = 100;
constexpr int kMaxUpdates = 5;          // updates of the derivatives before they are computed again; assumed
constexpr double kFirstDamping = 1e-3;  // as usual
constexpr double kMaxDamping = 1e12;    // where steps are far below rounding
constexpr double kMinGain = 1e-4;       // part of the promised reduction with which a step is accepted
constexpr double kGoodGain = 0.25;      // below it the derivatives are computed again

/// A step and by how much it lowers the sum of squares of the linear model.
struct Step {
  VectorXd step;
  double promised = 0;
};

class Search {
 public:
  Search(const LeastSquares& problem, VectorXd x, std::optional<MatrixXd> jacobian, double tolerance)
      : problem_(problem), tolerance_(tolerance) {
    now_.x = x.cwiseMax(problem.lower).cwiseMin(problem.upper);
    if (jacobian) now_.jacobian = std::move(*jacobian);
  }

  LeastSquaresSolution run() {
    std::optional<VectorXd> first = problem_.residuals(now_.x);
    if (!first) return std::move(now_);
    now_.residuals = std::move(*first);
    now_.sum = now_.residuals.squaredNorm();
    if (now_.jacobian.size() == 0 && !renew()) return std::move(now_);
    for (int i = 0; i < kMaxSteps && !now_.has_converged; ++i) {
      if (!advance()) break;
    }
    return std::move(now_);
  }

 private:
  /// @returns whether the derivatives could be computed
  bool renew() {
    std::optional<MatrixXd> jacobian = problem_.jacobian(now_.x, now_.residuals);
    if (!jacobian) return false;
    now_.jacobian = std::move(*jacobian);
    n_updates_ = 0;
    return true;
  }

  bool is_fresh() const { return n_updates_ == 0; }

  /// One step, taken or refused. @returns whether to continue
  bool advance() {
    const Step step = damped_step();
    if (step.promised <= tolerance_) {
      // Cut off at bounds, a step may promise nothing that a shorter one does.
      if (is_fresh() && step.promised < 0) return refuse();
      if (is_fresh()) {
        now_.has_converged = true;
        return false;
      }
      return renew();
    }
    const VectorXd x = now_.x + step.step;
    const std::optional<VectorXd> residuals = problem_.residuals(x);
    const double sum = residuals ? residuals->squaredNorm() : INFINITY;
    const double gain = (now_.sum - sum) / step.promised;
    if (!(gain > kMinGain)) return refuse();
    const VectorXd moved = *residuals - now_.residuals - now_.jacobian * step.step;
    now_.jacobian += moved * step.step.transpose() / step.step.squaredNorm();
    ++n_updates_;
    now_.x = x;
    now_.residuals = *residuals;
    now_.sum = sum;
    damping_ = gain > kGoodGain ? damping_ / 5 : damping_;
    growth_ = 2;
    if (gain < kGoodGain || n_updates_ > kMaxUpdates) return renew();
    return true;
  }

  /// After a step that does not lower the sum.
  bool refuse() {
    if (!is_fresh()) return renew();
    damping_ *= growth_ * 2;
    growth_ *= 2;
    if (damping_ < kMaxDamping) return true;
    now_.has_converged = true;  // within the noise of the residuals
    return false;
  }

  /// Unknowns that may move: all but those at a bound that the sum pushes against.
  std::vector<Eigen::Index> free_unknowns() const {
    const VectorXd gradient = now_.jacobian.transpose() * now_.residuals;
    std::vector<Eigen::Index> free;
    for (Eigen::Index j = 0; j < now_.x.size(); ++j) {
      const bool is_at_lower = now_.x[j] <= problem_.lower[j] && gradient[j] >= 0;
      const bool is_at_upper = now_.x[j] >= problem_.upper[j] && gradient[j] <= 0;
      if (!is_at_lower && !is_at_upper) free.push_back(j);
    }
    return free;
  }

  Step damped_step() const {
    Step step{VectorXd::Zero(now_.x.size()), 0};
    std::vector<Eigen::Index> free = free_unknowns();
    VectorXd at = now_.residuals;  // residuals of the linear model behind what is decided already
    while (!free.empty()) {
      const VectorXd move = solve(free, at);
      // An unknown that would leave its bounds is set to the bound, and the others are found again.
      std::vector<Eigen::Index> inside;
      for (std::size_t k = 0; k < free.size(); ++k) {
        const Eigen::Index j = free[k];
        const double target = now_.x[j] + move[static_cast<Eigen::Index>(k)];
        if (target >= problem_.lower[j] && target <= problem_.upper[j]) {
          inside.push_back(j);
          continue;
        }
        step.step[j] = std::clamp(target, problem_.lower[j], problem_.upper[j]) - now_.x[j];
        at += now_.jacobian.col(j) * step.step[j];
      }
      if (inside.size() == free.size()) {
        for (std::size_t k = 0; k < free.size(); ++k) step.step[free[k]] = move[static_cast<Eigen::Index>(k)];
        break;
      }
      free = std::move(inside);
    }
    step.promised = now_.sum - (now_.residuals + now_.jacobian * step.step).squaredNorm();
    return step;
  }

  /// The damped step of these unknowns.
  VectorXd solve(const std::vector<Eigen::Index>& free, const VectorXd& residuals) const {
    const auto n = static_cast<Eigen::Index>(free.size()), m = residuals.size();
    MatrixXd stacked = MatrixXd::Zero(m + n, n);
    VectorXd right = VectorXd::Zero(m + n);
    right.head(m) = -residuals;
    double largest = 0;
    for (const Eigen::Index j : free) largest = std::max(largest, now_.jacobian.col(j).norm());
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto column = now_.jacobian.col(free[static_cast<std::size_t>(k)]);
      stacked.col(k).head(m) = column;
      // A column that hardly counts is damped as one that does: it would go to its bound for nothing.
      stacked(m + k, k) = std::sqrt(damping_) * std::max(column.norm(), 1e-3 * largest);
    }
    return stacked.colPivHouseholderQr().solve(right);
  }

  const LeastSquares& problem_;
  double tolerance_, damping_ = kFirstDamping, growth_ = 2;
  int n_updates_ = kMaxUpdates;  // derivatives from elsewhere count as updated
  LeastSquaresSolution now_;
};

}  // namespace

LeastSquaresSolution solve_least_squares(const LeastSquares& problem, VectorXd x, std::optional<MatrixXd> jacobian,
                                         double tolerance) {
  return Search(problem, std::move(x), std::move(jacobian), tolerance).run();
}

}  // namespace ringfilm::study
