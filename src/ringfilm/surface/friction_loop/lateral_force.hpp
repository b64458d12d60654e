#pragma once
#include <string>
#include <vector>

#include "ringfilm/surface/friction_loop/lateral_force_calibration.hpp"

/// Friction loops to the coefficient of boundary shear strength (docs/theory/boundary-shear.md).
namespace ringfilm::surface {

/// A sample as measured: its friction-load line.
struct FrictionSample {
  std::string name;      ///< for tables and messages
  LineFit line;          ///< friction signal [V] against load [load_unit]
  LoadUnit load_unit{};  ///< unit of the loads; must be that of the calibration
};

/// zeta = psi m of one sample, eq-zeta, and what makes it uncertain, eq-zeta-shares.
struct ShearStrength {
  std::string sample;                ///< FrictionSample::name
  double zeta = 0;                   ///< [-]
  double slope_deviation = 0;        ///< from the sample's own line [-]
  double calibration_deviation = 0;  ///< from the measurement of psi; common to all samples [-]
  double reference_deviation = 0;    ///< from the value taken over for psi; common to all samples [-]
  double low = 0;                    ///< lower end of the 95 % interval of zeta, not below 0 [-]
  double high = 0;                   ///< upper end of it [-]

  double deviation() const;  ///< one standard deviation, all shares [-]
};

/// Coefficients of several samples and what their errors have in common.
struct ShearStrengths {
  std::vector<ShearStrength> samples;  ///< in the order in which they were given
  /// Covariance of zeta of all samples, row after row: samples of one calibration are correlated, eq-zeta-covariance.
  std::vector<double> covariance;

  double correlation(std::size_t i, std::size_t j) const;  ///< correlation of the errors of two samples [-]
};

/// Throws InputError where loads of samples and calibration differ in kind, a slope is not positive, or the line of a
/// sample is one that the calibration follows from.
ShearStrengths boundary_shear_strengths(const std::vector<FrictionSample>& samples, const Calibration& calibration);

}  // namespace ringfilm::surface
