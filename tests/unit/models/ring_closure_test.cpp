#include "ringfilm/models/conformity/ring_closure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "../../traps/floating_point_traps.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/models/conformity/contact_guess.hpp"
#include "ringfilm/models/conformity/free_shape.hpp"

namespace {

using ringfilm::InputError;
using namespace ringfilm::models;
using std::numbers::pi;

/// The ring of the theory page: F_t = p h B/2 of 0.2 MPa.
RingBeamSize paper_ring(double end_gap) { return {89e-3, 1.2e-3, 3.5e-3, 203e9, 10.68, end_gap}; }

RingClosure closed(const std::vector<FourierOrder>& bore, double end_gap = 0.35e-3, double gas = 0,
                   const std::vector<FourierOrder>& pressure = {}) {
  return RingClosure({RingBeam(paper_ring(end_gap), FourierSeries(pressure)), FourierSeries(bore), gas});
}

double closed_order(int n) {
  const RingBeam beam(paper_ring(0), {});
  return beam.size().tangential_force * beam.centroid_radius() / beam.stiffness() / std::pow(n * n - 1, 2);
}

TEST(RingBeam, TargetMomentIsThatOfUniformPressure) {
  const RingBeam beam(paper_ring(0), {});
  for (const double phi : {0.3, 1.0, pi, 5.0}) {
    EXPECT_NEAR(beam.target_moment(phi), beam.centroid_radius() * 10.68 * (1 - std::cos(phi)), 1e-14);
  }
}

TEST(RingBeam, TargetForceIsInBalanceWhateverItsOrders) {
  const FourierSeries orders({{2, 0.25, 0.1}, {3, -0.2, 1}, {7, 0.4, 0.3}});
  const RingBeam beam(paper_ring(0.8e-3), orders);
  const double end = 2 * pi - beam.half_gap(), scale = 10.68 * beam.centroid_radius();
  EXPECT_NEAR(beam.target_moment(end), 0, 1e-12 * scale);
  EXPECT_NEAR(beam.target_moment_slope(end), 0, 1e-12 * scale);
}

TEST(RingBeam, ProjectionIsThatOfTheMissingPressure) {
  const RingBeam beam(paper_ring(0.35e-3), {});
  // The missing cosine has its resultant on the ring alone, without the gap: 0.26 % of a share of 0.26 %.
  EXPECT_NEAR(beam.projection(), 2 * std::sin(beam.half_gap()) / pi, 3e-3 * beam.projection());
}

TEST(RingBeam, OrdersThatTheRingClosesAreThePublishedOnes) {
  EXPECT_NEAR(closed_order(2), 106.5e-6, 0.05e-6);  // four digits
  EXPECT_NEAR(closed_order(3), 14.98e-6, 0.005e-6);
  EXPECT_NEAR(closed_order(4), 4.26e-6, 0.005e-6);
}

TEST(RingBeam, ImpossibleRingsAreRefused) {
  RingBeamSize size = paper_ring(0);
  size.radial_thickness = -1e-3;
  EXPECT_THROW(RingBeam(size, {}), InputError);
  size = paper_ring(0.2);
  EXPECT_THROW(RingBeam(size, {}), InputError);
  size = paper_ring(0);
  const ringfilm::traps::NoTraps a_nan_is_compared;
  size.youngs_modulus = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(RingBeam(size, {}), InputError);
  EXPECT_THROW(RingBeam(paper_ring(0), FourierSeries({{1, 0.1, 0}})), InputError);
}

TEST(RingClosure, ARoundBoreIsTouchedAllAround) {
  for (const auto& bore : {std::vector<FourierOrder>{}, {{1, 20e-6, 0.4}}}) {
    for (const double gas : {0.0, 500.0}) {
      const RingClosure closure = closed(bore, 0.35e-3, gas);
      ASSERT_EQ(closure.arcs().size(), 1u);
      EXPECT_EQ(closure.largest_clearance().clearance, 0);
      EXPECT_NEAR(closure.contact_angle(), 2 * (pi - closure.ring().start()), 1e-12);
      EXPECT_LT(closure.force_in_points(), 1e-9);
    }
  }
}

TEST(RingClosure, LiftedTipsEndWhereTheMomentOfTheBoreIsThatOfAFreeEnd) {
  const double a = 1e-6;
  const RingClosure closure = closed({{4, a, pi / 4}}, 0);
  const RingBeam& beam = closure.ring().beam();
  ASSERT_EQ(closure.arcs().size(), 1u);
  const double l = closure.arcs().front().from;
  EXPECT_NEAR(10.68 * beam.centroid_radius() * (1 - std::cos(l)), 15 * beam.stiffness() * a * std::cos(4 * l), 1e-12);
  EXPECT_NEAR(closure.arcs().front().to, 2 * pi - l, 1e-10);
}

TEST(RingClosure, AnOrderIsClosedUpToItsAmplitudeAndNotBeyond) {
  for (const int n : {2, 3, 4, 5, 6}) {
    const double crest = pi / n;  // the gap is in a valley
    EXPECT_EQ(closed({{n, 0.98 * closed_order(n), crest}}, 0).lift_offs().size(), 2u) << n;
    EXPECT_GT(closed({{n, 1.02 * closed_order(n), crest}}, 0).lift_offs().size(), 2u) << n;
  }
}

TEST(RingClosure, GasPressesTheRingOnTheBore) {
  double before = 1;
  for (const double gas : {0.0, 5.0, 50.0, 500.0}) {
    const double clearance = closed({{4, 8e-6, 0}}, 0.35e-3, gas).largest_clearance().clearance;
    EXPECT_LT(clearance, before);
    before = clearance;
  }
}

TEST(RingClosure, ForceJumpsByThePointForcesAndSumsUpToAll) {
  const RingClosure closure = closed({{2, 15e-6, 0}, {3, 5e-6, 0}, {4, 2e-6, 0}});
  EXPECT_NEAR(closure.force_up_to(2 * pi), closure.force(), 1e-12);
  for (const PointForce& one : closure.point_forces()) {
    const double jump = closure.force_up_to(one.phi) - closure.force_up_to(one.phi - 1e-9);
    EXPECT_NEAR(jump, one.force, 1e-6);
  }
}

/// Distorted bores and rings of all kinds: from hardly out of round to contact in points alone.
TEST(RingClosure, AllConditionsOfContactHoldInRandomBores) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 60; ++i) {
    const double scale = std::pow(10, -7.5 + 3.5 * share(random));
    std::vector<FourierOrder> bore, pressure;
    for (int k = 0; k < 3; ++k) {
      const int n = 1 + static_cast<int>(7 * share(random));
      bore.push_back({n, scale * (share(random) - 0.3) * 40 / std::pow(n, 3), 2 * pi * share(random)});
    }
    if (i % 2 == 0) pressure.push_back({2, 0.8 * (share(random) - 0.5), share(random)});
    const double gas = i % 3 == 0 ? 0 : std::pow(10, 3 * share(random));
    const RingClosure closure = closed(bore, i % 5 == 0 ? 0 : 0.4e-3, gas, pressure);
    EXPECT_LT(closure.unbalanced_share() * 10.68, 1e-8 * (10.68 + gas)) << i;
    const double largest = closure.largest_clearance().clearance;
    for (const LiftOff& span : closure.lift_offs()) EXPECT_GE(span.smallest().clearance, -1e-7 * largest) << i;
    for (const PointForce& one : closure.point_forces()) EXPECT_GT(one.force, 0) << i;
    for (const ContactArc& arc : closure.arcs()) {
      for (int k = 0; k <= 20; ++k) {
        EXPECT_GE(closure.line_force(arc.from + (arc.to - arc.from) * k / 20), -1e-6 * (10.68 + gas)) << i;
      }
    }
  }
}

