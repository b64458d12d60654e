#include "ringfilm/base/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "ringfilm/base/error.hpp"

namespace ringfilm {
namespace {

void check_samples(std::span<const double> x, std::span<const double> y, std::size_t fewest) {
  if (x.size() == y.size() && x.size() >= fewest) return;
  throw InputError("a table has " + std::to_string(x.size()) + " places and " + std::to_string(y.size()) + " values",
                   "equally many of both are required, " + std::to_string(fewest) + " or more");
}

/// Number of the interval of increasing x in which `at` lies, the end intervals reaching to infinity.
std::size_t interval(std::span<const double> x, double at) {
  const auto inner = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  return static_cast<std::size_t>(inner - x.begin()) - 1;
}

/// Slope at the end of three samples that does not corrupt monotony; width and secant of the end interval and the next.
double end_slope(double h_0, double h_1, double d_0, double d_1) {
  const double parabola = ((2 * h_0 + h_1) * d_0 - h_0 * d_1) / (h_0 + h_1);
  if (parabola * d_0 <= 0) return 0;
  return d_0 * d_1 <= 0 && std::abs(parabola) > 3 * std::abs(d_0) ? 3 * d_0 : parabola;
}

/// The cubic with values y and slopes m at the ends of an interval, at the share t of its width.
MonotoneCubic::ValueAndSlope cubic(double width, double t, double y_0, double y_1, double m_0, double m_1) {
  const double secant = (y_1 - y_0) / width;
  // y = y_0 + width t (m_0 + t (b + t a))
  const double a = m_0 + m_1 - 2 * secant;
  const double b = 3 * secant - 2 * m_0 - m_1;
  return {y_0 + width * t * (m_0 + t * (b + t * a)), m_0 + t * (2 * b + t * 3 * a)};
}

}  // namespace

double interpolate_linear(std::span<const double> x, std::span<const double> y, double at) {
  check_samples(x, y, 1);
  if (x.size() == 1) return y[0];
  const std::size_t i = interval(x, at);
  const double share = (at - x[i]) / (x[i + 1] - x[i]);
  return y[i] + share * (y[i + 1] - y[i]);
}

MonotoneCubic::MonotoneCubic(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size()) {
  check_samples(x_, y_, 2);
  const std::size_t n = x_.size();
  std::vector<double> width(n - 1), secant(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    width[i] = x_[i + 1] - x_[i];
    secant[i] = (y_[i + 1] - y_[i]) / width[i];
  }
  if (n == 2) {
    slope_ = {secant[0], secant[0]};
    return;
  }
  slope_.front() = end_slope(width[0], width[1], secant[0], secant[1]);
  slope_.back() = end_slope(width[n - 2], width[n - 3], secant[n - 2], secant[n - 3]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (secant[i - 1] * secant[i] <= 0) continue;  // a turning point stays one: slope zero
    const double w_0 = 2 * width[i] + width[i - 1], w_1 = width[i] + 2 * width[i - 1];
    slope_[i] = (w_0 + w_1) / (w_0 / secant[i - 1] + w_1 / secant[i]);
  }
}

MonotoneCubic::ValueAndSlope MonotoneCubic::at(double x) const {
  if (x <= x_.front()) return {y_.front() + slope_.front() * (x - x_.front()), slope_.front()};
  if (x >= x_.back()) return {y_.back() + slope_.back() * (x - x_.back()), slope_.back()};
  const std::size_t i = interval(x_, x);
  return cubic(x_[i + 1] - x_[i], (x - x_[i]) / (x_[i + 1] - x_[i]), y_[i], y_[i + 1], slope_[i], slope_[i + 1]);
}

MonotoneBlend::MonotoneBlend(const End& from, const End& to) : from_(from), to_(to) {
  const double secant = (to.y - from.y) / (to.x - from.x);
  for (double* slope : {&from_.slope, &to_.slope}) {
    if (*slope * secant <= 0) {
      *slope = 0;
    } else if (std::abs(*slope) > 3 * std::abs(secant)) {
      *slope = 3 * secant;
    }
  }
}

double MonotoneBlend::at(double x) const {
  const double width = to_.x - from_.x;
  return cubic(width, (x - from_.x) / width, from_.y, to_.y, from_.slope, to_.slope).value;
}

}  // namespace ringfilm
