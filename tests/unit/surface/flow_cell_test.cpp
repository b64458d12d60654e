#include "ringfilm/surface/contact/flow_cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "surface_maps.hpp"

namespace ringfilm::surface {
namespace {

using std::numbers::pi;

std::vector<double> gap_of(std::size_t nx, std::size_t ny, const std::function<double(double, double)>& f) {
  std::vector<double> gap(nx * ny);
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      gap[j * nx + i] = f((static_cast<double>(i) + 0.5) / static_cast<double>(nx),
                          (static_cast<double>(j) + 0.5) / static_cast<double>(ny));
    }
  }
  return gap;
}

TEST(FlowCell, AWaveHasTheFactorsOfParallelAndSerialGaps) {
  // Gap 1 + e cos: transverse (1 - e^2)^2.5/(1 + e^2/2), longitudinal 1 + 1.5 e^2, Couette 2 Q/(U h) = (1 - e^2)/(1 +
  // e^2/2) across the wave and 1 along it.
  for (const MapEdges edges : {MapEdges::periodic, MapEdges::mirrored}) {
    for (const double e : {0.3, 0.6, 0.9}) {
      const auto wave = [&](double x) { return 1 + e * std::cos(2 * pi * x); };
      const FlowFactorsOfGap across =
          flow_factors(gap_of(512, 8, [&](double x, double) { return wave(x); }), {512, 8, 1.0 / 512, 0.01, edges});
      const double serial = std::pow(1 - e * e, 2.5) / (1 + e * e / 2);
      EXPECT_NEAR(across.conductance_x / serial, 1, 1e-6) << e;
      EXPECT_NEAR(across.conductance_y / (1 + 1.5 * e * e), 1, 1e-6) << e;
      EXPECT_NEAR(across.couette / ((1 - e * e) / (1 + e * e / 2)), 1, 1e-4) << e;  // second order
      const FlowFactorsOfGap along =
          flow_factors(gap_of(8, 512, [&](double, double y) { return wave(y); }), {8, 512, 0.01, 1.0 / 512, edges});
      EXPECT_NEAR(along.conductance_x / across.conductance_y, 1, 1e-9);
      EXPECT_NEAR(along.conductance_y / across.conductance_x, 1, 1e-6);
      EXPECT_NEAR(along.couette, 1, 1e-6);
    }
  }
}

TEST(FlowCell, AWaveHasTheStressOfItsClosedForms) {
  // Across the wave <H dp/dx>/(h dP/dx) = (1 - e^2)/(1 + e^2/2).
  for (const double e : {0.3, 0.6, 0.9}) {
    const auto gap = gap_of(512, 8, [&](double x, double) { return 1 + e * std::cos(2 * pi * x); });
    const FlowFactorsOfGap of = flow_factors(gap, {512, 8, 1.0 / 512, 0.01, MapEdges::periodic});
    EXPECT_NEAR(of.pressure_stress / ((1 - e * e) / (1 + e * e / 2)), 1, 1e-3) << e;
  }
}

TEST(FlowCell, ASmoothGapConvergesFasterThanAnyPowerOfTheStep) {
  // Harmonic means in a row are the trapezoidal rule of 1/H^3 over a period.
  constexpr double e = 0.8;
  const double exact = std::pow(1 - e * e, 2.5) / (1 + e * e / 2);
  double former = 1;
  for (const std::size_t points : {16, 32, 64}) {
    const auto gap = gap_of(points, 1, [&](double x, double) { return 1 + e * std::cos(2 * pi * x); });
    const double step = 1 / static_cast<double>(points);
    const double error =
        std::abs(flow_factors(gap, {points, 1, step, step, MapEdges::periodic}).conductance_x / exact - 1);
    EXPECT_LT(error, 0.1 * former);
    former = error;
  }
  EXPECT_LT(former, 1e-6);
}

TEST(FlowCell, AnIsotropicGapLosesOneAndAHalfTimesItsVariance) {
  // phi = 1 - 1.5 (sigma/h)^2 for h >> sigma.
  const HeightMap map = gaussian_surface({256, 256, 1e-6, 1e-6}, gaussian_correlation(8e-6, 8e-6), 1e-6, 1);
  std::vector<double> gap(map.points());
  for (const double h : {12e-6, 24e-6}) {
    for (std::size_t i = 0; i < gap.size(); ++i) gap[i] = h - map.height_m[i];
    const FlowFactorsOfGap of = flow_factors(gap, {256, 256, 1e-6, 1e-6, MapEdges::periodic});
    const double mean = 0.5 * (of.conductance_x + of.conductance_y) / (h * h * h), ratio = 1e-6 / h;
    EXPECT_NEAR((1 - mean) / (ratio * ratio), 1.5, 0.1);  // higher powers and the sample
  }
}

TEST(FlowCell, AQuarterTurnExchangesBothFactors) {
  const HeightMap map = gaussian_surface({64, 48, 1e-6, 1.5e-6}, gaussian_correlation(4e-6, 12e-6), 0.5e-6, 2);
  std::vector<double> gap(map.points()), turned(map.points());
  for (std::size_t j = 0; j < 48; ++j) {
    for (std::size_t i = 0; i < 64; ++i) {
      gap[j * 64 + i] = std::max(0.0, 0.7e-6 - map.height_m[map.index(i, j)]);
      turned[i * 48 + j] = gap[j * 64 + i];
    }
  }
  for (const MapEdges edges : {MapEdges::periodic, MapEdges::mirrored}) {
    const FlowFactorsOfGap one = flow_factors(gap, {64, 48, 1e-6, 1.5e-6, edges});
    const FlowFactorsOfGap other = flow_factors(turned, {48, 64, 1.5e-6, 1e-6, edges});
    EXPECT_NEAR(one.conductance_x / other.conductance_y, 1, 1e-6);
    EXPECT_NEAR(one.conductance_y / other.conductance_x, 1, 1e-6);
    EXPECT_GT(one.conductance_y, one.conductance_x);  // the lay is along y
    EXPECT_LT(one.residual, 1e-6);
  }
}

TEST(FlowCell, AWallOfContactShutsIt) {
  const auto gap = gap_of(32, 32, [](double x, double) { return x > 0.4 && x < 0.5 ? 0.0 : 1.0; });
  const FlowFactorsOfGap of = flow_factors(gap, {32, 32, 1, 1, MapEdges::periodic});
  EXPECT_NEAR(of.conductance_x, 0, 1e-12);
  EXPECT_GT(of.conductance_y, 0.8);
  EXPECT_EQ(flow_factors(std::vector<double>(64, 0.0), {8, 8, 1, 1, MapEdges::mirrored}).conductance_x, 0);
}

}  // namespace
}  // namespace ringfilm::surface
