#include "ringfilm/cycle/setup/indicated_pressure.hpp"

#include <cmath>
#include <numbers>

#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/trace_zero.hpp"
#include "ringfilm/models/crank_slider.hpp"

namespace ringfilm::cycle {

double piston_distance(const Engine& engine, double crank_angle_deg) {
  const models::CrankSlider crank{engine.stroke / 2, engine.connecting_rod_length};
  return crank.position(crank_angle_deg * std::numbers::pi / 180) / crank.stroke();
}

namespace {

/// Work over the swept volume between two angles, of a pressure that comes `later_deg` later.
double work(const Engine& engine, const models::CyclePressure& cylinder, double from_deg, double to_deg,
            double later_deg) {
  constexpr double kStepDeg = 0.25;  // with half the step the trapezia change IMEP by less than 1e-5
  const int n = static_cast<int>(std::lround((to_deg - from_deg) / kStepDeg));
  double sum = 0, before_p = cylinder.pressure(from_deg - later_deg), before_s = piston_distance(engine, from_deg);
  for (int i = 1; i <= n; ++i) {
    const double at = from_deg + i * kStepDeg, p = cylinder.pressure(at - later_deg), s = piston_distance(engine, at);
    sum += (p + before_p) / 2 * (s - before_s);
    before_p = p;
    before_s = s;
  }
  return sum;
}

}  // namespace

IndicatedPressure indicated_pressure(const Engine& engine, const models::CyclePressure& cylinder) {
  constexpr double kHalf = kCycleDeg / 2, kQuarter = kCycleDeg / 4, kShift = 0.5;
  const auto net = [&](double later_deg) { return work(engine, cylinder, -kHalf, kHalf, later_deg); };
  return {net(0), work(engine, cylinder, -kQuarter, kQuarter, 0), (net(kShift) - net(-kShift)) / (2 * kShift)};
}

double volume_in_strokes(const Engine& engine, double crank_angle_deg, double compression_ratio) {
  return 1 / (compression_ratio - 1) + piston_distance(engine, crank_angle_deg);
}

double polytropic_index(const Engine& engine, const models::CyclePressure& cylinder, double from_deg, double to_deg,
                        double compression_ratio) {
  constexpr double kStepDeg = 5;
  double n = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
  for (double deg = from_deg; deg <= to_deg; deg += kStepDeg, ++n) {
    const double x = -std::log(volume_in_strokes(engine, deg, compression_ratio)), y = std::log(cylinder.pressure(deg));
    x_sum += x;
    y_sum += y;
    xx += x * x;
    xy += x * y;
  }
  return (n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
}

std::optional<double> compression_index(const Case& c, const models::CyclePressure& cylinder) {
  if (c.gas.model != GasModel::kWiebe && !c.stated.contains("gas.compression_ratio")) return std::nullopt;
  return polytropic_index(c.engine, cylinder, kPegFromDeg, kPegToDeg, c.gas.compression_ratio);
}

}  // namespace ringfilm::cycle
