#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// What shape is removed before statistics (F-operation).
enum class FormKind { none, mean, tilt, cylinder, polynomial };

struct FormChoice {
  FormKind kind = FormKind::tilt;
  int degree = 2;  ///< degree of a polynomial: largest sum of the powers of x and y, 0 to 12
};

/// A cylinder as found: its axis may lie at any angle in the plane of the map and be tilted out of it. A profile gives
/// a circle and no angle.
struct Cylinder {
  double radius_m = 0.0;  ///< radius of curvature [m], positive for a convex surface (a ring face, seen from outside)
  double axis_angle_rad = 0.0;  ///< angle of the axis from the x axis, in (-pi/2, pi/2]
  double axis_tilt_rad = 0.0;   ///< tilt of the axis out of the plane of the map
  double ridge_offset_m = 0.0;  ///< distance of the ridge from the centre of the map, across the axis
};

/// What was removed.
struct FormRemoved {
  FormKind kind = FormKind::none;
  int degree = 0;
  double mean_m = 0.0;   ///< height of the form at the centre of the map [m]
  double slope_x = 0.0;  ///< slope of the form along x at the centre [-]
  double slope_y = 0.0;
  double rms_m = 0.0;  ///< rms of what was removed about its own mean [m]
  std::optional<Cylinder> cylinder;
  std::string text;  ///< one line for tables and files, for example "least-squares plane"
};

/// Takes the least-squares form, differences along z, of the measured points off all of them; eq-surface-form. Missing
/// points stay missing, with height 0.
/// @throws InputError for a map with too few points for the form, or a cylinder that is not there: no curvature, or one
///         so strong that the map reaches over the side of the cylinder
FormRemoved remove_form(HeightMap& map, const FormChoice& choice);

}  // namespace ringfilm::surface
