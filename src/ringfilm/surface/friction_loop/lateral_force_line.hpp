#pragma once
#include <vector>

#include "ringfilm/surface/friction_loop/lateral_force_loop.hpp"

/// A straight line through points that are uncertain in both directions.
namespace ringfilm::surface {

struct LinePoint {
  double x = 0, y = 0;
  double x_deviation = 0, y_deviation = 0;  ///< standard deviations, in the units of x and y
};

/// What the standard deviations of the points mean.
enum class DeviationScale {
  kStated,        ///< they are known: the errors of the line follow from them alone
  kFromResiduals  ///< only their ratios are: one factor for all is taken from the scatter about the line
};

/// y = offset + slope x.
struct LineFit {
  double slope = 0, offset = 0;
  double slope_deviation = 0, offset_deviation = 0;  ///< standard errors
  double covariance = 0;                             ///< covariance of slope and offset
  double chi_squared = 0;                            ///< weighted squares about the line, deviations as stated
  double chi_squared_probability = 0;  ///< that stated deviations alone give as much or more [-]; below 0.01 they are
                                       ///< too small, or the relation is not linear
  int points = 0;
  DeviationScale scale = DeviationScale::kFromResiduals;

  /// Degrees of freedom of the standard errors; infinite where the deviations are stated.
  double degrees_of_freedom() const;
  /// Half the width of the interval that holds the true slope with this probability.
  double slope_half_width(double confidence) const;
  double offset_half_width(double confidence) const;
};

/// Weighted total least squares, eq-line-weights to eq-line-errors: the solution of York @cite york2004 for errors that
/// do not are correlated. Equal deviations of all points give the Deming regression, x deviations of 0 the usual
/// weighted one. Throws InputError for less than 3 points, NaN, a point without any deviation, and loads that are all
/// one.
LineFit fit_line(const std::vector<LinePoint>& points, DeviationScale scale);

/// Friction signal against load. Where a load has no known standard error, all count alike and loads are exact.
LineFit friction_load_line(const std::vector<LoadFriction>& loads, DeviationScale scale);

/// The offset of the loops against load, for the wedge method.
LineFit offset_load_line(const std::vector<LoadFriction>& loads, DeviationScale scale);

/// Student's factor of a two-sided interval; `degrees_of_freedom` may be infinite (the normal distribution).
/// Throws InputError for a confidence out of 0 to 1 and for no freedom.
double coverage_factor(double confidence, double degrees_of_freedom);

}  // namespace ringfilm::surface
