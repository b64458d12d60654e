#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>

/// Nonlinear least squares between bounds; docs/theory/fit.md.
namespace ringfilm::study {

/// A sum of squares of residuals over a few unknowns.
struct LeastSquares {
  Eigen::VectorXd lower, upper;  ///< bounds of the unknowns
  /// Residuals, each over its standard deviation; nothing where they cannot be computed.
  std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd& x)> residuals;
  /// Derivatives of the residuals with respect to the unknowns; nothing where they cannot be computed.
  std::function<std::optional<Eigen::MatrixXd>(const Eigen::VectorXd& x, const Eigen::VectorXd& residuals)> jacobian;
};

/// Where a search ended.
struct LeastSquaresSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd residuals;  ///< empty: they could not be computed at the start
  Eigen::MatrixXd jacobian;   ///< derivatives; exact where they were computed at x, else updated after Broyden
  double sum = 0;             ///< sum of the squares
  bool has_converged = false;
};

/// Searches the smallest sum of squares from x on by the method of Levenberg and Marquardt @cite levenberg1944
/// @cite marquardt1963; an unknown at a bound that the sum pushes against is kept there. Between evaluations of the
/// derivatives these are updated after Broyden @cite broyden1965.
/// @param jacobian derivatives to begin with, from nearby; nothing: they are computed at the start
/// @param tolerance of the sum: the search ends where a step promises to lower it by less
LeastSquaresSolution solve_least_squares(const LeastSquares& problem, Eigen::VectorXd x,
                                         std::optional<Eigen::MatrixXd> jacobian, double tolerance);

}  // namespace ringfilm::study
