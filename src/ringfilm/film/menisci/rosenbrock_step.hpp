#pragma once
#include <Eigen/LU>

namespace ringfilm::film {

/// A step of the Rosenbrock method RODAS3 @cite sandu1997 for y' = f(t, y): four stages, order 3 with an embedded
/// solution of order 2, L-stable, its last stage at the end of the step. It needs no past: after a jump of f it
/// continues with the same length.
template <int n>
class RosenbrockStep {
 public:
  using Vector = Eigen::Matrix<double, n, 1>;
  using Matrix = Eigen::Matrix<double, n, n>;

  /// What is known at the begin of a step; of the slopes an approximation serves, at the expense of the order.
  struct Begin {
    double t = 0;
    Vector y;
    Vector rate;         ///< f
    Matrix by_unknowns;  ///< df/dy
  };
  struct End {
    Vector y;
    Vector error;  ///< difference from the embedded solution
  };

  /// @param h length of the step  @param by_time df/dt at its begin  @param rate f(t, y)
  template <class Rate>
  static End take(const Begin& begin, double h, const Vector& by_time, const Rate& rate) {
    constexpr double kGamma = 0.5;
    const Eigen::PartialPivLU<Matrix> lu(Matrix::Identity() / (kGamma * h) - begin.by_unknowns);
    const Vector first = lu.solve(begin.rate + 0.5 * h * by_time);
    const Vector second = lu.solve(begin.rate + 4 / h * first + 1.5 * h * by_time);
    const Vector at_third = begin.y + 2 * first;
    const Vector third = lu.solve(rate(begin.t + h, at_third) + (first - second) / h);
    const Vector at_fourth = at_third + third;
    const Vector fourth = lu.solve(rate(begin.t + h, at_fourth) + (first - second - 8.0 / 3 * third) / h);
    return {at_fourth + fourth, fourth};
  }
};

}  // namespace ringfilm::film
