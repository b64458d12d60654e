#include "ringfilm/surface/friction_loop/lateral_force.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "friction_examples.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kUnknownFreedom = std::numeric_limits<double>::infinity();

LineFit exact_line(double slope, double slope_deviation = 0) {
  LineFit line;
  line.slope = slope;
  line.slope_deviation = slope_deviation;
  line.points = 8;
  line.scale = DeviationScale::kStated;
  return line;
}

TEST(SiliconCalibration, GivesTable2OfThePaperBackFromLoops) {
  // Loops of silicon at 0.05 V/V and of the three rings at zeta/0.19 times that, without noise.
  LoopPlan plan;
  plan.point_noise_V = plan.loop_noise_V = 0;
  plan.slope = 0.05;
  Normal normal(1);
  const Calibration calibration = calibrate_on_silicon(line_of_loops(plan, normal), LoadUnit::kVolt, kSiliconAhimou);
  EXPECT_NEAR(calibration.psi, 3.8, 1e-11);
  std::vector<FrictionSample> samples;
  for (const double zeta : {0.3581, 0.2565, 0.1423}) {
    plan.slope = 0.05 * zeta / 0.19;
    plan.offset_V = 0.01 * zeta;  // adhesion differs, and does not matter
    samples.push_back({"ring", line_of_loops(plan, normal), LoadUnit::kVolt});
  }
  const ShearStrengths rings = boundary_shear_strengths(samples, calibration);
  EXPECT_NEAR(rings.samples[0].zeta, 0.3581, 1e-10);
  EXPECT_NEAR(rings.samples[1].zeta, 0.2565, 1e-10);
  EXPECT_NEAR(rings.samples[2].zeta, 0.1423, 1e-10);
  // Without noise only the reference is left: 53 %, and all rings rise and fall together.
  EXPECT_NEAR(rings.samples[0].deviation() / 0.3581, 0.1 / 0.19, 1e-9);
  EXPECT_NEAR(rings.correlation(0, 2), 1, 1e-9);
}

TEST(ShearStrength, AddsItsSharesAsSquares) {
  const Calibration calibration = calibrate_on_silicon(exact_line(0.05, 0.001), LoadUnit::kVolt, kSiliconWarmack);
  const ShearStrengths rings = boundary_shear_strengths(
      {{"a", exact_line(0.1, 0.003), LoadUnit::kVolt}, {"b", exact_line(0.07, 0.002), LoadUnit::kVolt}}, calibration);
  const ShearStrength& a = rings.samples[0];
  EXPECT_NEAR(a.zeta, 0.36, 1e-15);
  EXPECT_NEAR(a.slope_deviation, 0.36 * 0.03, 1e-15);
  EXPECT_NEAR(a.calibration_deviation, 0.36 * 0.02, 1e-15);
  EXPECT_NEAR(a.reference_deviation, 0.36 / 6, 1e-15);
  const double total = 0.36 * std::sqrt(0.0009 + 0.0004 + 1.0 / 36);
  EXPECT_NEAR(a.deviation(), total, 1e-15);
  EXPECT_NEAR(rings.covariance[0], total * total, 1e-15);
  EXPECT_NEAR(rings.covariance[1], 0.36 * 0.252 * (0.0004 + 1.0 / 36), 1e-15);
  EXPECT_EQ(rings.covariance[1], rings.covariance[2]);
  EXPECT_NEAR(a.high - a.zeta, 1.959964 * total, 1e-6);
}

TEST(ShearStrength, IsNeverBelowZero) {
  const Calibration calibration = calibrate_on_silicon(exact_line(0.05), LoadUnit::kVolt, kSiliconAhimou);
  const auto rings = boundary_shear_strengths({{"a", exact_line(0.1), LoadUnit::kVolt}}, calibration);
  EXPECT_EQ(rings.samples[0].low, 0);  // 1.96 times 53 %
}

