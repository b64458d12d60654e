#include "ringfilm/models/gas/gas_exchange.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/table.hpp"
#include "ringfilm/models/gas/gas_checks.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::models {
namespace {

/// Mean slope over the first or last two degrees of the samples, noise being worse than curvature there.
double end_slope(const std::vector<double>& x, const std::vector<double>& y, std::size_t end, int inwards) {
  constexpr double kSpan = 2;
  std::size_t k = end;
  do {
    k += inwards;
  } while (k > 0 && k + 1 < x.size() && std::abs(x[k] - x[end]) < kSpan);
  return (y[k] - y[end]) / (x[k] - x[end]);
}

}  // namespace

CyclePressure closed_cycle(std::vector<double> crank_angle_deg, std::vector<double> pressure,
                           const GasExchange& exchange) {
  check_trace(crank_angle_deg, pressure);
  const double begin = crank_angle_deg.front() + base::kCycleDeg;
  const double slope_at_end = end_slope(crank_angle_deg, pressure, crank_angle_deg.size() - 1, -1);
  const double slope_at_begin = end_slope(crank_angle_deg, pressure, 0, 1);
  const auto append = [&](const MonotoneBlend::End& from, const MonotoneBlend::End& to) {
    if (!(to.x > from.x)) return;
    const MonotoneBlend blend(from, to);
    const int steps = static_cast<int>(std::ceil(to.x - from.x));  // number of steps of at most one degree
    for (int k = 1; k < steps; ++k) {
      const double x = from.x + (to.x - from.x) * k / steps;
      crank_angle_deg.push_back(x);
      pressure.push_back(blend.at(x));
    }
    crank_angle_deg.push_back(to.x);
    pressure.push_back(to.y);
  };
  const double p_ex = exchange.exhaust_pressure, p_in = exchange.intake_pressure, p_begin = pressure.front();
  append({crank_angle_deg.back(), pressure.back(), slope_at_end}, {exchange.exhaust_from, p_ex, 0});
  append({exchange.exhaust_from, p_ex, 0}, {exchange.overlap_begin, p_ex, 0});
  append({exchange.overlap_begin, p_ex, 0}, {exchange.overlap_end, p_in, 0});
  append({exchange.overlap_end, p_in, 0}, {exchange.intake_until, p_in, 0});
  append({exchange.intake_until, p_in, 0}, {begin, p_begin, slope_at_begin});
  return {std::move(crank_angle_deg), std::move(pressure)};
}

CyclePressure join_partial_trace(std::vector<double> crank_angle_deg, std::vector<double> pressure,
                                 double intake_pressure, double exhaust_pressure) {
  constexpr double kBottom = 180;  // [degree]
  check_trace(crank_angle_deg, pressure);
  check_gas_pressure("gas.intake_pressure", intake_pressure);
  check_gas_pressure("gas.exhaust_pressure", exhaust_pressure);
  if (crank_angle_deg.size() < 2) {
    throw InputError("the pressure trace has one sample only", "give the trace around firing TDC");
  }
  // The cycle in which the middle of the trace lies nearest to firing TDC.
  const double middle = (crank_angle_deg.front() + crank_angle_deg.back()) / 2;
  const double shift = base::kCycleDeg * std::round(middle / base::kCycleDeg);
  for (double& angle : crank_angle_deg) angle -= shift;

  const double first = crank_angle_deg.front(), last = crank_angle_deg.back();
  const std::string range = "the pressure trace covers " + in_degrees(first) + " to " + in_degrees(last);
  const std::string half = covers_one_revolution(crank_angle_deg) ? std::string("; it is ") + kOneRevolution : "";
  if (first > 0 || last < 0) {
    throw InputError(range + ", not firing TDC at 0 degree" + half,
                     "check gas.angle_zero, or give the trace around the peak pressure");
  }
  const GasExchange exchange{
      .exhaust_from = std::max(kBottom, last + kMinBlendDeg),
      .overlap_begin = kJoinedOverlapBeginDeg,
      .overlap_end = kJoinedOverlapEndDeg,
      .intake_until = std::min(base::kCycleDeg - kBottom, first + base::kCycleDeg - kMinBlendDeg),
      .exhaust_pressure = exhaust_pressure,
      .intake_pressure = intake_pressure};
  if (first < -kMaxPartialTraceDeg || last > kMaxPartialTraceDeg) {
    throw InputError(range + ", which is neither the whole cycle nor leaves room to join it to the gas exchange" + half,
                     "cut the trace to " + in_degrees(-kMaxPartialTraceDeg) + " to " + in_degrees(kMaxPartialTraceDeg) +
                         " at the most, or give the whole cycle");
  }
  return closed_cycle(std::move(crank_angle_deg), std::move(pressure), exchange);
}

}  // namespace ringfilm::models
