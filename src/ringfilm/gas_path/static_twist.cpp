#include "ringfilm/gas_path/static_twist.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ringfilm::gas_path {
namespace {

using std::numbers::pi;

/// Radii of a ring of rectangular section in the bore [m].
struct Radii {
  double bore, flank, inner;  ///< radii of the face, of the outer edge of the flank in the groove, of the back
  double centroid() const { return (bore + inner) / 2; }
};

Radii radii(const Pack& pack, const Ring& ring) {
  const double bore = pack.bore / 2;
  return {bore, bore - ring.land_clearance, bore - ring.radial_thickness};
}

/// Moment of p about the centroid over the ring between two radii, where p^2 changes evenly with r. Over the pressure
/// it is a polynomial of degree 6, which Gauss with four points integrates exactly [N m].
double moment_between(const Radii& at, double inner, double outer, double p_inner, double p_outer) {
  constexpr double kInside = 0.3399810435848563, kOutside = 0.8611363115940526;
  constexpr std::array<double, 4> place = {-kOutside, -kInside, kInside, kOutside};
  constexpr std::array<double, 4> weight = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                            0.3478548451374538};
  double sum = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const double of_change = (1 + place[i]) / 2, p = p_inner + of_change * (p_outer - p_inner);
    const double r = inner + (outer - inner) * of_change * (p + p_inner) / (p_outer + p_inner);
    const double dr = (outer - inner) * 2 * p / (p_outer + p_inner);
    sum += weight[i] / 2 * p * (r - at.centroid()) * 2 * pi * r * dr;
  }
  return sum;
}

/// Moment of the gas on one flank, pressing towards the chamber; `p_edge` beyond the edge of the groove.
double flank_moment(const Radii& at, double p_groove, double p_edge) {
  return moment_between(at, at.inner, at.flank, p_groove, p_edge) +
         moment_between(at, at.flank, at.bore, p_edge, p_edge);
}

/// Twist of a ring whose section is stated, held by either flank.
StaticTwist twist_of_section(const models::TwistingRing& ring, const models::PressuresAroundRing& pressures,
                             double friction, double axial_force) {
  StaticTwist twist;
  twist.moment = ring.gas(pressures).moment + ring.halved_face(pressures) + friction * ring.friction_arm();
  const models::HeldTwist held = ring.held({axial_force, twist.moment});
  if (axial_force < 0) twist.reaction_place = held.reaction_radius;
  twist.angle = held.angle;
  return twist;
}

}  // namespace

StaticTwist static_twist(const Network& network, std::size_t index, double crank_angle, double p_above, double p_groove,
                         double p_below, double p_crankcase) {
  const Pack& pack = network.pack();
  const Ring& ring = pack.rings[index];
  const Radii at = radii(pack, ring);
  const double b = ring.face_width;
  if (ring.section) {
    return twist_of_section(*ring.section, {p_above, p_groove, p_below},
                            network.friction_on_bore(index, crank_angle, p_groove, p_crankcase),
                            network.axial_force(index, crank_angle, p_above, p_groove, p_below, p_crankcase));
  }
  StaticTwist twist;
  const double on_face = pi * pack.bore * b * b / 8 * (p_above - p_below);
  const double friction = network.friction_on_bore(index, crank_angle, p_groove, p_crankcase);
  twist.moment = flank_moment(at, p_groove, p_below) - flank_moment(at, p_groove, p_above) + on_face +
                 friction * (at.bore - at.centroid());
  const double seating = -network.axial_force(index, crank_angle, p_above, p_groove, p_below, p_crankcase);
  if (seating <= 0) return twist;
  twist.reaction_place = at.centroid() - twist.moment / seating;
  const double held = std::clamp(*twist.reaction_place, at.inner, at.flank);
  const double excess = twist.moment + seating * (held - at.centroid());
  if (held == *twist.reaction_place) return twist;
  const double inertia = ring.radial_thickness * b * b * b / 12;
  const double most = ring.side_clearance / (at.flank - at.inner);
  twist.angle = std::clamp(excess * at.centroid() / (2 * pi * ring.youngs_modulus * inertia), -most, most);
  return twist;
}

}  // namespace ringfilm::gas_path
