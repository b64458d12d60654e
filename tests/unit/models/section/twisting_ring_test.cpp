#include "ringfilm/models/section/twisting_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ringfilm/models/section/section_forms.hpp"

namespace ringfilm::models {
namespace {

using std::numbers::pi;

constexpr double kBore = 0.089, kModulus = 203e9, kForce = 10.7, kHeight = 1.2e-3, kThickness = 3.5e-3;
constexpr double kLand = 0.3e-3;

TwistingRing ring_of(const SectionPolygon& section, double side_clearance = 60e-6) {
  return TwistingRing({section, kBore, kModulus, kForce, kHeight, kLand, side_clearance});
}

SectionPolygon bevel(SectionSide side) { return bevelled_section(kHeight, kThickness, 6e-4, pi / 4, side); }

TEST(TwistingRing, BevelTowardsTheChamberTwistsTheFaceTowardsTheChamber) {
  EXPECT_NEAR(ring_of(bevel(SectionSide::kChamber)).assembly_twist(), 6.2010735e-3, 1e-9);  // reference.py
  EXPECT_NEAR(ring_of(bevel(SectionSide::kCrankcase)).assembly_twist(), -6.2010735e-3, 1e-9);
  EXPECT_EQ(ring_of(rectangular_section(kHeight, kThickness)).assembly_twist(), 0);
}

TEST(TwistingRing, CoupleOfAssemblyUndoesItsTwist) {
  // Held flat the ring keeps the curvature of the bore, which the couple does not change: to the coupling, small here.
  const TwistingRing ring = ring_of(bevel(SectionSide::kChamber));
  const double undone = 2 * pi * ring.centroid_radius() * ring.assembly_couple() / ring.stiffness();
  const SectionArea& of = ring.area();
  const double coupling = 1 - of.product * of.product / (of.axial * of.radial);
  EXPECT_NEAR(undone, coupling * ring.assembly_twist(), 1e-9 * undone);
}

TEST(TwistingRing, EvenPressureAllAroundNeitherMovesNorTurnsTheRing) {
  for (const SectionPolygon& section : {rectangular_section(kHeight, kThickness), bevel(SectionSide::kChamber)}) {
    const TwistingRing ring = ring_of(section);
    const PressuresAroundRing even{50e5, 50e5, 50e5};
    const ForceOnRing gas = ring.gas(even);
    EXPECT_NEAR(gas.axial, 0, 1e-8);
    EXPECT_NEAR(gas.moment + ring.halved_face(even), 0, 1e-10);
  }
}

TEST(TwistingRing, GasOnARectangleIsThatOfItsFlanks) {
  const TwistingRing ring = ring_of(rectangular_section(kHeight, kThickness));
  const double above = 50e5, groove = 40e5, below = 8e5;
  const double bore = kBore / 2, edge = bore - kLand, inner = bore - kThickness;
  double axial = 0, moment = 0;
  constexpr int kRings = 200000;
  const double width = (bore - inner) / kRings;
  for (int i = 0; i < kRings; ++i) {
    const double r = inner + (i + 0.5) * width, share = std::min((r - inner) / (edge - inner), 1.0);
    const auto p = [&](double at_edge) {
      return std::sqrt(groove * groove + share * (at_edge * at_edge - groove * groove));
    };
    const double force = (p(below) - p(above)) * 2 * pi * r * width;
    axial += force;
    moment += force * (r - ring.centroid_radius());
  }
  const ForceOnRing gas = ring.gas({above, groove, below});
  EXPECT_NEAR(gas.axial, axial, 1e-6 * std::abs(axial));
  EXPECT_NEAR(gas.moment, moment, 1e-5 * std::abs(moment));
}

TEST(TwistingRing, FlankHoldsItFlatAsLongAsItReaches) {
  const TwistingRing ring = ring_of(rectangular_section(kHeight, kThickness));
  const double outer = kBore / 2 - kLand, inner = kBore / 2 - kThickness, seating = 500;
  const auto held = [&](double radius) { return ring.held({-seating, seating * (ring.centroid_radius() - radius)}); };
  EXPECT_EQ(held(outer - 1e-6).angle, 0);
  EXPECT_NEAR(held(outer - 1e-6).reaction_radius.value(), outer - 1e-6, 1e-12);
  EXPECT_EQ(held(inner + 1e-6).angle, 0);
  // Beyond its end the rest of the moment turns it, outwards towards the crankcase.
  EXPECT_NEAR(held(outer + 1e-4).angle, -seating * 1e-4 / ring.stiffness(), 1e-9);
  EXPECT_NEAR(held(inner - 1e-4).angle, seating * 1e-4 / ring.stiffness(), 1e-9);
  // Upwards it is held by the other flank.
  EXPECT_EQ(ring.held({seating, 0}).angle, 0);
  // Where nothing presses it, it has the twist of its moment, as far as the groove lets it.
  EXPECT_NEAR(ring.held({0, 1e-3}).angle, 1e-3 / ring.stiffness(), 1e-12);
  EXPECT_NEAR(ring.held({0, 10}).angle, 60e-6 / (outer - inner), 1e-12);
}

TEST(TwistingRing, FreeRingHasItsAssemblyTwist) {
  const TwistingRing ring = ring_of(bevel(SectionSide::kChamber), 1);
  EXPECT_NEAR(ring.held({0, 0}).angle, ring.assembly_twist(), 1e-12);
}

TEST(TwistingRing, RunningFaceOfANapierRingEndsAtItsStep) {
  const TwistingRing ring({napier_section(1.5e-3, kThickness, 4e-4, 5e-4, 0.02), kBore, kModulus, kForce, 1.1e-3});
  EXPECT_NEAR(ring.centroid_below_edge(), ring.area().centroid.axial, 1e-12);
}

}  // namespace
}  // namespace ringfilm::models
