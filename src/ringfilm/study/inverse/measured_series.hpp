#pragma once
#include <Eigen/Core>

#include "ringfilm/study/inverse/fit.hpp"

namespace ringfilm::study {

/// Common errors of a measured series.
struct SeriesErrors {
  double offset = 0;           ///< [SI]
  double scale = 0;            ///< relative [-]
  double angle_shift_deg = 0;  ///< [degree]
};

/// What the model gives for a measured series, eq-measured-model. @param i place in Fit::measured
Eigen::VectorXd computed_series(const Measured& measured, const ModelOutput& output, std::size_t i,
                                const SeriesErrors& errors);

/// Residuals of a measured series as independent ones of standard deviation 1, eq-whitening.
class Whitening {
 public:
  /// @param discrepancy its standard deviation [SI]
  Whitening(const Measured& measured, double discrepancy);
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& residuals) const;
  /// The other way: from independent ones to those of the series.
  Eigen::MatrixXd restored(const Eigen::MatrixXd& independent) const;

 private:
  Eigen::MatrixXd factor_;  ///< lower triangle of the covariance; one column: of a diagonal
};

/// The standard deviation of the discrepancy under which residuals are most likely, eq-discrepancy-likelihood; 0 where
/// they are as small as the errors of the measurement.
/// @param residuals computed less measured [SI]
double likely_discrepancy(const Measured& measured, const Eigen::VectorXd& residuals);

}  // namespace ringfilm::study
