#pragma once
#include "ringfilm/models/section/polygon.hpp"

/// Sections of rings by their names in ISO 6621-1: polygons of their lengths and angles (docs/theory/ring-section.md).
namespace ringfilm::models {

/// Where a bevel or a keystone flank is.
enum class SectionSide { kChamber, kCrankcase, kBoth };

/// @param height along the axis of the bore [m] @param thickness radial [m]
SectionPolygon rectangular_section(double height, double thickness);

/// A rectangle without one of its inner corners, or both.
/// @param width of the bevel along the flank [m] @param angle of the bevel against the flank [rad]
SectionPolygon bevelled_section(double height, double thickness, double width, double angle, SectionSide side);

/// A rectangle with a step below its face, which may be tapered.
/// @param step_height along the axis [m] @param step_depth radial [m] @param taper as of tapered_section() [rad]
SectionPolygon napier_section(double height, double thickness, double step_height, double step_depth, double taper);

/// A rectangle with a face that comes nearest to the bore at its crankcase edge. @param taper angle of the face [rad]
SectionPolygon tapered_section(double height, double thickness, double taper);

/// A trapezium that becomes lower inwards. @param angle of one flank [rad]
SectionPolygon keystone_section(double height, double thickness, double angle, SectionSide side);

}  // namespace ringfilm::models
