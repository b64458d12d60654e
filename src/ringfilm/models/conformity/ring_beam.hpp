#pragma once
#include <optional>

#include "ringfilm/models/conformity/fourier_series.hpp"

namespace ringfilm::models {

/// What makes a ring a beam (docs/theory/conformity.md).
struct RingBeamSize {
  double bore = 0;              ///< nominal, B [m]
  double face_width = 0;        ///< h, along the cylinder's axis [m]
  double radial_thickness = 0;  ///< t [m]
  double youngs_modulus = 0;    ///< E [Pa]
  double tangential_force = 0;  ///< F_t = p h B/2 with the mean p of the target pressure [N]
  double end_gap = 0;           ///< g, between the ends of the closed ring, along its centroid [m]
  // of a section that is not a rectangle of h and t
  std::optional<double> section_centroid = {};       ///< radial distance of its centroid from the face [m]
  std::optional<double> section_second_moment = {};  ///< second moment for bending in the ring's plane [m4]

  /// Radial distance of the centroid from the face [m].
  double centroid_depth() const { return section_centroid.value_or(radial_thickness / 2); }
  double centroid_radius() const { return bore / 2 - centroid_depth(); }  ///< r of the closed ring [m]
};

/// A thin curved beam with a gap, whose free shape makes it press on a round bore as stated.
/// Angles phi [rad] count from the middle of the gap, from half_gap() to 2 pi - half_gap().
class RingBeam {
 public:
  /// @param pressure_orders of the target pressure relative to its mean, order 2 or higher. Throws InputError where
  /// the section, the gap or an order is impossible.
  RingBeam(const RingBeamSize& size, const FourierSeries& pressure_orders);

  const RingBeamSize& size() const { return size_; }
  double centroid_radius() const { return r_; }  ///< r, B/2 - t/2 of a rectangle [m]
  double second_moment() const;                  ///< I, h t^3/12 of a rectangle [m4]
  double stiffness() const { return k_; }        ///< k = E I/r^2, moment a change of shape u + u'' [N]
  double half_gap() const { return half_gap_; }  ///< g/(2 r) [rad]

  /// Force of the round wall on the closed ring, eq-closure-target [N/rad].
  const FourierSeries& target_force() const { return force_; }
  /// Bending moment of that force, closing positive, eq-closure-moment [N m]. At both ends it and its slope are zero.
  double target_moment(double phi) const;
  double target_moment_slope(double phi) const;  ///< over phi [N m/rad]
  /// Size of the term of order 1 that balances the target force on a ring with a gap, over F_t [-].
  double projection() const { return projection_; }

 private:
  struct Response {
    double value;
    double slope;
  };
  static Response response(const FourierOrder& force, double start, double phi);
  Response response(double phi) const;

  RingBeamSize size_;
  double r_, k_, half_gap_;
  FourierSeries force_;
  double projection_ = 0;
};

}  // namespace ringfilm::models
