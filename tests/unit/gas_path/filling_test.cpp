#include <gtest/gtest.h>

#include <cmath>

#include "pack_cases.hpp"
#include "ringfilm/gas_path/cycle_integration.hpp"

namespace ringfilm::gas_path {
namespace {

constexpr double kHigh = 20e5, kLow = 1e5, kTemperature = 400;

/// A volume behind one gap, shut towards the crankcase.
Pack volume_behind_gap(double area, double volume) {
  Pack pack = two_ring_pack();
  pack.chamber = models::CyclePressure(kHigh);
  pack.crankcase = models::CyclePressure(kLow);
  pack.chamber_temperature = kTemperature;
  Ring gap, shut;
  gap.kind = shut.kind = RingKind::kOil;
  gap.gap_area = area;
  gap.volume_below = volume;
  gap.temperature_below = kTemperature;
  pack.rings = {gap, shut};
  return pack;
}

/// The pressure of that inner region at each degree of a cycle that begins at `begin` [Pa].
std::vector<double> filling(const Pack& pack, double begin, std::size_t region = 1) {
  const Network network(pack);
  const std::size_t n = pack.rings.size();
  CycleIntegration cycle(
      network, {std::vector<double>(network.n_regions() - 2, begin / PackSystem::kPressureUnit),
                std::vector<double>(n, 0), std::vector<double>(n, 0), std::vector<Contact>(n, Contact::kLowerFlank)});
  cycle.integrate();
  std::vector<double> pressure;
  for (int k = 0; k < 720; ++k) pressure.push_back(cycle.result().pressure[(540 + k) % 720][region]);
  return pressure;
}

double seconds(const Pack& pack, int degrees) { return degrees * std::numbers::pi / 180 / pack.speed; }

TEST(GasPathFilling, ChokedFillingIsLinearInTime) {
  const double V = 1e-6, A = 5e-8;
  const Pack pack = volume_behind_gap(A, V);
  const auto p = filling(pack, kLow);
  const double psi = 0.6726284;  // choked, gamma = 1.33
  const double slope = pack.gas.discharge_coefficient * A * kHigh * psi / V * std::sqrt(287 * kTemperature);
  for (const int k : {1, 10, 100, 200}) {
    ASSERT_LT(p[k], 0.54 * kHigh);
    EXPECT_NEAR(p[k], kLow + slope * seconds(pack, k), 1e-6 * p[k]) << k;
  }
}

TEST(GasPathFilling, SubsonicFillingFollowsTheQuadratureOfTheFlowFunction) {
  const double V = 1e-7, A = 1e-8, g = 1.33;
  Pack pack = volume_behind_gap(A, V);
  pack.gas.choking_smoothing = 1e-6;
  const auto p = filling(pack, 0.6 * kHigh);
  const double rate = pack.gas.discharge_coefficient * A * std::sqrt(287 * kTemperature) / V;
  const auto psi = [g](double r) {
    return std::sqrt(2 * g / (g - 1) * (std::pow(r, 2 / g) - std::pow(r, (g + 1) / g)));
  };
  for (const int k : {20, 60, 120}) {
    const double end = p[k] / kHigh;
    ASSERT_LT(end, 0.999);
    // With r = 1 - s^2 the integrand is smooth up to r = 1.
    const int n = 2000;
    const double from = std::sqrt(0.4), to = std::sqrt(1 - end), width = (from - to) / n;
    double time = 0;
    for (int i = 0; i < n; ++i) {
      const double s = to + (i + 0.5) * width;
      time += width * 2 * s / psi(1 - s * s);
    }
    EXPECT_NEAR(time / rate, seconds(pack, k), 2e-6 * seconds(pack, k)) << k;
  }
}

TEST(GasPathFilling, FillingThroughTheSideClearanceFollowsTheHyperbolicTangent) {
  Pack pack = two_ring_pack();
  pack.chamber = models::CyclePressure(kHigh);
  Ring ring = pack.rings.front();
  ring.gap_area = 0;
  ring.side_clearance = 2e-6;
  pack.rings = {ring};
  const auto p = filling(pack, kLow);
  const double d_o = pack.bore - 4e-4, d_i = pack.bore - 7e-3;
  const double l = std::numbers::pi * (d_o + d_i) / 2, w = (d_o - d_i) / 2;
  const double K = std::pow(ring.side_clearance, 3) * l / (24 * pack.gas.viscosity * w) / ring.groove_volume;
  for (const int k : {1, 50, 200, 719}) {
    const double expected = kHigh * std::tanh(K * kHigh * seconds(pack, k) + std::atanh(kLow / kHigh));
    EXPECT_NEAR(p[k], expected, 1e-6 * expected) << k;
  }
}

}  // namespace
}  // namespace ringfilm::gas_path