/// The whole chain, loops to zeta, with errors in load and friction and a reference that is off by its deviation.
TEST(ShearStrength, IntervalsHoldTheTruthAsOftenAsStated) {
  Normal normal(20263);
  LoopPlan plan;
  plan.load_noise = 0.02;
  plan.loop_noise_V = 0.002;
  const double zeta = 0.3, reference = 0.18, silicon_slope = 0.06;
  const int trials = 2000;
  int zetas = 0, slopes = 0, own = 0;
  for (int t = 0; t < trials; ++t) {
    plan.slope = silicon_slope;
    const LineFit silicon = line_of_loops(plan, normal);
    plan.slope = silicon_slope * zeta / reference;
    const LineFit ring = line_of_loops(plan, normal);
    slopes += std::abs(ring.slope - plan.slope) <= ring.slope_half_width(0.95);
    const Uncertain reported{reference + 0.03 * normal(), 0.03};
    const auto with_reference = boundary_shear_strengths({{"ring", ring, LoadUnit::kVolt}},
                                                         calibrate_on_silicon(silicon, LoadUnit::kVolt, reported));
    zetas += with_reference.samples[0].low <= zeta && zeta <= with_reference.samples[0].high;
    const auto without = boundary_shear_strengths({{"ring", ring, LoadUnit::kVolt}},
                                                  calibrate_on_silicon(silicon, LoadUnit::kVolt, {reference, 0}));
    own += without.samples[0].low <= zeta && zeta <= without.samples[0].high;
  }
  // One sigma of such a share is 0.5 %.
  for (const int held : {zetas, slopes, own}) {
    EXPECT_GT(held, 0.93 * trials);
    EXPECT_LT(held, 0.97 * trials);
  }
}

Lever lever() {
  Lever l;
  l.shape = LeverShape::kRectangular;
  l.length_m = {450e-6, 5e-6};
  l.tip_height_m = {15e-6, 1e-6};
  l.poissons_ratio = {0.22, 0.02};
  l.youngs_modulus_Pa = {169e9, 5e9};
  l.width_m = {50e-6, 1e-6};
  l.thickness_m = {2e-6, 0.1e-6};
  l.torsional_sensitivity_V_per_m = {2e7, 1e5};
  return l;
}

TEST(LeverCalibration, FollowsAppendixA) {
  const Lever l = lever();
  const double k_N = 169e9 * 50e-6 * 8e-18 / (4 * std::pow(450e-6, 3));
  const double k_T = 169e9 / 2.44 * 50e-6 * 8e-18 / (3 * 450e-6 * 15e-6 * 15e-6);
  EXPECT_NEAR(normal_stiffness(l), k_N, 1e-12 * k_N);
  EXPECT_NEAR(torsional_stiffness(l), k_T, 1e-12 * k_T);
  // A-5 and its short form A-9 are one.
  const Calibration volts = calibrate_by_geometry(l, LoadUnit::kVolt);
  EXPECT_NEAR(volts.psi, 1.5 * 15.0 / 450 * k_T / k_N, 1e-12 * volts.psi);
  EXPECT_NEAR(volts.psi, 450.0 / 15 / 1.22, 1e-12 * volts.psi);
  EXPECT_NEAR(volts.deviation() / volts.psi,
              std::sqrt(std::pow(5.0 / 450, 2) + std::pow(1.0 / 15, 2) + std::pow(0.02 / 1.22, 2)), 1e-12);
  // A-2 with the load in newtons; the thickness counts threefold.
  const Calibration newtons = calibrate_by_geometry(l, LoadUnit::kNewton);
  EXPECT_NEAR(newtons.psi, 1.5 * 15.0 / 450 * k_T / 2e7, 1e-12 * newtons.psi);
  EXPECT_GT(newtons.deviation() / newtons.psi, 3 * 0.05);
}

TEST(LeverCalibration, RefusesVShapedLevers) {
  Lever l = lever();
  l.shape = LeverShape::kVShaped;
  for (const LoadUnit unit : {LoadUnit::kVolt, LoadUnit::kNewton}) {
    try {
      calibrate_by_geometry(l, unit);
      FAIL() << "was calibrated";
    } catch (const InputError& error) {
      EXPECT_NE(error.faults().front().message.find("V-shaped"), std::string::npos);
      EXPECT_NE(error.faults().front().remedy.find("silicon"), std::string::npos);
    }
  }
  EXPECT_THROW(normal_stiffness(l), InputError);
  EXPECT_THROW(torsional_stiffness(l), InputError);
  l = lever();
  l.tip_height_m.value = 0;
  EXPECT_THROW(calibrate_by_geometry(l, LoadUnit::kVolt), InputError);
}

/// Lateral force on a slope from the balance of forces on the tip alone, moving up (+1) or down (-1): the reaction
/// R = L cos + T sin + A, and T cos = L sin + direction mu R; solved by elimination.
double lateral_force(double load, double adhesion, double angle, double mu, int direction) {
  const double s = std::sin(angle), c = std::cos(angle), f = direction * mu;
  return (load * (s + f * c) + f * adhesion) / (c - f * s);
}