TEST(RingClosure, AgreesWithTheQuadraticProgrammeOnAGrid) {
  const RingClosure closure = closed({{2, 15e-6, 0}, {3, 5e-6, 0}, {4, 2e-6, 0}});
  const int n = 1440;
  const std::vector<bool> touches = contact_on_grid(closure.ring(), n);
  const double step = 2 * (pi - closure.ring().start()) / n;
  // Away from the edges, beside which single points of a grid come off, both agree.
  for (int i = 0; i <= n; ++i) {
    const double phi = closure.ring().start() + i * step;
    const ContactArc& arc = closure.arcs().front();
    const std::size_t k = static_cast<std::size_t>(i);
    if (phi > arc.from + 6 * step && phi < arc.to - 6 * step) {
      EXPECT_TRUE(touches[k]) << i;
    }
    if ((phi > 6 * step && phi < arc.from - 6 * step) || (phi > arc.to + 6 * step && phi < 2 * pi - 6 * step)) {
      EXPECT_FALSE(touches[k]) << i;
    }
  }
}

/// Places from end to end of a ring, evenly spaced.
std::vector<double> places_on(const RingBeam& beam, int n) {
  std::vector<double> phi;
  for (int i = 0; i < n; ++i) phi.push_back(beam.half_gap() + 2 * (pi - beam.half_gap()) * i / (n - 1));
  return phi;
}

TEST(FreeShape, GivesBackThePressureThatItWasMadeFor) {
  const FourierSeries orders({{2, 0.25, 0.3}, {5, 0.1, 0.2}});
  const RingBeam beam(paper_ring(0.35e-3), orders);
  for (const int n : {91, 361, 1000}) {
    std::vector<ShapePoint> points = free_shape(beam, places_on(beam, n));
    ASSERT_EQ(static_cast<int>(points.size()), n);
    const FreeShapeFit fit = target_of_free_shape(paper_ring(0.35e-3), points, 8);
    EXPECT_NEAR(fit.tangential_force, 10.68, 1e-4 * 10.68) << n;  // lengths are measured by chords: h^4
    for (const double phi : {0.5, 2.0, 4.0}) EXPECT_NEAR(fit.pressure_orders(phi), orders(phi), 1e-3) << n;
    EXPECT_LT(fit.residual, 1e-8) << n;
    // Anywhere in the plane it is the same ring.
    for (ShapePoint& point : points) point = {0.1 - point.y, 0.2 + point.x};
    EXPECT_NEAR(target_of_free_shape(paper_ring(0.35e-3), points, 8).tangential_force, fit.tangential_force, 1e-9);
  }
}

