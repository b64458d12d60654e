#pragma once
#include <vector>

#include "ringfilm/models/conformity/ring_beam.hpp"

namespace ringfilm::models {

/// A point of the centroid of the free ring [m]. The point opposite the gap is where the closed ring has it, at
/// (-r, 0); the gap is on the side of positive x.
struct ShapePoint {
  double x = 0;
  double y = 0;
};

/// The free ring that presses on a round bore as the beam does: points evenly spaced along it, from end to end.
/// Large deflections: the curvature of eq-closure-free-shape is integrated. @param n_points 2 or more
std::vector<ShapePoint> free_shape(const RingBeam& beam, int n_points);

/// What a measured free shape presses with.
struct FreeShapeFit {
  double tangential_force = 0;    ///< F_t [N]
  FourierSeries pressure_orders;  ///< relative to its mean
  double residual = 0;            ///< rms of what is removed: direction of the ring against that of the fit [rad]
};

/// The target pressure of a free ring by least squares of the direction of its tangent, orders 2 to `last_order`: what
/// is finer is removed. A line force needs the fourth derivative of the shape, which noise would decide.
/// @param size its tangential force is not used @param points evenly spaced along the centroid from end to end, in the
/// sense of the angle; anywhere and turned anyhow
/// Throws InputError where the points do not make a ring of this size that closes, or press inwards.
FreeShapeFit target_of_free_shape(const RingBeamSize& size, const std::vector<ShapePoint>& points, int last_order);

}  // namespace ringfilm::models
