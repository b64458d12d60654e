#include "ringfilm/study/inverse/profile.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

namespace ringfilm::study {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kCoverage = 0.95;
constexpr int kMaxTries = 12;
constexpr double kCloseEnough = 0.02;     // relative, of the square root of the rise: of the width of the interval, too
constexpr double kInnerTolerance = 1e-3;  // change of the sum, far below its rise

double rise_at_end() { return boost::math::quantile(boost::math::chi_squared(1), kCoverage); }

/// One side of a profile.
class Side {
 public:
  Side(const LeastSquares& problem, const LeastSquaresSolution& best, const MatrixXd& jacobian, Index unknown)
      : problem_(problem), best_(best), unknown_(unknown), x_(best.x), jacobian_(jacobian) {}

  /// @param bound place at which the side ends at the latest  @param step first distance
  double end(double bound, double step) {
    const double from = best_.x[unknown_], wanted = std::sqrt(rise_at_end());
    const double direction = bound > from ? 1 : -1;
    const double farthest = std::abs(bound - from);
    if (farthest <= 0) return bound;
    // The root of the rise is about proportional to the distance.
    double inside = 0, root_inside = 0, outside = 0, root_outside = 0;
    double distance = std::min(step * wanted, farthest);
    for (int i = 0; i < kMaxTries; ++i) {
      const double root = std::sqrt(std::max(sum_at(from + direction * distance) - best_.sum, 0.));
      if (std::abs(root - wanted) < kCloseEnough * wanted) return from + direction * distance;
      if (root < wanted) {
        if (distance >= farthest) return bound;
        inside = distance;
        root_inside = root;
      } else {
        outside = distance;
        root_outside = root;
      }
      distance = next(inside, root_inside, outside, root_outside, wanted, farthest);
    }
    return from + direction * (outside > 0 ? (inside + outside) / 2 : inside);
  }

 private:
  static double next(double inside, double root_inside, double outside, double root_outside, double wanted,
                     double farthest) {
    if (outside <= 0) {  // farther out, at most fivefold
      const double guess = root_inside > 0 ? inside * wanted / root_inside : 5 * inside;
      return std::min(std::clamp(1.05 * guess, 1.2 * inside, 5 * inside), farthest);
    }
    const double share = std::isfinite(root_outside) ? (wanted - root_inside) / (root_outside - root_inside) : 0.5;
    return inside + std::clamp(share, 0.1, 0.9) * (outside - inside);
  }

  /// The smallest sum with the unknown at a place; the others start from where they were.
  double sum_at(double place) {
    LeastSquares kept = problem_;
    kept.lower[unknown_] = kept.upper[unknown_] = place;
    VectorXd x = x_;
    x[unknown_] = place;
    LeastSquaresSolution end;
    if (x.size() == 1) {
      const std::optional<VectorXd> residuals = problem_.residuals(x);
      return residuals ? residuals->squaredNorm() : std::numeric_limits<double>::infinity();
    }
    end = solve_least_squares(kept, predicted(x), jacobian_, kInnerTolerance);
    if (end.residuals.size() == 0) return std::numeric_limits<double>::infinity();
    x_ = end.x;
    return end.sum;
  }

  /// The others moved as the linear model has them follow.
  VectorXd predicted(VectorXd x) const {
    const Index n = x.size();
    MatrixXd others(jacobian_.rows(), n - 1);
    for (Index j = 0, k = 0; j < n; ++j) {
      if (j != unknown_) others.col(k++) = jacobian_.col(j);
    }
    const VectorXd moved = jacobian_.col(unknown_) * (x[unknown_] - x_[unknown_]);
    MatrixXd information = others.transpose() * others;
    information.diagonal().array() += 1e-6 * information.diagonal().maxCoeff();
    const VectorXd follow = information.ldlt().solve(-others.transpose() * moved);
    for (Index j = 0, k = 0; j < n; ++j) {
      if (j != unknown_) x[j] += follow[k++];
    }
    return x;
  }

  const LeastSquares& problem_;
  const LeastSquaresSolution& best_;
  Index unknown_;
  VectorXd x_;
  const MatrixXd& jacobian_;
};

}  // namespace

PlaceInterval profile_interval(const LeastSquares& problem, const LeastSquaresSolution& best, const MatrixXd& jacobian,
                               Index unknown, double deviation) {
  PlaceInterval interval;
  interval.low = Side(problem, best, jacobian, unknown).end(problem.lower[unknown], deviation);
  interval.high = Side(problem, best, jacobian, unknown).end(problem.upper[unknown], deviation);
  return interval;
}

}  // namespace ringfilm::study
