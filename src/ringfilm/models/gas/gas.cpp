#include "ringfilm/models/gas/gas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/models/gas/gas_checks.hpp"
#include "ringfilm/models/gas/trace_span.hpp"

namespace ringfilm::models {
namespace {

/// Congruent angle in [0, 720).
double wrapped(double angle) {
  const double w = angle - base::kCycleDeg * std::floor(angle / base::kCycleDeg);
  return w < base::kCycleDeg ? w : 0;
}

struct Extent {
  double least, largest;  // NaN omitted
  double sum;             // finite only if all are
};

/// Smallest, largest and sum of value(0) .. value(n-1), n > 0. A measured trace has thousands of samples: eight running
/// results side by side run in vector registers, where a single one would wait for itself.
template <class Value>
Extent extent(std::size_t n, const Value& value) {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> least, largest, sum{};
  least.fill(value(0));
  largest = least;
  std::size_t k = 0;
  for (; k + kLanes <= n; k += kLanes) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      const double v = value(k + i);
      least[i] = v < least[i] ? v : least[i];
      largest[i] = v > largest[i] ? v : largest[i];
      sum[i] += v;
    }
  }
  Extent all{least[0], largest[0], 0};
  for (std::size_t i = 0; i < kLanes; ++i) {
    all = {std::min(all.least, least[i]), std::max(all.largest, largest[i]), all.sum + sum[i]};
  }
  for (; k < n; ++k) all = {std::min(all.least, value(k)), std::max(all.largest, value(k)), all.sum + value(k)};
  return all;
}

/// Smallest, largest and sum of the steps between neighbouring angles; all 1 for a single angle.
Extent steps(const std::vector<double>& angle) {
  if (angle.size() < 2) return {1, 1, 1};
  return extent(angle.size() - 1, [&](std::size_t k) { return angle[k + 1] - angle[k]; });
}

/// Every angle finite and above the one before, every pressure finite and positive.
bool samples_are_sound(const std::vector<double>& angle, const std::vector<double>& pressure) {
  const Extent step = steps(angle), p = extent(pressure.size(), [&](std::size_t k) { return pressure[k]; });
  return step.least > 0 && p.least > 0 && std::isfinite(angle.front()) && std::isfinite(step.sum) &&
         std::isfinite(p.sum);
}

}  // namespace

std::string in_degrees(double angle) { return number_text(angle) + " degree"; }

void check_trace(const std::vector<double>& crank_angle_deg, const std::vector<double>& pressure) {
  if (crank_angle_deg.empty() || crank_angle_deg.size() != pressure.size()) {
    throw InputError("a pressure trace has no samples, or not as many pressures as crank angles",
                     "give one pressure for each crank angle");
  }
  const bool sound = samples_are_sound(crank_angle_deg, pressure);
  for (std::size_t k = 0; !sound && k < crank_angle_deg.size(); ++k) {
    if (!std::isfinite(crank_angle_deg[k]) || !(pressure[k] > 0) || !std::isfinite(pressure[k])) {
      throw InputError("the pressure trace has " + text_in(pressure[k], kBar) + " at " +
                           in_degrees(crank_angle_deg[k]) + "; an absolute pressure is positive",
                       "check gas.pressure_reference (absolute or gauge) and the unit of the trace");
    }
    if (k > 0 && !(crank_angle_deg[k] > crank_angle_deg[k - 1])) {
      throw InputError("the crank angle of the pressure trace does not increase from " +
                           in_degrees(crank_angle_deg[k - 1]) + " to " + in_degrees(crank_angle_deg[k]),
                       "sort the trace and give each crank angle once");
    }
  }
  if (crank_angle_deg.back() - crank_angle_deg.front() > base::kCycleDeg + 1e-6) {
    throw InputError("the pressure trace spans " + in_degrees(crank_angle_deg.back() - crank_angle_deg.front()) +
                         ", more than one cycle",
                     "give one cycle of 720 degree, for example the mean of the measured ones");
  }
}

void check_gas_pressure(const std::string& key, double pressure) {
  if (!(pressure > 0) || !std::isfinite(pressure)) {
    throw InputError(key + " = " + text_in(pressure, kBar) + " is not a positive absolute pressure",
                     "give an absolute pressure, for example \"1.0 bara\"");
  }
}

CyclePressure::CyclePressure(double pressure) : CyclePressure(std::vector<double>{0}, {pressure}) {}

CyclePressure::CyclePressure(std::vector<double> crank_angle_deg, std::vector<double> pressure)
    : angle_(std::move(crank_angle_deg)), pressure_(std::move(pressure)) {
  check_trace(angle_, pressure_);
  if (angle_.size() > 1 && angle_.back() - angle_.front() > base::kCycleDeg - 1e-6) {
    pressure_.front() = (pressure_.front() + pressure_.back()) / 2;
    angle_.pop_back();
    pressure_.pop_back();
  }
}

double CyclePressure::pressure(double crank_angle_deg) const {
  if (angle_.size() == 1) return pressure_.front();
  const double at = angle_.front() + wrapped(crank_angle_deg - angle_.front());
  // The last sample that is not beyond: looked for first where it is if the samples are evenly spaced.
  const std::size_t last = angle_.size() - 1;
  const double span = angle_[last] - angle_[0];
  const double even = span > 0 ? (at - angle_[0]) / span * static_cast<double>(last) : 0.0;
  std::size_t low = std::min(static_cast<std::size_t>(even), last);
  if (low < last && angle_[low + 1] <= at) ++low;  // rounding of the place
  if (angle_[low] > at || (low < last && angle_[low + 1] <= at)) {
    low = static_cast<std::size_t>(std::upper_bound(angle_.begin() + 1, angle_.end(), at) - angle_.begin()) - 1;
  }
  const bool wraps = low == last;
  const double next_angle = wraps ? angle_.front() + base::kCycleDeg : angle_[low + 1];
  const double next_pressure = wraps ? pressure_.front() : pressure_[low + 1];
  return pressure_[low] + (at - angle_[low]) / (next_angle - angle_[low]) * (next_pressure - pressure_[low]);
}

double CyclePressure::peak() const {
  return extent(pressure_.size(), [&](std::size_t k) { return pressure_[k]; }).largest;
}

double CyclePressure::peak_angle_deg() const {
  const auto peak = std::max_element(pressure_.begin(), pressure_.end());
  return wrapped(angle_[static_cast<std::size_t>(peak - pressure_.begin())]);
}

bool covers_cycle(const std::vector<double>& crank_angle_deg) {
  if (crank_angle_deg.empty()) return false;
  const double wrap = crank_angle_deg.front() + base::kCycleDeg - crank_angle_deg.back();
  const double gap = crank_angle_deg.size() < 2 ? wrap : std::max(wrap, steps(crank_angle_deg).largest);
  return gap <= kMaxSampleDistanceDeg * (1 + 1e-9);
}

}  // namespace ringfilm::models
