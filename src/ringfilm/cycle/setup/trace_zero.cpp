#include "ringfilm/cycle/setup/trace_zero.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/setup/indicated_pressure.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

/// Around bottom dead centre after intake the piston hardly moves, and the pressure is that of the intake; assumed.
constexpr double kBottomFromDeg = -190, kBottomToDeg = -170;
constexpr std::size_t kMinSamples = 3;

/// Samples of the cylinder's trace between two angles.
struct Window {
  std::vector<double> crank_angle_deg, pressure;
};

Window samples_between(const Gas& gas, double from_deg, double to_deg) {
  Window window;
  const SampledTrace& trace = *gas.cylinder_pressure;
  for (std::size_t i = 0; i < trace.value.size(); ++i) {
    const double angle = from_firing_deg(gas, trace.crank_angle_deg[i]);
    if (angle < from_deg || angle > to_deg) continue;
    window.crank_angle_deg.push_back(angle);
    window.pressure.push_back(trace.value[i] + rise_of_traces(gas));
  }
  if (window.pressure.size() >= kMinSamples) return window;
  throw InputError("the trace has fewer than " + number_text(kMinSamples) + " samples between " +
                       number_text(from_deg) + " and " + number_text(to_deg) + " degree, which gas.pegging requires",
                   "state gas.pegging = \"none\" with gas.pressure_offset, or give a trace of these angles");
}

double shift_to_intake(const Gas& gas) {
  if (!gas.intake_pressure) {
    throw InputError("gas.pegging = \"intake\" requires the pressure at bottom dead centre after intake",
                     "state gas.intake_pressure, for example \"0.95 bar\"");
  }
  const Window window = samples_between(gas, kBottomFromDeg, kBottomToDeg);
  double sum = 0;
  for (const double p : window.pressure) sum += p;
  return *gas.intake_pressure - sum / static_cast<double>(window.pressure.size());
}

/// p + shift = C V^-n: a straight line of p over V^-n, whose value at 0 is -shift.
double shift_to_index(const Case& c) {
  const Window window = samples_between(c.gas, kPegFromDeg, kPegToDeg);
  const auto n = static_cast<double>(window.pressure.size());
  double x_sum = 0, y_sum = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < window.pressure.size(); ++i) {
    const double volume = volume_in_strokes(c.engine, window.crank_angle_deg[i], c.gas.compression_ratio);
    const double x = std::pow(volume, -c.gas.polytropic_index), y = window.pressure[i];
    x_sum += x;
    y_sum += y;
    xx += x * x;
    xy += x * y;
  }
  const double slope = (n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
  return -(y_sum - slope * x_sum) / n;
}

}  // namespace

double turn_of_traces_deg(const Gas& gas) { return gas.angle_zero == AngleZero::kGasExchangeTdc ? kCycleDeg / 2 : 0; }

double rise_of_traces(const Gas& gas) {
  return gas.pressure_reference == PressureReference::kGauge ? base::kAtmosphere : 0.0;
}

double from_firing_deg(const Gas& gas, double trace_angle_deg) {
  const double angle = wrapped(trace_angle_deg + turn_of_traces_deg(gas) + gas.angle_offset_deg);
  return angle < kCycleDeg / 2 ? angle : angle - kCycleDeg;
}

double pegging_shift(const Case& c) {
  if (c.gas.pegging == Pegging::kNone) return 0;
  return c.gas.pegging == Pegging::kIntake ? shift_to_intake(c.gas) : shift_to_index(c);
}

double rise_of_cylinder_trace(const Case& c) {
  const double shift = c.gas.pegging == Pegging::kNone ? c.gas.pressure_offset : pegging_shift(c);
  return rise_of_traces(c.gas) + shift;
}

double indicated_mean_pressure(const Engine& engine, const std::vector<double>& crank_angle_deg,
                               const std::vector<double>& pressure) {
  double work = 0;  // per displacement
  for (std::size_t i = 0; i < crank_angle_deg.size(); ++i) {
    const std::size_t next = i + 1 == crank_angle_deg.size() ? 0 : i + 1;
    const double from = piston_distance(engine, crank_angle_deg[i]);
    const double to = piston_distance(engine, crank_angle_deg[next]);
    work += (pressure[i] + pressure[next]) / 2 * (to - from);
  }
  return work;
}

}  // namespace ringfilm::cycle
