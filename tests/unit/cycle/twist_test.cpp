#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/cycle/setup/ring_section.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "styles_case.hpp"

/// A ring whose face turns with its section.
namespace ringfilm::cycle::testing {
namespace {

Case ring_with_bevel(models::SectionSide side) {
  Case c = styles_new_ring();
  c.film.cavitation = Cavitation::kMassConserving;
  c.solver.crank_step_control = StepControl::kAdaptive;
  c.ring.face = {};
  c.ring.face.form = FaceForm::kParabola;
  c.ring.face.crown_height = 10e-6;
  c.ring.radial_thickness = 3.5e-3;
  c.ring.gas_path.land_clearance = 0.3e-3;
  c.ring.gas_path.side_clearance = 60e-6;
  c.ring.gas_path.density = 7200;
  c.ring.section.form = SectionForm::kInnerBevel;
  c.ring.section.bevel_width = 0.6e-3;
  c.ring.section.bevel_side = side;
  return c;
}

double largest(const CycleResult& result) {
  double most = 0;
  for (const Sample& s : result.samples) most = std::max(most, s.twist);
  return most;
}

double least(const CycleResult& result) {
  double low = 0;
  for (const Sample& s : result.samples) low = std::min(low, s.twist);
  return low;
}

TEST(RingTwist, BevelsTurnTheFaceTheirWay) {
  const CycleResult up = simulate(prepare(ring_with_bevel(models::SectionSide::kChamber)));
  const CycleResult down = simulate(prepare(ring_with_bevel(models::SectionSide::kCrankcase)));
  EXPECT_TRUE(up.complete);
  EXPECT_TRUE(down.complete);
  EXPECT_GT(largest(up), -least(up));
  EXPECT_GT(-least(down), largest(down));
  // No farther than the groove lets it.
  for (const CycleResult* result : {&up, &down}) {
    EXPECT_LE(std::max(largest(*result), -least(*result)), 60e-6 / (3.5e-3 - 0.3e-3) * (1 + 1e-6));
  }
}

TEST(RingTwist, WithoutTwistASectionChangesNothing) {
  Case plain = ring_with_bevel(models::SectionSide::kChamber), with = plain;
  plain.ring.section = {};
  with.ring.section.twist = RingTwist::kNone;
  const CycleResult a = simulate(prepare(plain)), b = simulate(prepare(with));
  EXPECT_EQ(a.values.fmep, b.values.fmep);
  EXPECT_EQ(a.values.min_film_thickness, b.values.min_film_thickness);
  EXPECT_EQ(largest(b), 0);
}

TEST(RingTwist, SideClearanceOfAKeystoneGrowsOutwards) {
  Case c = ring_with_bevel(models::SectionSide::kChamber);
  c.ring.section = {};
  c.ring.section.form = SectionForm::kKeystone;
  c.ring.section.keystone_angle_deg = 15;
  EXPECT_NEAR(side_clearance(c.ring).value(), 60e-6, 1e-15);
  c.ring.section.clearance_protrusion = 0.1e-3;
  EXPECT_NEAR(side_clearance(c.ring).value(), 60e-6 + 0.2e-3 * 2 * std::tan(7.5 * std::acos(-1.0) / 180), 1e-12);
  c.ring.gas_path.side_clearance.reset();
  c.ring.section.clearance_protrusion.reset();
  c.ring.section.groove_height = 1.25e-3;
  EXPECT_NEAR(side_clearance(c.ring).value(), 50e-6, 1e-12);
}

/// Does a rule of that key refuse the case?
bool is_refused(const Case& c, const char* key, const char* words) {
  for (const RuleBreach& breach : broken_rules(c)) {
    if (breach.key == key && breach.message.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(RingTwist, WrongSectionsAreRefused) {
  Case c = ring_with_bevel(models::SectionSide::kChamber);
  c.ring.section.bevel_width = 4e-3;
  EXPECT_TRUE(is_refused(c, "ring.bevel_width", "radial thickness"));
  c.ring.section.bevel_width = 0.6e-3;
  c.ring.section.groove_height = 1.1e-3;
  EXPECT_TRUE(is_refused(c, "ring.groove_height", "wider than its groove"));
  c.ring.section = {};
  c.ring.section.corners = {{0, 0}, {1.2e-3, 3.5e-3}, {1.2e-3, 0}, {0, 3.5e-3}};
  EXPECT_TRUE(is_refused(c, "ring.section", "overlaps itself"));
  c.ring.section.corners = {{0, 0}, {1.2e-3, 0}, {0.6e-3, 0}};
  EXPECT_TRUE(is_refused(c, "ring.section", "no area"));
  c.ring.section.corners = {{0, 0}, {3.5e-3, 0}, {3.5e-3, 1.2e-3}, {0, 1.2e-3}};  // radial first
  EXPECT_TRUE(is_refused(c, "ring.radial_thickness", "is not that of ring.section"));
}

}  // namespace
}  // namespace ringfilm::cycle::testing
