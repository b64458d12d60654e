#include "ringfilm/instrument/documents/face_measurement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ringfilm::instrument {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kWidth = 1.2e-3;

/// A running surface of 0.4 mm between two flanks that rise as a parabola, or a face that is crowned more on one side,
/// or one that is round all over and tilted.
enum class Face { kFlat, kCrowned, kRound };

TraceFile trace(Face face) {
  TraceFile file;
  file.origin.path = "folder/trace.csv";
  file.origin.format = "text";
  for (int i = 0; i <= 1200; ++i) {
    const double x = kWidth * i / 1200, u = x - kWidth / 2;
    const double beyond = std::max(0.0, std::abs(u) - 0.2e-3);
    file.trace.x_m.push_back(x);
    double height = 60 * beyond * beyond;
    if (face == Face::kCrowned) height = 25 * u * u + 2e4 * u * u * u + 6e7 * u * u * u * u;
    if (face == Face::kRound) height = 30 * u * u + 3e-3 * u;
    file.trace.height_m.push_back(height);
  }
  return file;
}

surface::FaceRule rule() {
  surface::FaceRule of;
  of.sense = surface::HeightSense::kGap;
  of.width_m = kWidth;
  return of;
}

io::Measurement measured(const TraceFile& file, const std::optional<std::string>& points = std::nullopt) {
  return face_measurement(file, rule(), surface::fit_face(file.trace, rule()), points);
}

std::string all_notes(const io::Measurement& measurement) {
  std::string notes;
  for (const std::string& note : measurement.notes) notes += note + "\n";
  return notes;
}

TEST(FaceMeasurement, IsValidAndCarriesOneFragment) {
  const io::Measurement polynomial = measured(trace(Face::kFlat)), points = measured(trace(Face::kFlat), "face.csv");
  EXPECT_NO_THROW(io::check_measurement(polynomial));
  EXPECT_THAT(polynomial.fragment, HasSubstr("form = \"polynomial\""));
  EXPECT_THAT(points.fragment, HasSubstr("file = \"face.csv\""));
  EXPECT_THAT(points.fragment, HasSubstr("trace = \"trace.csv\""));
}

TEST(FaceMeasurement, ReportsARunningSurfaceThatIsNotFlat) {
  EXPECT_THAT(all_notes(measured(trace(Face::kCrowned))), HasSubstr("the running surface is not flat"));
  EXPECT_THAT(all_notes(measured(trace(Face::kFlat))), Not(HasSubstr("the running surface is not flat")));
}

TEST(FaceMeasurement, ReportsARoundRunningSurfaceWhoseTiltNobodyCanFind) {
  const io::Measurement round = measured(trace(Face::kRound));
  EXPECT_THAT(all_notes(round), HasSubstr("the running surface is round"));
  EXPECT_THAT(all_notes(round), HasSubstr("--levelling none"));
  EXPECT_THAT(all_notes(measured(trace(Face::kFlat))), Not(HasSubstr("the running surface is round")));
  surface::FaceRule stated = rule();
  stated.levelling = surface::FaceLevelling::kStated;
  stated.tilt = 3e-3;
  const TraceFile file = trace(Face::kRound);
  const surface::FaceFit fit = surface::fit_face(file.trace, stated);
  EXPECT_THAT(all_notes(face_measurement(file, stated, fit, std::nullopt)),
              Not(HasSubstr("the running surface is round")));
}

TEST(FaceMeasurement, HasCoefficientsInSi) {
  const TraceFile file = trace(Face::kFlat);
  const surface::FaceFit fit = surface::fit_face(file.trace, rule());
  const io::Measurement measurement = measured(file);
  const io::MeasuredGroup& coefficients = measurement.groups.back();
  ASSERT_EQ(coefficients.values.size(), 7U);
  const double x = 0.3e-3;
  double height = 0;
  for (const io::MeasuredValue& value : coefficients.values) height = height * x + value.value;
  EXPECT_NEAR(height, fit.polynomial.height_m(x), 1e-15);  // rounding of seven terms of micrometres
}

}  // namespace
}  // namespace ringfilm::instrument
