#include <gtest/gtest.h>

#include <cmath>

#include "ringfilm/base/error.hpp"
#include "synthetic_surfaces.hpp"

namespace ringfilm::instrument {
namespace {

TEST(PairMeasurement, KeepsTheDigestsOfItsFiles) {
  const SurfaceFile ring = rough("ring.x3p", 1e-7, 1), liner = rough("liner.x3p", 1e-7, 2);
  const io::Measurement pair = pair_measurement({ring}, {liner}, {}, nullptr);
  EXPECT_TRUE(holds(pair.sources, "SHA-256 digest of liner.x3p"));
  EXPECT_TRUE(holds({pair.fragment}, "# liner: liner.x3p, SHA-256 digest of liner.x3p"));
}

TEST(PairMeasurement, StatesALawWithTheRoughnessThatItTakes) {
  const SurfaceFile ring = rough("ring.x3p", 3e-7, 1), liner = rough("liner.x3p", 4e-7, 2);
  const auto rms = [](const SurfaceFile& file) {  // about the mean of the map
    double sum = 0, squares = 0;
    for (const double z : file.map.height_m) sum += z;
    const double count = static_cast<double>(file.map.points()), mean = sum / count;
    for (const double z : file.map.height_m) squares += (z - mean) * (z - mean);
    return std::sqrt(squares / count);
  };
  SurfaceAnalysis analysis;
  analysis.hardness = 2.5e9;
  EXPECT_THROW(pair_measurement({ring}, {liner}, analysis, nullptr), InputError) << "sigma of Ra is 20 % less";
  analysis.sigma_rule = surface::SigmaRule::rq;
  const io::Measurement pair = pair_measurement({ring}, {liner}, analysis, nullptr);
  EXPECT_NEAR(value(pair, "roughness"), std::hypot(rms(ring), rms(liner)), 1e-15);
  EXPECT_TRUE(holds({pair.fragment}, "model = \"greenwood-williamson\""));
  EXPECT_TRUE(holds({pair.fragment}, "squares of Rq"));
}

TEST(PairMeasurement, ReportsThatStepsAlongYDiffer) {
  const SurfaceFile square = rough("square.x3p", 1e-7, 1), oblong = rough("oblong.x3p", 1e-7, 1, {64, 48, 1e-6, 2e-6});
  const std::string words = "the maps have different steps";
  EXPECT_TRUE(holds(pair_measurement({square}, {oblong}, {}, nullptr).notes, words));
  EXPECT_FALSE(holds(pair_measurement({square}, {square}, {}, nullptr).notes, words));
}

TEST(PairMeasurement, NamesThePixelOfBothSides) {
  const SurfaceFile fine = rough("fine.x3p", 1e-7, 1), coarse = rough("coarse.x3p", 1e-7, 2, {64, 48, 2e-6, 2e-6});
  const io::Measurement pair = pair_measurement({fine}, {coarse}, {}, nullptr);
  EXPECT_EQ(pair.groups.front().values.front().remark, "ring: no filter; pixel 1 um; liner: no filter; pixel 2 um");
}

TEST(PairMeasurement, GivesTheCorrelationsOfItsScatter) {
  SurfaceAnalysis analysis;
  analysis.regions.across = 3;
  analysis.regions.down = 2;
  const SurfaceFile ring = rough("ring.x3p", 1e-7, 1), liner = rough("liner.x3p", 1e-7, 2);
  const io::Measurement pair = pair_measurement({ring}, {liner}, analysis, nullptr);
  for (const char* name : {"correlation_asperity_density_asperity_radius", "correlation_asperity_radius_roughness",
                           "correlation_asperity_density_roughness"}) {
    EXPECT_NE(value(pair, name), 0) << name;
    EXPECT_LT(std::abs(value(pair, name)), 1) << name;
  }
  EXPECT_TRUE(holds({pair.fragment}, "density_radius_correlation"));
}

TEST(PairMeasurement, RecordsTheDirectionAndTheNoise) {
  const SurfaceFile ring = rough("ring.x3p", 1e-7, 1), liner = rough("liner.x3p", 1e-7, 2),
                    flat = rough("flat.x3p", 1e-8, 3);
  SurfaceAnalysis analysis;
  analysis.direction = surface::MomentDirection::geometric;
  const std::string fragment = pair_measurement({ring}, {liner}, analysis, &flat).fragment;
  EXPECT_TRUE(holds({fragment}, "geometric mean of x and y"));
  EXPECT_TRUE(holds({fragment}, "noise of flat.x3p removed"));
}

TEST(PairMeasurement, KeepsThePlaceOfEachRegionOfEachFile) {
  SurfaceAnalysis analysis;
  analysis.regions.rectangles_m = {{10e-6, 20e-6, 30e-6, 16e-6}};
  const SurfaceFile ring = rough("ring.x3p", 1e-7, 1), other = rough("other.x3p", 1e-7, 2);
  const io::Measurement pair = pair_measurement({ring, other}, {ring}, analysis, nullptr);
  EXPECT_TRUE(holds({pair.fragment}, "liner_surface = \"ring.x3p (1 region)\""));
  const io::MeasuredTable& table = pair.tables.front();
  const double places[] = {10e-6, 20e-6, 30e-6, 16e-6};
  const char* names[] = {"ring_region_x", "ring_region_y", "ring_region_width", "ring_region_height"};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t column = table.columns.size() - 4 + k;
    EXPECT_EQ(table.columns[column].name, names[k]);
    ASSERT_EQ(table.values[column].size(), 2U);
    EXPECT_NEAR(table.values[column][1], places[k], 1e-18);
  }
}

}  // namespace
}  // namespace ringfilm::instrument