WedgeFacet facet(double angle, double mu, double alpha, double adhesion, double cross_talk) {
  std::vector<LinePoint> widths, offsets;
  for (int i = 1; i <= 6; ++i) {
    const double load = 10e-9 * i;
    const double up = lateral_force(load, adhesion, angle, mu, 1) / alpha;
    const double down = lateral_force(load, adhesion, angle, mu, -1) / alpha;
    widths.push_back({load, (up - down) / 2, 0, 1e-4});
    offsets.push_back({load, (up + down) / 2 + 0.2 + cross_talk * load, 0, 1e-4});
  }
  return {{angle, 0.01}, fit_line(widths, DeviationScale::kStated), fit_line(offsets, DeviationScale::kStated)};
}

TEST(WedgeCalibration, FindsFactorAndFrictionFromTheBalanceOfForces) {
  for (const auto& [first, second] :
       std::vector<std::pair<double, double>>{{0.9547, -0.9547}, {0.9547, 0.0}, {0.2443, -0.2182}}) {
    for (const double mu : {0.1, 0.4, 0.65}) {
      if (mu > 0.95 / std::tan(first)) continue;
      const double alpha = 60e-9;  // [N/V]
      const WedgeFacet up = facet(first, mu, alpha, 5e-9, 3e5), down = facet(second, mu, alpha, 5e-9, 3e5);
      const WedgeCalibration wedge = calibrate_on_wedge(up, down, LoadUnit::kNewton);
      EXPECT_NEAR(wedge.calibration.psi, alpha, 1e-9 * alpha) << first << " " << mu;
      EXPECT_NEAR(wedge.friction_coefficient.value, mu, 1e-9);
      EXPECT_NEAR(wedge.width_mismatch, 0, 1e-9);
      EXPECT_GT(wedge.calibration.measurement_deviation, 0);
      EXPECT_GT(wedge.calibration.reference_deviation, 0);
      // Which facet comes first does not matter.
      EXPECT_NEAR(calibrate_on_wedge(down, up, LoadUnit::kNewton).calibration.psi, wedge.calibration.psi,
                  1e-12 * alpha);
    }
  }
}

TEST(WedgeCalibration, SeparatesItsErrorFromThatOfTheLines) {
  Normal normal(9);
  const double alpha = 60e-9, mu = 0.3, noise = 2e-3;
  double squares = 0, reported = 0;
  const int n = 400;
  for (int t = 0; t < n; ++t) {
    WedgeFacet facets[2];
    const double angles[2] = {0.6, -0.6};
    for (int k = 0; k < 2; ++k) {
      facets[k] = facet(angles[k], mu, alpha, 5e-9, 0);
      facets[k].angle_rad.deviation = 0;
      for (LineFit* line : {&facets[k].half_width, &facets[k].offset}) {
        const double deviation = line->slope_deviation * noise / 1e-4;
        line->slope += deviation * normal();
        line->slope_deviation = deviation;
      }
    }
    const WedgeCalibration wedge = calibrate_on_wedge(facets[0], facets[1], LoadUnit::kNewton);
    squares += std::pow(wedge.calibration.psi - alpha, 2) / n;
    reported += wedge.calibration.deviation() / n;
  }
  // The scatter of 400 is known to 3.5 %; 4 sigma allowed.
  EXPECT_NEAR(reported / std::sqrt(squares), 1, 0.15);
}

TEST(WedgeCalibration, RefusesFacetsThatDoNotFit) {
  const WedgeFacet up = facet(0.6, 0.3, 1, 0, 0), down = facet(-0.6, 0.3, 1, 0, 0);
  EXPECT_THROW(calibrate_on_wedge(up, up, LoadUnit::kNewton), InputError);
  WedgeFacet wrong = up, other = down;
  std::swap(wrong.angle_rad, other.angle_rad);
  EXPECT_THROW(calibrate_on_wedge(wrong, other, LoadUnit::kNewton), InputError);
}

TEST(ShearStrength, RefusesUnitsAndSlopesThatDoNotFit) {
  const Calibration calibration = calibrate_on_silicon(exact_line(0.05), LoadUnit::kVolt, kSiliconAhimou);
  EXPECT_THROW(boundary_shear_strengths({{"a", exact_line(0.1), LoadUnit::kNewton}}, calibration), InputError);
  EXPECT_THROW(boundary_shear_strengths({{"a", exact_line(-0.1), LoadUnit::kVolt}}, calibration), InputError);
  EXPECT_THROW(boundary_shear_strengths({{"a", exact_line(0.05), LoadUnit::kVolt}}, calibration), InputError);
  EXPECT_THROW(calibrate_on_silicon(exact_line(-0.05), LoadUnit::kVolt, kSiliconAhimou), InputError);
  EXPECT_THROW(calibrate_on_silicon(exact_line(0.05), LoadUnit::kVolt, {0, 0.1}), InputError);
  EXPECT_EQ(calibration.degrees_of_freedom, kUnknownFreedom);
}

}  // namespace
}  // namespace ringfilm::surface
