#pragma once
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "ringfilm/models/section/polygon.hpp"

namespace ringfilm::models {

/// What makes a ring twist (docs/theory/ring-section.md).
struct TwistingRingSize {
  SectionPolygon section;       ///< a simple polygon
  double bore = 0;              ///< B [m]
  double youngs_modulus = 0;    ///< E [Pa]
  double tangential_force = 0;  ///< F_t that closes the ring [N]
  double face_width = 0;        ///< b of the running face, whose crankcase edge is where the section comes foremost [m]
  double land_clearance = 0;    ///< radial, between piston lands and bore [m]
  /// Side clearance of the ring as it is in the bore; infinite: the groove does not limit the twist [m]
  double side_clearance = std::numeric_limits<double>::infinity();
};

/// Gas pressures around a ring, absolute [Pa].
struct PressuresAroundRing {
  double above = 0, groove = 0, below = 0;
};

/// Forces on the section of a whole ring. Moments and angles are positive where they turn the face towards the chamber.
struct ForceOnRing {
  double axial = 0;   ///< towards the chamber [N]
  double moment = 0;  ///< about the centroid of the section [N m]

  ForceOnRing& operator+=(const ForceOnRing& other) {
    axial += other.axial;
    moment += other.moment;
    return *this;
  }
};

/// How the flanks hold a ring.
struct HeldTwist {
  double angle = 0;  ///< twist from the flat position, eq-section-twist [rad]
  /// Radius at which a flank would hold the ring flat, eq-section-reaction; nothing: no force presses it on one [m].
  std::optional<double> reaction_radius;
};

/// A ring whose section turns by the same angle all around: a toroid that is held by the flanks of its groove.
class TwistingRing {
 public:
  explicit TwistingRing(const TwistingRingSize& size);

  const SectionArea& area() const { return area_; }
  double centroid_radius() const { return r_c_; }  ///< r_c, of the ring in the bore [m]
  double stiffness() const { return stiffness_; }  ///< K = 2 pi E I_aa/r_c, eq-section-stiffness [N m/rad]
  /// Twist of the free section in the bore by closing the ring, eq-section-assembly-twist [rad].
  double assembly_twist() const { return assembly_twist_; }
  /// Couple per length that would hold the closed ring flat, eq-section-assembly-couple [N].
  double assembly_couple() const { return assembly_couple_; }
  double side_clearance() const { return side_clearance_; }  ///< [m]
  /// Distance of the centroid from the chamber edge of the running face, along the axis [m].
  double centroid_below_edge() const { return centroid_below_edge_; }
  double friction_arm() const { return friction_arm_; }  ///< radial, from the face to the centroid [m]

  /// What the gas presses on the section everywhere but on the running face.
  ForceOnRing gas(const PressuresAroundRing& pressures) const;
  /// Of the running face, if the pressure above reached to its middle and that below from there on [N m].
  double halved_face(const PressuresAroundRing& pressures) const;

  /// Twist under a force that the flanks must hold. @param force of gas, film, friction and inertia together
  HeldTwist held(const ForceOnRing& force) const;

 private:
  /// Which gas reaches a side of the section.
  enum class Reached { kAbove, kBelow, kGroove, kUpperFlank, kLowerFlank, kFace };
  struct Side {
    SectionPoint from, to;
    Reached reached;
  };
  struct Flank {
    double outer = 0, inner = 0;  ///< radial places from the face inwards between which the groove may hold it [m]
  };
  void lay_sides(const SectionPolygon& corners, double face_width);
  double pressure(const Side& side, double radial, const PressuresAroundRing& pressures) const;

  SectionArea area_;
  std::vector<Side> sides_;  ///< in the sense of the polygon, with the running face
  Flank upper_, lower_;
  double bore_radius_, foremost_, land_, r_c_;
  double stiffness_, assembly_twist_, assembly_couple_, side_clearance_;
  double face_begin_ = 0, face_width_, centroid_below_edge_ = 0, friction_arm_;
};

}  // namespace ringfilm::models
