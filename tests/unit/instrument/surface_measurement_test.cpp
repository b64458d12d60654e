#include "ringfilm/instrument/documents/surface_measurement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synthetic_surfaces.hpp"

namespace ringfilm::instrument {
namespace {

TEST(SurfaceMeasurement, KeepsTheDigestOfItsFile) {
  const SurfaceFile ring = rough("ring.x3p", 1e-7, 1);
  EXPECT_TRUE(holds(surface_measurement(ring, {}, nullptr).sources, "SHA-256 digest of ring.x3p"));
}

TEST(SurfaceMeasurement, MomentsInUseAreThoseOfNAndBeta) {
  const SurfaceFile ring = rough("ring.x3p", 1e-7, 1), flat = rough("flat.x3p", 3e-8, 2);
  const io::Measurement measured = surface_measurement(ring, {}, &flat);
  const double m2 = value(measured, "m2"), m4 = value(measured, "m4"), pi = std::acos(-1.0);
  EXPECT_NEAR(value(measured, "asperity_density") * 6 * pi * std::sqrt(3.0) * m2 / m4, 1, 1e-12);
  EXPECT_NEAR(value(measured, "asperity_radius") * std::sqrt(m4 / pi) * 8 / 3, 1, 1e-12);
}

TEST(SurfaceMeasurement, OfAProfileStatesItsSamplingLengths) {
  SurfaceFile profile = rough("profile.csv", 1e-7, 1, {400, 1, 1e-6, 1e-6});
  SurfaceAnalysis analysis;
  const auto is_named = [&](const std::string& name) {
    for (const io::MeasuredGroup& group : surface_measurement(profile, analysis, nullptr).groups) {
      for (const io::MeasuredValue& one : group.values) {
        if (one.name == name) return true;
      }
    }
    return false;
  };
  const auto of = [&](const char* name) { return value(surface_measurement(profile, analysis, nullptr), name); };
  EXPECT_EQ(of("sampling_lengths"), 5);
  EXPECT_NEAR(of("sampling_length"), 80e-6, 1e-18);
  EXPECT_NEAR(of("Rz"), of("Rp") + of("Rv"), 1e-20);
  EXPECT_LT(of("Rz"), of("Rt"));
  EXPECT_NEAR(of("Rt"), of("Rpt") + of("Rvt"), 1e-20);
  analysis.preparation.long_cutoff_m = 60e-6;  // six of them fit
  EXPECT_EQ(of("sampling_lengths"), 6);
  EXPECT_NEAR(of("sampling_length"), 60e-6, 1e-18);
  EXPECT_TRUE(is_named("Rz"));
  profile = rough("map.x3p", 1e-7, 1);
  analysis = {};
  EXPECT_TRUE(is_named("Sz"));
  EXPECT_FALSE(is_named("Rz") || is_named("Rt"));
}

TEST(SurfaceMeasurement, TakesTheTiltOffAFlatWhereTheSurfaceIsACylinder) {
  SurfaceFile ring = rough("ring.x3p", 1e-7, 1), flat = rough("flat.x3p", 3e-8, 2);
  for (std::size_t j = 0; j < kGrid.points_y; ++j) {
    for (std::size_t i = 0; i < kGrid.points_x; ++i) {
      const double x = 1e-6 * (static_cast<double>(i) - 31.5);
      ring.map.height_m[ring.map.index(i, j)] -= x * x / (2 * 0.3e-3);
    }
  }
  SurfaceAnalysis analysis;
  analysis.preparation.form = {surface::FormKind::cylinder};
  const surface::SpectralMoments noise = noise_moments(flat, prepare_surface(ring, analysis), analysis);
  analysis.preparation.form = {surface::FormKind::tilt};
  EXPECT_EQ(noise.m2, noise_moments(flat, prepare_surface(ring, analysis), analysis).m2);
}

TEST(SurfaceMeasurement, ReportsThatTheStepsAlongXAndYDiffer) {
  const SurfaceFile oblong = rough("oblong.x3p", 1e-7, 1, {64, 48, 1e-6, 2e-6});
  const std::string words = "along y differ";
  EXPECT_TRUE(holds(surface_measurement(oblong, {}, nullptr).notes, words));
  EXPECT_FALSE(holds(surface_measurement(rough("square.x3p", 1e-7, 1), {}, nullptr).notes, words));
  SurfaceAnalysis along_x;
  along_x.direction = surface::MomentDirection::x;
  EXPECT_FALSE(holds(surface_measurement(oblong, along_x, nullptr).notes, words));
  SurfaceAnalysis filtered;
  filtered.preparation.short_cutoff_m = 5e-6;
  EXPECT_FALSE(holds(surface_measurement(oblong, filtered, nullptr).notes, words));
}

TEST(SurfaceMeasurement, GivesNoRadiusToSummitsThatAreNotThere) {
  SurfaceFile ridges = rough("ridges.x3p", 1e-7, 1);
  for (std::size_t j = 1; j < kGrid.points_y; ++j) {
    for (std::size_t i = 0; i < kGrid.points_x; ++i) {
      ridges.map.height_m[ridges.map.index(i, j)] = ridges.map.height_m[i];
    }
  }
  const io::Measurement measured = surface_measurement(ridges, {}, nullptr);
  EXPECT_EQ(value(measured, "summit_count"), 0);
  for (const io::MeasuredGroup& group : measured.groups) {
    for (const io::MeasuredValue& of : group.values) EXPECT_NE(of.name, "summit_radius");
  }
}

}  // namespace
}  // namespace ringfilm::instrument
