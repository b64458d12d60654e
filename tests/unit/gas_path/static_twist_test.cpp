#include "ringfilm/gas_path/static_twist.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pack_cases.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"

namespace ringfilm::gas_path {
namespace {

using std::numbers::pi;

constexpr double kAtmosphere = 101325;
constexpr double kUpstroke = 250 * pi / 180, kDownstroke = 100 * pi / 180;

/// Of the first ring alone, without mass.
Pack ring_pack() {
  Pack pack = two_ring_pack();
  pack.rings[0].mass = 0;
  pack.rings[0].youngs_modulus = 203e9;
  return pack;
}

// Where all pressures are that of the crankcase, friction alone presses the ring on its flank, from the bore: its arm
// about the centroid is t/2, that of the edge of the flank t/2 less the clearance of the piston land.
TEST(StaticTwist, FrictionTwistsARingByTheOverhangOfItsFlank) {
  const Pack pack = ring_pack();
  const Network network(pack);
  const Ring& ring = pack.rings[0];
  const auto twist = static_twist(network, 0, kUpstroke, kAtmosphere, kAtmosphere, kAtmosphere, kAtmosphere);
  const double friction = 0.05 * pi * pack.bore * ring.face_width * ring.elastic_pressure;
  const double centroid = (pack.bore - ring.radial_thickness) / 2;
  const double inertia = ring.radial_thickness * std::pow(ring.face_width, 3) / 12;
  const double angle = -friction * ring.land_clearance * centroid / (2 * pi * 203e9 * inertia);
  EXPECT_NEAR(twist.angle, angle, 1e-9 * std::abs(angle));  // tanh(U/U_0) is 1 to rounding
  EXPECT_NEAR(twist.reaction_place.value(), pack.bore / 2, 1e-12);
  // It lifts the ring on a downstroke.
  const auto lifted = static_twist(network, 0, kDownstroke, kAtmosphere, kAtmosphere, kAtmosphere, kAtmosphere);
  EXPECT_FALSE(lifted.reaction_place);
  EXPECT_EQ(lifted.angle, 0);
}

// The oracle adds up thin rings.
TEST(StaticTwist, MomentIsThatOfThePressuresOnFlanksAndFace) {
  Pack pack = ring_pack();
  pack.rings[0].bore_friction_coefficient = 0;
  const Network network(pack);
  const Ring& ring = pack.rings[0];
  const double above = 50e5, groove = 40e5, below = 8e5;
  const double bore = pack.bore / 2, edge = bore - ring.land_clearance, inner = bore - ring.radial_thickness;
  const double centroid = (bore + inner) / 2;
  constexpr int kRings = 100000;
  const double width = (bore - inner) / kRings;
  double moment = pi * pack.bore * ring.face_width * ring.face_width / 8 * (above - below);
  for (int i = 0; i < kRings; ++i) {
    const double r = inner + (i + 0.5) * width, share = std::min((r - inner) / (edge - inner), 1.0);
    const auto along = [&](double p_edge) {
      return std::sqrt(groove * groove + share * (p_edge * p_edge - groove * groove));
    };
    moment += (along(below) - along(above)) * (r - centroid) * 2 * pi * r * width;
  }
  const auto twist = static_twist(network, 0, kUpstroke, above, groove, below, kAtmosphere);
  EXPECT_NEAR(twist.moment, moment, 1e-6 * std::abs(moment));  // 100,000 rings
}

TEST(StaticTwist, IsReportedOfRingsWithAWidthAndAModulus) {
  Pack pack = two_ring_pack();
  EXPECT_FALSE(solve_gas_path(pack).motion[0].largest_static_twist);
  pack.rings[0].youngs_modulus = 203e9;
  const auto stiff = solve_gas_path(pack).motion;
  ASSERT_TRUE(stiff[0].largest_static_twist);
  EXPECT_FALSE(stiff[1].largest_static_twist);
  pack.rings[0].youngs_modulus = 101.5e9;
  const auto soft = solve_gas_path(pack).motion;
  EXPECT_NEAR(*soft[0].largest_static_twist, 2 * *stiff[0].largest_static_twist,
              1e-9 * std::abs(*soft[0].largest_static_twist));
  EXPECT_EQ(soft[0].twisted_share, stiff[0].twisted_share);
}

// What a ring with mass is pressed with where a seated one is asked for: inertia and friction count.
TEST(StaticTwist, SeatingForceOfASeatedRingHasItsInertia) {
  Pack pack = two_ring_pack();
  const auto result = solve_gas_path(pack);
  pack.rings[0].mass *= 1.000001;
  const auto heavier = solve_gas_path(pack);
  ASSERT_EQ(heavier.motion[0].least_seating_force_angle_deg, result.motion[0].least_seating_force_angle_deg);
  const double angle = result.motion[0].least_seating_force_angle_deg * pi / 180, r = 0.0795 / 2, l = 0.1381;
  const auto height = [&](double at) { return r * std::cos(at) + std::sqrt(l * l - std::pow(r * std::sin(at), 2)); };
  constexpr double kStep = 1e-3;
  const double curvature = (height(angle + kStep) - 2 * height(angle) + height(angle - kStep)) / (kStep * kStep);
  const double inertia = 8e-3 * 1e-6 * pack.speed * pack.speed * curvature;
  EXPECT_NEAR(heavier.motion[0].least_seating_force - result.motion[0].least_seating_force, inertia,
              1e-3 * std::abs(inertia));
}

}  // namespace
}  // namespace ringfilm::gas_path
