#pragma once
#include <vector>

#include "ringfilm/models/conformity/ring_beam.hpp"

namespace ringfilm::models {

/// A point of the running surface of a free ring [m].
struct ShapePoint {
  double x = 0;  ///< towards the gap [m]
  double y = 0;  ///< across it [m]
};

/// The free ring that presses on a round bore as the beam does: its running surface, half a thickness outside of the
/// centroid, whose curvature is that of eq-closure-free-shape. Deflections may be large. The point opposite the gap is
/// where the closed ring has it, at (-bore/2, 0); the gap is on the side of positive x.
/// @param phi places on the ring, rising [rad]
std::vector<ShapePoint> free_shape(const RingBeam& beam, const std::vector<double>& phi);

/// The target pressure of a measured free ring, eq-closure-measured-shape.
struct FreeShapeFit {
  double tangential_force = 0;    ///< F_t [N]
  FourierSeries pressure_orders;  ///< relative to its mean
  double residual = 0;            ///< rms distance of the points from the shape of this target: what is removed [m]
  /// Standard deviation of F_t, and of the orders of the pressure together as their rms around the ring, where the
  /// points scatter about that shape independently of each other; relative to F_t [-].
  double force_deviation = 0;
  double pressure_deviation = 0;  ///< standard deviation of the orders of the pressure, relative to F_t [-]
};

/// The fewest points that a shape may have for each wave of its highest order: noise is averaged over them.
inline constexpr int kPointsOfWave = 4;

/// The target of orders 2 to `last_order` whose free ring is nearest to the points, by least squares of their
/// distances. What is finer is removed: a line force needs the fourth derivative of the shape, which noise would
/// decide.
/// @param size its tangential force is not used @param points of the running surface from end to end, in the sense of
/// the angle; anywhere and turned anyhow
/// Throws InputError where the points do not make a ring of this size that closes, are too few, or press inwards.
FreeShapeFit target_of_free_shape(const RingBeamSize& size, const std::vector<ShapePoint>& points, int last_order);

}  // namespace ringfilm::models
