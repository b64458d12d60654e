#include "ringfilm/study/inverse/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ringfilm::study::LeastSquares;
using ringfilm::study::solve_least_squares;

/// Rosenbrock's valley as a sum of two squares; its lowest place is (1, 1).
LeastSquares valley(double lower, double upper) {
  LeastSquares problem;
  problem.lower = VectorXd::Constant(2, lower);
  problem.upper = VectorXd::Constant(2, upper);
  problem.residuals = [](const VectorXd& x) { return VectorXd{{10 * (x[1] - x[0] * x[0]), 1 - x[0]}}; };
  problem.jacobian = [](const VectorXd& x, const VectorXd&) { return MatrixXd{{-20 * x[0], 10.}, {-1., 0.}}; };
  return problem;
}

TEST(LeastSquares, EndOfAValleyIsFound) {
  const auto end = solve_least_squares(valley(-3, 3), VectorXd{{-1.2, 1.}}, std::nullopt, 1e-14);
  EXPECT_TRUE(end.has_converged);
  EXPECT_NEAR(end.x[0], 1, 1e-6);  // the root of the tolerance of the sum is 1e-7
  EXPECT_NEAR(end.x[1], 1, 1e-6);
}

TEST(LeastSquares, MinimumBeyondABoundLiesOnIt) {
  // Within x <= 0.5 the lowest place is x = (0.5, 0.25), where the sum is 0.25.
  const auto end = solve_least_squares(valley(-3, 0.5), VectorXd{{-1.2, 0.4}}, std::nullopt, 1e-14);
  EXPECT_TRUE(end.has_converged);
  EXPECT_EQ(end.x[0], 0.5);
  EXPECT_NEAR(end.x[1], 0.25, 1e-6);
  EXPECT_NEAR(end.sum, 0.25, 1e-12);
}

TEST(LeastSquares, UnknownsWithoutEffectDoNotMoveTheFit) {
  LeastSquares problem = valley(-3, 3);
  problem.lower = VectorXd::Constant(3, -3);
  problem.upper = VectorXd::Constant(3, 3);
  problem.jacobian = [](const VectorXd& x, const VectorXd&) { return MatrixXd{{-20 * x[0], 10., 0.}, {-1., 0., 0.}}; };
  const auto end = solve_least_squares(problem, VectorXd{{-1.2, 1., 0.3}}, std::nullopt, 1e-14);
  EXPECT_NEAR(end.x[0], 1, 1e-6);
  EXPECT_EQ(end.x[2], 0.3);
}

TEST(LeastSquares, PlacesWithoutResidualsAreAvoided) {
  LeastSquares problem = valley(-3, 3);
  problem.residuals = [plain = problem.residuals](const VectorXd& x) -> std::optional<VectorXd> {
    return x[1] > 2 ? std::nullopt : plain(x);
  };
  const auto end = solve_least_squares(problem, VectorXd{{-1.2, 1.}}, std::nullopt, 1e-14);
  EXPECT_NEAR(end.x[0], 1, 1e-6);
}

}  // namespace