/// 0.1 um of noise: what it does to the pressure is what the fit states, and grows with the orders.
TEST(FreeShape, NoiseChangesThePressureByAsMuchAsIsStated) {
  const RingBeam beam(paper_ring(0.35e-3), {});
  const std::vector<ShapePoint> exact = free_shape(beam, places_on(beam, 361));
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.1e-6);
  double before = 0;
  for (const int last_order : {4, 8, 16}) {
    double force = 0, pressure = 0, stated_force = 0, stated_pressure = 0;
    constexpr int kTimes = 40;
    for (int time = 0; time < kTimes; ++time) {
      std::vector<ShapePoint> points = exact;
      for (ShapePoint& point : points) {
        const double more = 1 + noise(random) / std::hypot(point.x, point.y);
        point = {point.x * more, point.y * more};
      }
      const FreeShapeFit fit = target_of_free_shape(paper_ring(0.35e-3), points, last_order);
      EXPECT_NEAR(fit.residual, 0.1e-6, 0.02e-6);  // 361 values: 4 %
      force += std::pow(fit.tangential_force / 10.68 - 1, 2) / kTimes;
      stated_force += std::pow(fit.force_deviation, 2) / kTimes;
      for (const FourierOrder& one : fit.pressure_orders.orders()) {
        pressure += one.amplitude * one.amplitude / 2 / kTimes;
      }
      stated_pressure += std::pow(fit.pressure_deviation, 2) / kTimes;
    }
    // 40 squares of a normal scatter: the root of their mean is known to 11 %.
    EXPECT_NEAR(std::sqrt(force / stated_force), 1, 0.4) << last_order;
    EXPECT_NEAR(std::sqrt(pressure / stated_pressure), 1, 0.4) << last_order;
    EXPECT_GT(pressure, 10 * before) << last_order;
    before = pressure;
  }
}

TEST(FreeShape, OpensAsTheMomentSays) {
  const RingBeam beam(paper_ring(0), {});
  const std::vector<ShapePoint> points = free_shape(beam, places_on(beam, 721));
  const double opening = std::hypot(points.back().x - points.front().x, points.back().y - points.front().y);
  const double first_order = 3 * pi * beam.centroid_radius() * 10.68 / beam.stiffness();
  // The running surface opens by t/2 times the turn of both ends more.
  const double turned = 3.5e-3 / 2 * 2 * pi * 10.68 / beam.stiffness();
  EXPECT_NEAR(opening - turned, first_order, 0.1 * first_order);  // s/r = 0.2: large deflections
  EXPECT_EQ(free_shape(beam, places_on(beam, 90)).size(), 90u);
}

TEST(FreeShape, ThatDoesNotCloseIsRefused) {
  const RingBeam beam(paper_ring(0.35e-3), {});
  std::vector<ShapePoint> points = free_shape(beam, places_on(beam, 361));
  EXPECT_THROW(target_of_free_shape(paper_ring(20e-3), points, 8), InputError);
  EXPECT_THROW(target_of_free_shape(paper_ring(0.35e-3), points, 100), InputError);  // fewer than 4 points a wave
  std::reverse(points.begin(), points.end());
  EXPECT_THROW(target_of_free_shape(paper_ring(0.35e-3), points, 8), InputError);
  for (ShapePoint& point : points) point.y = -point.y;  // in the sense of the angle again
  EXPECT_NEAR(target_of_free_shape(paper_ring(0.35e-3), points, 8).tangential_force, 10.68, 1e-2);
  points.resize(200);
  EXPECT_THROW(target_of_free_shape(paper_ring(0.35e-3), points, 8), InputError);
}

TEST(FourierSeries, ThroughSamplesGivesThemBack) {
  const FourierSeries series({{0, 2, 0}, {2, 15, 0.3}, {5, -3, 1}});
  std::vector<double> samples;
  for (int i = 0; i < 24; ++i) samples.push_back(series(0.2 + i * pi / 12));
  const FourierSeries found = fourier_series(samples, 0.2, 8);
  for (const double theta : {0.0, 1.0, 4.5}) EXPECT_NEAR(found(theta), series(theta), 1e-12);
  EXPECT_NEAR(series.turned(0.7)(1.0), series(1.7), 1e-12);
  EXPECT_NEAR(series.integral(0.3, 1.7),
              2 * 1.4 + 7.5 * (std::sin(2 * 1.4) - std::sin(0)) - 0.6 * (std::sin(5 * 0.7) - std::sin(-5 * 0.7)),
              1e-12);
  EXPECT_NEAR(series.derivative(1.0, 2), (series(1.001) - 2 * series(1.0) + series(0.999)) / 1e-6, 1e-3);
}

}  // namespace
