#include "ringfilm/surface/face/face_fit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "friction_examples.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::surface {
namespace {

constexpr double kWidth = 1.2e-3;
const std::vector<double> kNew{427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.30};
const std::vector<double> kRunIn{-197.16, 578.85, -583.44, 200.37, 56.366, -62.709, 13.857};
const std::vector<double> kEmbedded{-6.493, -49.845, 143.22, -98.541, 27.351, -17.338, 7.4986};

/// Table 4 of styles2014: x in mm, height in um; here in m.
double table_4(const std::vector<double>& coefficients, double x_m) {
  double h = 0;
  for (const double c : coefficients) h = h * x_m * 1e3 + c;
  return h * 1e-6;
}

Trace traced(const std::vector<double>& coefficients, double noise_m, std::uint64_t seed, int points = 1201) {
  Normal normal(seed);
  Trace trace;
  for (int i = 0; i < points; ++i) {
    trace.x_m.push_back(kWidth * i / (points - 1));
    trace.height_m.push_back(table_4(coefficients, trace.x_m.back()) + noise_m * normal());
  }
  return trace;
}

FaceRule as_measured() {
  FaceRule rule;
  rule.sense = HeightSense::kGap;
  rule.width_m = kWidth;
  rule.levelling = FaceLevelling::kNone;
  rule.zero = FaceZero::kAsMeasured;
  return rule;
}

bool tells(const FaceFit& fit, InventionReason reason) {
  return std::any_of(fit.invented.begin(), fit.invented.end(), [&](const auto& i) { return i.reason == reason; });
}

TEST(FaceFit, GivesThePolynomialsOfTable4Back) {
  for (const auto& coefficients : {kNew, kRunIn, kEmbedded}) {
    const FaceFit fit = fit_face(traced(coefficients, 0, 1), as_measured());
    for (int k = 0; k < 7; ++k) {
      // A relative error of 1e-13 in the heights grows by the condition of the powers on 0 to 1.2, about 1e4.
      EXPECT_NEAR(fit.polynomial.coefficients_mm_um()[k], coefficients[k], 1e-7) << k;
    }
    EXPECT_LT(fit.polynomial_residual.rms_m, 1e-14);
    EXPECT_FALSE(tells(fit, InventionReason::kDeparts));
  }
}

TEST(FaceFit, GivesThePolynomialsOfTable4BackFromNoise) {
  const double noise = 0.05e-6;
  std::uint64_t seed = 10;
  for (const auto& coefficients : {kNew, kRunIn, kEmbedded}) {
    const FaceFit fit = fit_face(traced(coefficients, noise, ++seed), as_measured());
    // Seven coefficients of 1201 points: rms error noise sqrt(7/1201), at the ends 7 times noise/sqrt(n); 4 sigma.
    double squares = 0;
    for (int i = 0; i <= 1200; ++i) {
      const double x = kWidth * i / 1200;
      const double error = fit.polynomial.height_m(x) - table_4(coefficients, x);
      squares += error * error / 1201;
      EXPECT_LT(std::abs(error), 4 * 7 * noise / std::sqrt(1201.0));
    }
    EXPECT_LT(std::sqrt(squares), 2 * noise * std::sqrt(7 / 1201.0));
    EXPECT_NEAR(fit.polynomial_residual.rms_m, noise, 0.1 * noise);
    EXPECT_NEAR(fit.noise_m, noise, 0.1 * noise);
    EXPECT_FALSE(tells(fit, InventionReason::kDeparts));
    EXPECT_FALSE(tells(fit, InventionReason::kTurnNotInTrace));
  }
}

TEST(FaceFit, ReportsThatTheRunInPolynomialTurnsDownInItsLast60Micrometres) {
  const FaceFit fit = fit_face(traced(kRunIn, 0.02e-6, 5), as_measured());
  ASSERT_EQ(fit.invented.size(), 1u);
  EXPECT_EQ(fit.invented[0].reason, InventionReason::kFallsTowardsTheEdge);
  EXPECT_NEAR(fit.invented[0].from_m, 1.14e-3, 0.01e-3);
  EXPECT_EQ(fit.invented[0].to_m, kWidth);
  EXPECT_NE(fit.invented[0].words().find("towards the edge"), std::string::npos);
  EXPECT_TRUE(fit_face(traced(kNew, 0.02e-6, 5), as_measured()).invented.empty());
  EXPECT_TRUE(fit_face(traced(kEmbedded, 0.02e-6, 5), as_measured()).invented.empty());
}

TEST(FaceFit, ReportsATurnThatTheTraceHasNot) {
  // Beyond 1.1 mm the trace stays where the polynomial of the run-in ring is highest: it continues rising a little.
  Trace trace = traced(kRunIn, 0.005e-6, 6);
  for (std::size_t i = 0; i < trace.x_m.size(); ++i) {
    const double beyond = trace.x_m[i] - 0.9e-3;
    if (beyond > 0) trace.height_m[i] = table_4(kRunIn, 0.9e-3) + 8e-3 * std::min(beyond, 0.12e-3);
  }
  FaceRule rule = as_measured();
  rule.spline_cutoff_m = 0.06e-3;
  const FaceFit fit = fit_face(trace, rule);
  EXPECT_TRUE(tells(fit, InventionReason::kDeparts));
  // Fits of sharp corners oscillate: at least one oscillation is a turn.
  EXPECT_TRUE(tells(fit, InventionReason::kTurnNotInTrace));
}

TEST(FaceFit, ReportsWhereABumpIsTooNarrowForThePolynomial) {
  Trace trace = traced(kEmbedded, 0.02e-6, 8);
  for (std::size_t i = 0; i < trace.x_m.size(); ++i) {
    const double d = (trace.x_m[i] - 0.3e-3) / 0.03e-3;
    trace.height_m[i] += 0.5e-6 * std::exp(-d * d);
  }
  FaceRule rule = as_measured();
  rule.spline_cutoff_m = 0.08e-3;
  const FaceFit fit = fit_face(trace, rule);
  bool there = false;
  for (const FitArtifact& shape : fit.invented) {
    there |= shape.reason == InventionReason::kDeparts && shape.from_m < 0.3e-3 && shape.to_m > 0.3e-3;
  }
  EXPECT_TRUE(there);
  EXPECT_NEAR(fit.polynomial_residual.largest_at_m, 0.3e-3, 0.02e-3);
}

TEST(FaceFit, IsQuietAboutNoiseAlone) {
  // 200 traces of a polynomial with roughness that is correlated over 5 um: no more than 4 false alarms.
  int alarms = 0;
  for (std::uint64_t seed = 100; seed < 300; ++seed) {
    Trace trace = traced(kEmbedded, 0, seed);
    Normal normal(seed);
    double last = 0;
    const double rho = std::exp(-1.0 / 5);
    for (double& h : trace.height_m) {
      last = rho * last + std::sqrt(1 - rho * rho) * normal();
      h += 0.1e-6 * last;
    }
    alarms += !fit_face(trace, as_measured()).invented.empty();
  }
  EXPECT_LE(alarms, 4);
}

TEST(FaceFit, FindsTheFaceInALongerTraceAndItsRunningSurface) {
  // A parabola of 15 um at the edges, its corners rounded off steeply, tilted by the holder, heights of the material.
  Trace trace;
  for (int i = 0; i <= 1600; ++i) {
    const double x = 1e-6 * i, from_middle = x - 0.8e-3;
    const double beyond = std::max(0.0, std::abs(from_middle) - kWidth / 2);
    trace.x_m.push_back(2e-3 + x);
    trace.height_m.push_back(-(15e-6 * std::pow(from_middle / (kWidth / 2), 2) + 2 * beyond) + 5e-6);
  }
  FaceRule rule;
  rule.sense = HeightSense::kMaterial;
  rule.width_m = kWidth;
  const FaceFit fit = fit_face(trace, rule);
  EXPECT_NEAR(fit.start_m, 2.2e-3, 1e-6);
  EXPECT_NEAR(fit.polynomial_minimum_at_m, 0.6e-3, 2e-6);
  // 1 um above the lowest point of the parabola: +-0.6 mm sqrt(1/15).
  EXPECT_NEAR(fit.running_surface_to_m - fit.running_surface_from_m, 1.2e-3 * std::sqrt(1 / 15.0), 4e-6);
  EXPECT_NEAR(fit.polynomial_end_m[0], 15e-6, 0.2e-6);
  EXPECT_NEAR(fit.polynomial_end_m[1], 15e-6, 0.2e-6);
  EXPECT_NEAR(fit.spline_minimum_m, 0, 1e-12);
}

TEST(FaceFit, LevelsTheRunningSurfaceOfATiltedTrace) {
  // A flat running surface of 0.6 mm with steep flanks, tilted by 2 mrad; the tilt comes off to the errors of the
  // running surface's own edge.
  Trace trace;
  for (int i = 0; i <= 1200; ++i) {
    const double x = 1e-6 * i, off = std::max(0.0, std::abs(x - 0.6e-3) - 0.3e-3);
    trace.x_m.push_back(x);
    trace.height_m.push_back(20e-6 * std::pow(off / 0.3e-3, 2) + 2e-3 * x);
  }
  FaceRule rule = as_measured();
  rule.levelling = FaceLevelling::kRunningSurface;
  EXPECT_NEAR(fit_face(trace, rule).tilt, 2e-3, 2e-5);
  rule.levelling = FaceLevelling::kStated;
  rule.tilt = 2e-3;
  EXPECT_NEAR(fit_face(trace, rule).gap_m.back(), 20e-6, 1e-15);
}

/// Slope of the line of least squares through the running surface that is reported [-].
double slope_of_land(const FaceFit& fit) {
  double n = 0, x_mean = 0, h_mean = 0, xh = 0, xx = 0;
  const auto over_land = [&](const auto& visit) {
    for (std::size_t i = 0; i < fit.x_m.size(); ++i) {
      if (fit.x_m[i] >= fit.running_surface_from_m && fit.x_m[i] <= fit.running_surface_to_m)
        visit(fit.x_m[i], fit.gap_m[i]);
    }
  };
  over_land([&](double x, double h) { n += 1, x_mean += x, h_mean += h; });
  over_land([&](double x, double h) {
    xh += (x - x_mean / n) * (h - h_mean / n);
    xx += (x - x_mean / n) * (x - x_mean / n);
  });
  return xh / xx;
}

/// A rough and wavy face, tilted by the holder: crests join the running surface or leave it as the tilt changes.
TEST(FaceFit, LevelsARunningSurfaceThatGainsAndLosesParts) {
  FaceRule rule = as_measured();
  rule.levelling = FaceLevelling::kRunningSurface;
  Normal normal(1);
  for (int k = 0; k < 24; ++k) {
    Trace trace;
    for (int i = 0; i <= 600; ++i) {
      const double x = 2e-6 * i, s = (x - 0.6e-3) / 0.6e-3;
      const double wave = 0.1e-6 * std::sin(2 * std::numbers::pi * (2 * s + k / 24.0));
      trace.x_m.push_back(x);
      trace.height_m.push_back((2 + k) * 1e-6 * std::pow(s, 4) + wave + 0.1e-6 * normal() + 0.01 * x);
    }
    const FaceFit fit = fit_face(trace, rule);
    // A tilt is sought to 1e-10.
    EXPECT_NEAR(slope_of_land(fit), 0, 1e-9) << k;
    // What is reported as removed is what was removed.
    const double taken = (trace.height_m.back() - fit.gap_m.back()) - (trace.height_m[0] - fit.gap_m[0]);
    EXPECT_NEAR(taken, fit.tilt * kWidth, 1e-15) << k;
  }
}

TEST(FaceFit, TurnsTheFaceRound) {
  FaceRule rule = as_measured();
  rule.direction = FaceDirection::kTurned;
  const FaceFit fit = fit_face(traced(kNew, 0, 1), rule);
  EXPECT_NEAR(fit.polynomial.height_m(0.2e-3), table_4(kNew, 1.0e-3), 1e-12);
  EXPECT_NEAR(fit.gap_m.front(), table_4(kNew, kWidth), 1e-15);
}

TEST(FaceFit, OmitsPoresOnRequest) {
  // 15 % of the face are pores 5 um deep and 18 um wide.
  Trace trace = traced(kEmbedded, 0.05e-6, 12);
  for (std::size_t i = 0; i < trace.x_m.size(); ++i) {
    if (i % 120 >= 51 && i % 120 < 69) trace.height_m[i] += 5e-6;
  }
  const auto error = [](const FaceFit& fit) {
    double largest = 0;
    for (int i = 0; i <= 120; ++i) {
      const double x = kWidth * i / 120;
      largest = std::max(largest, std::abs(fit.polynomial.height_m(x) - table_4(kEmbedded, x)));
    }
    return largest;
  };
  FaceRule rule = as_measured();
  EXPECT_GT(error(fit_face(trace, rule)), 0.5e-6);  // 15 % of 5 um
  rule.pore_depth_m = 0.5e-6;
  const FaceFit fit = fit_face(trace, rule);
  EXPECT_NEAR(fit.pore_share, 0.15, 0.002);
  // As without pores: at the ends 7 noise/sqrt(n), 4 sigma, a little more for the points that are gone.
  EXPECT_LT(error(fit), 4 * 7 * 0.05e-6 / std::sqrt(1000.0));
  rule.pore_depth_m = -1.0;
  EXPECT_THROW(fit_face(trace, rule), InputError);
}

TEST(FaceFit, AveragesATraceOfVeryManyPoints) {
  const FaceFit fit = fit_face(traced(kNew, 0.05e-6, 3, 100001), as_measured());
  EXPECT_EQ(fit.averaged, 13);
  EXPECT_LE(fit.x_m.size(), 8193u);
  EXPECT_NEAR(fit.polynomial.height_m(0.6e-3), table_4(kNew, 0.6e-3), 0.01e-6);
}

TEST(FaceFit, RefusesWhatIsNotAFace) {
  const Trace good = traced(kNew, 0, 1);
  const auto refused = [](const Trace& trace, const FaceRule& rule) {
    EXPECT_THROW(fit_face(trace, rule), InputError);
  };
  FaceRule rule = as_measured();
  rule.width_m = 1.3e-3;
  refused(good, rule);
  rule = as_measured();
  rule.start_m = 0.1e-3;
  refused(good, rule);
  rule = as_measured();
  rule.spline_cutoff_m = 1e-6;
  refused(good, rule);
  rule = as_measured();
  rule.degree = 40;
  refused(good, rule);
  Trace bad = good;
  bad.height_m[7] = std::numeric_limits<double>::quiet_NaN();
  refused(bad, as_measured());
  bad = good;
  bad.x_m[7] = bad.x_m[6];
  refused(bad, as_measured());
  bad = good;
  bad.x_m.pop_back();
  refused(bad, as_measured());
  refused({}, as_measured());
  refused({{0.0}, {0.0}}, as_measured());
  rule = as_measured();
  rule.tilt = INFINITY;
  refused(good, rule);
}

}  // namespace
}  // namespace ringfilm::surface
