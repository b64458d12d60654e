#include "ringfilm/models/conformity/contact_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ringfilm::models {
namespace {

/// minimum of c A c/2 + b c over c >= 0 with A of five diagonals; the active set loses and gains one point a step.
class GridContact {
 public:
  GridContact(const RingAtWall& ring, int n_steps)
      : n_(static_cast<std::size_t>(n_steps) + 1), diagonals_(n_), linear_(n_, 0), c_(n_, 0), touches_(n_, true) {
    const double step = (ring.end() - ring.start()) / n_steps, k = ring.beam().stiffness();
    const double side = 1 / (step * step), middle = 1 - 2 * side;
    const std::array<double, 3> row{side, middle, side};
    for (std::size_t i = 1; i + 1 < n_; ++i) {
      const double moment = ring.moment_in_contact(ring.start() + static_cast<double>(i) * step);
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b <= a; ++b) diagonals_[i - 1 + b][a - b] += step * k * row[a] * row[b];
        linear_[i - 1 + a] += step * moment * row[a];
      }
    }
    for (std::size_t i = 0; i < n_; ++i) {
      const bool at_tip = i == 0 || i + 1 == n_;
      linear_[i] += ring.gas() * ring.beam().centroid_radius() * step * (at_tip ? 0.5 : 1.0);
      diagonals_[i][0] += 1e-9 * k * step;  // a ring that touches in one point only can move otherwise
    }
    tolerance_ = 1e-9 * ring.beam().centroid_radius() * step * (ring.beam().size().tangential_force + ring.gas());
  }

  std::vector<bool> solve() {
    const std::size_t most = 20 * n_;
    for (std::size_t i = 0; i < most; ++i) {
      const std::vector<double> target = free_minimum();
      if (moved(target) && !release()) break;
    }
    return touches_;
  }

 private:
  /// The minimum where points that touch stay; the others are not bound.
  std::vector<double> free_minimum() const {
    // A = L D L^T on free points, row by row; those that touch have rows of the identity.
    std::vector<std::array<double, 3>> factor(n_);  // D, then L one and two below
    std::vector<double> x(n_);
    const auto entry = [&](std::size_t i, std::size_t below) {
      return touches_[i] || touches_[i + below] ? (below == 0 ? 1.0 : 0.0) : diagonals_[i][below];
    };
    for (std::size_t i = 0; i < n_; ++i) {
      double pivot = entry(i, 0);
      if (i > 0) pivot -= factor[i - 1][1] * factor[i - 1][1] * factor[i - 1][0];
      if (i > 1) pivot -= factor[i - 2][2] * factor[i - 2][2] * factor[i - 2][0];
      factor[i][0] = pivot;
      if (i + 1 < n_) {
        double below = entry(i, 1);
        if (i > 0) below -= factor[i - 1][2] * factor[i - 1][1] * factor[i - 1][0];
        factor[i][1] = below / pivot;
      }
      if (i + 2 < n_) factor[i][2] = entry(i, 2) / pivot;
      x[i] = touches_[i] ? 0 : -linear_[i];
      if (i > 0) x[i] -= factor[i - 1][1] * x[i - 1];
      if (i > 1) x[i] -= factor[i - 2][2] * x[i - 2];
    }
    for (std::size_t i = n_; i-- > 0;) {
      x[i] /= factor[i][0];
      if (i + 1 < n_) x[i] -= factor[i][1] * x[i + 1];
      if (i + 2 < n_) x[i] -= factor[i][2] * x[i + 2];
      if (touches_[i]) x[i] = 0;
    }
    return x;
  }

  /// Goes towards the target until a point touches. @returns whether it was reached
  bool moved(const std::vector<double>& target) {
    double share = 1;
    std::size_t blocking = n_;
    for (std::size_t i = 0; i < n_; ++i) {
      if (touches_[i] || target[i] >= 0) continue;
      const double reached = c_[i] / (c_[i] - target[i]);
      if (reached < share || blocking == n_) {
        share = reached;
        blocking = i;
      }
    }
    for (std::size_t i = 0; i < n_; ++i) {
      if (!touches_[i]) c_[i] = std::max(0.0, c_[i] + share * (target[i] - c_[i]));
    }
    if (blocking == n_) return true;
    c_[blocking] = 0;
    touches_[blocking] = true;
    return false;
  }

  /// Frees the point that the wall would have to pull most. @returns whether there was one
  bool release() {
    std::size_t worst = n_;
    double lowest = -tolerance_;
    for (std::size_t i = 0; i < n_; ++i) {
      if (!touches_[i]) continue;
      const double force = gradient(i);
      if (force < lowest) {
        lowest = force;
        worst = i;
      }
    }
    if (worst == n_) return false;
    touches_[worst] = false;
    return true;
  }

  double gradient(std::size_t i) const {
    double sum = linear_[i] + diagonals_[i][0] * c_[i];
    for (std::size_t below = 1; below < 3; ++below) {
      if (i + below < n_) sum += diagonals_[i][below] * c_[i + below];
      if (i >= below) sum += diagonals_[i - below][below] * c_[i - below];
    }
    return sum;
  }

  std::size_t n_;
  std::vector<std::array<double, 3>> diagonals_;  ///< diagonals of A: the main one, and the first and second below it
  std::vector<double> linear_, c_;
  std::vector<bool> touches_;
  double tolerance_ = 0;
};

}  // namespace

std::vector<bool> contact_on_grid(const RingAtWall& ring, int n_steps) { return GridContact(ring, n_steps).solve(); }

}  // namespace ringfilm::models
