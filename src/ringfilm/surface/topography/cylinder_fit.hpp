#pragma once
#include <span>

#include "ringfilm/surface/topography/form.hpp"
#include "ringfilm/surface/topography/polynomial_fit.hpp"

namespace ringfilm::surface {

/// The near side of a cylinder, eq-surface-cylinder.
class CylinderForm {
 public:
  /// Height of the ridge over the centre, tilt (slope along the axis), curvature [1/m] (positive: convex), offset of
  /// the ridge [m], angle of the axis [rad].
  struct Parameters {
    double height_m, tilt, curvature_per_m, offset_m, angle_rad;
  };
  CylinderForm(const HeightMap& map, const Parameters& parameters);

  /// Its heights in a row of the map [m].
  void row(std::size_t j, std::span<double> heights) const;
  FormAtCentre at_centre() const;
  Cylinder cylinder() const;

 private:
  double height_at(double x_m, double y_m) const;

  std::size_t points_x_, points_y_;
  double step_x_m_, step_y_m_;
  Parameters at_;
};

/// Least squares of the heights over all five parameters (a profile: circle, three).
/// @throws InputError where no curvature can be found or the map reaches over the side of the cylinder
CylinderForm fit_cylinder(const HeightMap& map);

}  // namespace ringfilm::surface
