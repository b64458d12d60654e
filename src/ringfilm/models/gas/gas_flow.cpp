#include "ringfilm/models/gas/gas_flow.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::models {

double critical_pressure_ratio(double heat_capacity_ratio) {
  const double g = heat_capacity_ratio;
  return std::pow(2 / (g + 1), g / (g - 1));
}

OrificeLaw::OrificeLaw(double heat_capacity_ratio, double choking_smoothing)
    : gamma_(heat_capacity_ratio),
      critical_(critical_pressure_ratio(heat_capacity_ratio)),
      choked_(unsmoothed(critical_)),
      line_begin_(1 - choking_smoothing),
      line_value_(unsmoothed(line_begin_)) {}

double OrificeLaw::unsmoothed(double ratio) const {
  // r^(2/g) - r^((g+1)/g) = r^(2/g) (1 - r^((g-1)/g)), without the difference of nearly equal numbers.
  const double log_ratio = std::log(ratio);
  const double deficit = -std::expm1((gamma_ - 1) / gamma_ * log_ratio);
  return std::sqrt(2 * gamma_ / (gamma_ - 1) * deficit) * std::exp(log_ratio / gamma_);
}

double OrificeLaw::flow_function(double ratio) const {
  if (ratio <= critical_) return choked_;
  if (ratio >= line_begin_) return line_value_ * (1 - ratio) / (1 - line_begin_);
  return unsmoothed(ratio);
}

double orifice_flow(const OrificeLaw& law, double area, double gas_constant, const GasState& a, const GasState& b) {
  const bool forwards = a.pressure >= b.pressure;
  const GasState &up = forwards ? a : b, &down = forwards ? b : a;
  const double flow =
      area * up.pressure / std::sqrt(gas_constant * up.temperature) * law.flow_function(down.pressure / up.pressure);
  return forwards ? flow : -flow;
}

double GasChannel::flow(double clearance, double p_a, double p_b) const {
  return (p_a - p_b) * (p_a + p_b) * clearance * clearance * clearance * length /
         (24 * viscosity * gas_constant * temperature * width);
}

double GasChannel::slope(double clearance, double pressure) const {
  return 2 * flow(clearance, pressure, 0) / pressure;  // d(p^2)/dp = 2 p^2/p
}

double GasChannel::limited_flow(const OrificeLaw& law, double clearance, double p_a, double p_b) const {
  if (p_a == p_b || clearance <= 0) return 0;
  const double laminar = flow(clearance, p_a, p_b);
  const double choking = orifice_flow(law, length * clearance, gas_constant, {p_a, temperature}, {p_b, temperature});
  return laminar / std::hypot(1.0, laminar / choking);
}

double mean_channel_pressure(double p_a, double p_b) {
  return 2.0 / 3.0 * (p_a * p_a + p_a * p_b + p_b * p_b) / (p_a + p_b);
}

}  // namespace ringfilm::models
