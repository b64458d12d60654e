#include "ringfilm/instrument/documents/standard_surfaces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace ringfilm::instrument {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kStep = 0.5e-6, kShort = 0.3e-6, kLong = 0.5e-6;  // [m]: step, amplitudes of both waves

/// A bowl, a tilt and two waves of 5 um along x and 25 um along y, 100 um x 100 um.
SurfaceFile waves(std::size_t points = 200) {
  SurfaceFile file;
  surface::HeightMap& map = file.map;
  map.points_x = map.points_y = points;
  map.step_x_m = map.step_y_m = kStep;
  for (std::size_t j = 0; j < points; ++j) {
    for (std::size_t i = 0; i < points; ++i) {
      const double x = kStep * static_cast<double>(i), y = kStep * static_cast<double>(j);
      map.height_m.push_back(kShort * std::sin(2 * std::numbers::pi * x / 5e-6) +
                             kLong * std::cos(2 * std::numbers::pi * y / 25e-6) + 0.05 * x + 2e3 * x * x);
    }
  }
  return file;
}

const io::MeasuredValue& value_of(const std::vector<io::MeasuredGroup>& groups, const std::string& name) {
  for (const io::MeasuredGroup& group : groups) {
    for (const io::MeasuredValue& value : group.values) {
      if (value.name == name) return value;
    }
  }
  throw std::runtime_error("no value " + name);
}

/// Amplitude that a Gaussian filter lets through of a wave: ISO 16610-61, half at the nesting index.
double passed(double index_um, double wave_um) { return std::exp2(-std::pow(index_um / wave_um, 2)); }

TEST(StandardSurfaces, NestingIndicesAreThoseOfTheSeries) {
  const auto indices = [](double step_m, std::size_t points_x, std::size_t points_y) {
    surface::HeightMap map;
    map.points_x = points_x;
    map.points_y = points_y;
    map.step_x_m = map.step_y_m = step_m;
    const surface::Preparation found = standard_preparation(map, {});
    return std::vector<double>{1e6 * found.short_cutoff_m.value(), 1e6 * found.long_cutoff_m.value()};
  };
  using testing::DoubleNear;
  EXPECT_THAT(indices(0.5e-6, 200, 100), ElementsAre(DoubleNear(2, 1e-9), DoubleNear(50, 1e-9)));
  EXPECT_THAT(indices(0.27e-6, 300, 300), ElementsAre(DoubleNear(1, 1e-9), DoubleNear(80, 1e-9)));
  EXPECT_THAT(indices(1e-6 / 3, 768, 1024), ElementsAre(DoubleNear(1, 1e-9), DoubleNear(250, 1e-9)));
  EXPECT_THAT(indices(2.7e-6, 1000, 1000), ElementsAre(DoubleNear(10, 1e-9), DoubleNear(2500, 1e-9)));
}

TEST(StandardSurfaces, FormAndWavesOutsideAreRemoved) {
  SurfaceAnalysis analysis;
  analysis.preparation.long_cutoff_m = 10e-6;
  std::vector<std::string> notes;
  const std::vector<io::MeasuredGroup> groups = standard_groups(waves(), analysis, notes);
  EXPECT_THAT(notes, IsEmpty());
  // The S-filter is 2 um. Edges, where the weights are renormalised, and the form take a few percent.
  const double short_S = kShort * passed(2, 5), long_S = kLong * passed(2, 25);
  EXPECT_NEAR(value_of(groups, "SF_Sq").value, std::hypot(short_S, long_S) / std::sqrt(2), 0.03 * kLong);
  const double short_L = short_S * (1 - passed(10, 5)), long_L = long_S * (1 - passed(10, 25));
  EXPECT_NEAR(value_of(groups, "SL_Sq").value, std::hypot(short_L, long_L) / std::sqrt(2), 0.03 * kLong);
  const double slope = 2 * std::numbers::pi * short_L / 5e-6 / std::sqrt(2);  // of the short wave, which has the most
  EXPECT_NEAR(value_of(groups, "SL_Sdq").value, slope, 0.05 * slope);
}

TEST(StandardSurfaces, EachValueHasItsSettings) {
  SurfaceAnalysis analysis;
  analysis.preparation.long_cutoff_m = 10e-6;
  std::vector<std::string> notes;
  const std::vector<io::MeasuredGroup> groups = standard_groups(waves(), analysis, notes);
  for (const io::MeasuredGroup& group : groups) {
    for (const io::MeasuredValue& value : group.values) {
      EXPECT_THAT(value.remark, HasSubstr("form removed: ")) << value.name;
      EXPECT_THAT(value.remark, HasSubstr("S-filter 2 um")) << value.name;
      EXPECT_THAT(value.remark, HasSubstr("pixel 0.5 um; ISO 25178-2")) << value.name;
    }
  }
  EXPECT_THAT(value_of(groups, "SL_Sq").remark, HasSubstr("L-filter 10 um"));
  EXPECT_THAT(value_of(groups, "SF_Sq").remark, testing::Not(HasSubstr("L-filter")));
}

TEST(StandardSurfaces, AMapTooSmallForThemHasANote) {
  std::vector<std::string> notes;
  EXPECT_THAT(standard_groups(waves(7), {}, notes), IsEmpty());
  EXPECT_THAT(notes, ElementsAre(HasSubstr("no S-F surface: the S-filter of 2 um leaves less than half"),
                                 HasSubstr("no S-L surface")));
}

TEST(StandardSurfaces, AreReportedUnlessTheyAreNotAskedFor) {
  SurfaceAnalysis analysis;
  const auto has = [&] {
    for (const io::MeasuredGroup& group : surface_measurement(waves(60), analysis, nullptr).groups) {
      if (group.title.find("S-F surface") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(has());
  analysis.standard_surfaces = StandardSurfaces::kNone;
  EXPECT_FALSE(has());
}

}  // namespace
}  // namespace ringfilm::instrument
