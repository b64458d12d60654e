#include "ringfilm/case/lubricant.hpp"

#include <cmath>

#include "ringfilm/models/oil/viscosity_index.hpp"

namespace ringfilm::cycle {
namespace {

constexpr double kSameTemperature = 0.01;  // [K]

bool is_at(const TemperatureValue& point, double temperature) {
  return std::abs(point.temperature - temperature) < kSameTemperature;
}

}  // namespace

std::vector<TemperatureValue> Lubricant::viscosities() const {
  std::vector<TemperatureValue> points = kinematic_viscosity;
  if (!viscosity_index || points.size() != 1) return points;
  const TemperatureValue stated = points.front();
  if (is_at(stated, models::kLowIndexTemperature)) {
    const auto at_100 = models::viscosity_at_100(stated.value, *viscosity_index);
    if (at_100) points.push_back({models::kHighIndexTemperature, *at_100});
  } else if (is_at(stated, models::kHighIndexTemperature)) {
    const auto at_40 = models::viscosity_at_40(stated.value, *viscosity_index);
    if (at_40) points.insert(points.begin(), {models::kLowIndexTemperature, *at_40});
  }
  return points;
}

}  // namespace ringfilm::cycle
