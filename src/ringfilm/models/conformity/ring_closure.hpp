#pragma once
#include <memory>
#include <vector>

#include "ringfilm/models/conformity/lift_off.hpp"

namespace ringfilm::models {

/// A part of the ring that touches the wall, or a point of it (from = to).
struct ContactArc {
  double from = 0;  ///< [rad]
  double to = 0;    ///< [rad]
};

/// A force of the wall in one point, at the edge of a contact arc or where the ring touches in a point.
struct PointForce {
  double phi = 0;    ///< [rad]
  double force = 0;  ///< inwards [N]
};

/// Where a ring touches a rigid wall, and with which force (docs/theory/conformity.md): no clearance is negative, the
/// wall never pulls, and there is force only where there is contact. Angles phi [rad] count from the middle of the gap.
class RingClosure {
 public:
  /// Throws ConvergenceError where no set of contact arcs meets all conditions.
  explicit RingClosure(const RingAtWall& ring);

  const RingAtWall& ring() const { return *ring_; }                        ///< as given
  const std::vector<ContactArc>& arcs() const { return arcs_; }            ///< with a length, in order of phi
  const std::vector<ContactArc>& points() const { return points_; }        ///< where the ring touches without one
  const std::vector<PointForce>& point_forces() const { return forces_; }  ///< in order of phi
  const std::vector<LiftOff>& lift_offs() const { return lift_offs_; }     ///< the parts between them

  LiftOff::Extreme largest_clearance() const;  ///< [m]; zero at the start of the ring where all of it touches
  double clearance_integral() const;           ///< over phi [m rad]
  double contact_angle() const;                ///< sum of the angles of all contact arcs [rad]

  double clearance(double phi) const;   ///< [m]
  double line_force(double phi) const;  ///< force of the wall without the point forces [N/rad]
  double moment(double phi) const;      ///< closing positive [N m]
  /// Force of the wall from the start of the ring up to phi, a point force at phi counted [N].
  double force_up_to(double phi) const;
  double force_in_points() const;  ///< [N]
  double force() const;            ///< total force of the wall [N]
  /// Resultant of wall and gas over the tangential force: zero but for rounding [-].
  double unbalanced_share() const;

 private:
  const LiftOff* lift_off_at(double phi) const;
  double line_force_between(double from, double to) const;

  std::shared_ptr<const RingAtWall> ring_;
  std::vector<ContactArc> arcs_, points_;
  std::vector<PointForce> forces_;
  std::vector<LiftOff> lift_offs_;
};

}  // namespace ringfilm::models
