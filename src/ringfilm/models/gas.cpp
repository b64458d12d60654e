#include "ringfilm/models/gas.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/models/gas_checks.hpp"

namespace ringfilm::models {
namespace {

constexpr double kCycle = 720;  // [degree]

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Congruent angle in [0, 720).
double wrapped(double angle) {
  const double w = angle - kCycle * std::floor(angle / kCycle);
  return w < kCycle ? w : 0;
}

}  // namespace

std::string in_degrees(double angle) { return number(angle) + " degree"; }

std::string in_bar(double pressure) { return number(pressure / 1e5) + " bar"; }

void check_trace(const std::vector<double>& crank_angle_deg, const std::vector<double>& pressure) {
  if (crank_angle_deg.empty() || crank_angle_deg.size() != pressure.size()) {
    throw InputError("a pressure trace has no samples, or not as many pressures as crank angles",
                     "give one pressure for each crank angle");
  }
  for (std::size_t k = 0; k < crank_angle_deg.size(); ++k) {
    if (!std::isfinite(crank_angle_deg[k]) || !(pressure[k] > 0) || !std::isfinite(pressure[k])) {
      throw InputError("the pressure trace has " + in_bar(pressure[k]) + " at " + in_degrees(crank_angle_deg[k]) +
                           "; an absolute pressure is positive",
                       "check gas.pressure_reference (absolute or gauge) and the unit of the trace");
    }
    if (k > 0 && !(crank_angle_deg[k] > crank_angle_deg[k - 1])) {
      throw InputError("the crank angle of the pressure trace does not increase from " +
                           in_degrees(crank_angle_deg[k - 1]) + " to " + in_degrees(crank_angle_deg[k]),
                       "sort the trace and give each crank angle once");
    }
  }
  if (crank_angle_deg.back() - crank_angle_deg.front() > kCycle + 1e-6) {
    throw InputError("the pressure trace spans " + in_degrees(crank_angle_deg.back() - crank_angle_deg.front()) +
                         ", more than one cycle",
                     "give one cycle of 720 degree, for example the mean of the measured ones");
  }
}

void check_gas_pressure(const std::string& key, double pressure) {
  if (!(pressure > 0) || !std::isfinite(pressure)) {
    throw InputError(key + " = " + in_bar(pressure) + " is not a positive absolute pressure",
                     "give an absolute pressure, for example \"1.0 bara\"");
  }
}

CyclePressure::CyclePressure(double pressure) : CyclePressure(std::vector<double>{0}, {pressure}) {}

CyclePressure::CyclePressure(std::vector<double> crank_angle_deg, std::vector<double> pressure)
    : angle_(std::move(crank_angle_deg)), pressure_(std::move(pressure)) {
  check_trace(angle_, pressure_);
  if (angle_.size() > 1 && angle_.back() - angle_.front() > kCycle - 1e-6) {
    pressure_.front() = (pressure_.front() + pressure_.back()) / 2;
    angle_.pop_back();
    pressure_.pop_back();
  }
}

double CyclePressure::pressure(double crank_angle_deg) const {
  const double at = angle_.front() + wrapped(crank_angle_deg - angle_.front());
  const auto above = std::upper_bound(angle_.begin() + 1, angle_.end(), at);
  const std::size_t high = static_cast<std::size_t>(above - angle_.begin()), low = high - 1;
  const bool wraps = high == angle_.size();
  const double next_angle = wraps ? angle_.front() + kCycle : angle_[high];
  const double next_pressure = wraps ? pressure_.front() : pressure_[high];
  return pressure_[low] + (at - angle_[low]) / (next_angle - angle_[low]) * (next_pressure - pressure_[low]);
}

double CyclePressure::peak() const { return *std::max_element(pressure_.begin(), pressure_.end()); }

double CyclePressure::peak_angle_deg() const {
  const auto peak = std::max_element(pressure_.begin(), pressure_.end());
  return wrapped(angle_[static_cast<std::size_t>(peak - pressure_.begin())]);
}

bool covers_cycle(const std::vector<double>& crank_angle_deg, double largest_gap_deg) {
  if (crank_angle_deg.empty()) return false;
  double gap = crank_angle_deg.front() + kCycle - crank_angle_deg.back();
  for (std::size_t k = 1; k < crank_angle_deg.size(); ++k) {
    gap = std::max(gap, crank_angle_deg[k] - crank_angle_deg[k - 1]);
  }
  return gap <= largest_gap_deg * (1 + 1e-9);
}

}  // namespace ringfilm::models
