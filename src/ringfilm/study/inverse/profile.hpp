#pragma once
#include "ringfilm/study/inverse/least_squares.hpp"

namespace ringfilm::study {

/// An interval of an unknown, as places between the bounds.
struct PlaceInterval {
  double low = 0, high = 1;
};

/// The 95 % interval of an unknown by the profile likelihood, eq-profile: where the sum of squares, the other unknowns
/// found anew, exceeds the smallest by the quantile of chi squared. It ends at a bound where the sum stays below.
/// @param best the best fit  @param jacobian derivatives there  @param deviation standard deviation by the covariance,
/// from which the search starts
PlaceInterval profile_interval(const LeastSquares& problem, const LeastSquaresSolution& best,
                               const Eigen::MatrixXd& jacobian, Eigen::Index unknown, double deviation);

}  // namespace ringfilm::study
