#pragma once
#include <vector>

#include "ringfilm/base/table.hpp"

namespace ringfilm::models {

/// What the film between a flat land and a rough liner does, over the separation of the mean planes, at one product of
/// viscosity and speed (docs/theory/land.md).
struct LandTable {
  std::vector<double> separation;       ///< rising, above 0 [m]
  std::vector<double> lift;             ///< mean film pressure above ambient, above 0, falling [Pa]
  std::vector<double> friction_factor;  ///< shear stress over eta U/separation, above 0 [-]
  double speed_viscosity = 0;           ///< eta U of the table [N/m]
  double speed_exponent = 1;            ///< lift over (eta U)^this, eq-land-speed [-]
};

/// The lift of a land between the rows of its table: ln lift is a monotone cubic of ln separation, and continues with
/// the powers of the ends; eq-land-table.
class LandLift {
 public:
  static constexpr std::size_t kMinRows = 3;

  /// Throws InputError for fewer than three rows, and rows that do not fall.
  explicit LandLift(LandTable table);

  struct At {
    double lift = 0;        ///< [Pa]
    double lift_slope = 0;  ///< in the separation [Pa/m]
  };
  /// @param h separation, or local film thickness of a face [m]  @param eta_U viscosity times speed, 0 or above [N/m]
  At at(double h, double eta_U) const;

  /// Shear stress over eta U/h; that of the last row beyond it, and of the first before [-].
  double friction_factor(double h) const;

  const LandTable& table() const { return table_; }

 private:
  LandTable table_;
  MonotoneCubic log_lift_, friction_factor_;
};

/// lift sigma^2/(eta U w) = a (s/sigma)^-n, by least squares of the logarithms; eq-land-fit.
struct LandFit {
  double coefficient = 0;  ///< a [-]
  double exponent = 0;     ///< n [-]
  double residual = 0;     ///< rms of what the fit leaves of ln lift [-]
  int rows = 0;            ///< with lift, that the fit has
};

/// Fits rows whose lift is above 0; fewer than two: no rows.
/// @param sigma rms height [m]  @param width of the land [m]
LandFit fit_land(const std::vector<double>& separation, const std::vector<double>& lift, double sigma, double width,
                 double speed_viscosity);

}  // namespace ringfilm::models
