#include "ringfilm/surface/friction_loop/lateral_force_line.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"

namespace ringfilm::surface {
namespace {

constexpr int kMaxLineSteps = 500;
constexpr double kSlopeSettled = 1e-13;

void check_points(const std::vector<LinePoint>& points) {
  if (points.size() < 3) {
    throw InputError("a line with its error requires three loads or more, not " + std::to_string(points.size()),
                     "measure at more loads");
  }
  for (const LinePoint& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.x_deviation) || !std::isfinite(p.y_deviation)) {
      throw InputError("a point of the line is not a number", "leave it out");
    }
    if (p.x_deviation < 0 || p.y_deviation < 0 || (p.x_deviation == 0 && p.y_deviation == 0)) {
      throw InputError("a point of the line has no standard deviation in either direction",
                       "state one that is above zero, or none for all points");
    }
  }
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [](const LinePoint& a, const LinePoint& b) { return a.x < b.x; });
  if (low->x == high->x) throw InputError("all points of the line have one load", "measure at other loads too");
}

/// The points about their middle in units of their spread, so that squares neither over- nor underflow.
struct Scaled {
  std::vector<LinePoint> points;
  double x_middle, y_middle, x_unit, y_unit;
};

Scaled scaled(const std::vector<LinePoint>& points) {
  Scaled s{points, 0, 0, 0, 0};
  const double n = static_cast<double>(points.size());
  for (const LinePoint& p : points) {
    s.x_middle += p.x / n;
    s.y_middle += p.y / n;
  }
  for (const LinePoint& p : points) {
    s.x_unit = std::max(s.x_unit, std::abs(p.x - s.x_middle));
    s.y_unit = std::max({s.y_unit, std::abs(p.y - s.y_middle), p.y_deviation});
  }
  if (s.y_unit == 0) s.y_unit = 1;
  for (LinePoint& p : s.points) {
    p = {(p.x - s.x_middle) / s.x_unit, (p.y - s.y_middle) / s.y_unit, p.x_deviation / s.x_unit,
         p.y_deviation / s.y_unit};
  }
  return s;
}

/// What York's equations give for one slope.
struct York {
  double slope, x_mean, y_mean;  ///< next slope, weighted centre
  double fitted_mean, squares;   ///< weighted mean of the fitted loads, their weighted squares about it
  double weights, chi_squared;   ///< sums
};

York york_step(const std::vector<LinePoint>& points, double slope) {
  York y{};
  std::vector<double> weight(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LinePoint& p = points[i];
    weight[i] = 1 / (p.y_deviation * p.y_deviation + slope * slope * p.x_deviation * p.x_deviation);
    // A point that is exact in y hinders no flat line; the step away from flat must not end in infinity.
    if (!std::isfinite(weight[i])) throw InputError("a point of the line has no weight", "state deviations of y");
    y.weights += weight[i];
    y.x_mean += weight[i] * p.x;
    y.y_mean += weight[i] * p.y;
  }
  y.x_mean /= y.weights;
  y.y_mean /= y.weights;
  double above = 0, below = 0;
  std::vector<double> fitted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LinePoint& p = points[i];
    const double U = p.x - y.x_mean, V = p.y - y.y_mean;
    fitted[i] = weight[i] * (U * p.y_deviation * p.y_deviation + slope * V * p.x_deviation * p.x_deviation);
    above += weight[i] * fitted[i] * V;
    below += weight[i] * fitted[i] * U;
    y.fitted_mean += weight[i] * fitted[i] / y.weights;
    y.chi_squared += weight[i] * (V - slope * U) * (V - slope * U);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    y.squares += weight[i] * (fitted[i] - y.fitted_mean) * (fitted[i] - y.fitted_mean);
  }
  y.slope = above / below;
  y.fitted_mean += y.x_mean;
  return y;
}

double least_squares_slope(const std::vector<LinePoint>& points) {
  double xy = 0, xx = 0;
  for (const LinePoint& p : points) {
    xy += p.x * p.y;
    xx += p.x * p.x;
  }
  return xy / xx;
}

LineFit line_of(const std::vector<LoadFriction>& loads, DeviationScale scale, double LoadFriction::*value,
                double LoadFriction::*deviation) {
  const bool unknown =
      std::any_of(loads.begin(), loads.end(), [&](const LoadFriction& f) { return f.*deviation <= 0; });
  if (unknown && scale == DeviationScale::kStated) {
    throw InputError("the standard deviation of the friction signal is not known at every load",
                     "state them, or take their size from the scatter about the line");
  }
  std::vector<LinePoint> points;
  for (const LoadFriction& f : loads) {
    // Without any figure for y the errors of the loads cannot be weighed against it.
    points.push_back({f.load, f.*value, unknown ? 0.0 : f.load_deviation, unknown ? 1.0 : f.*deviation});
  }
  return fit_line(points, scale);
}

}  // namespace

double coverage_factor(double confidence, double degrees_of_freedom) {
  if (!(confidence > 0 && confidence < 1) || !(degrees_of_freedom > 0)) {
    throw InputError("an interval has no width for a confidence of " + number_text(confidence) + " and " +
                         number_text(degrees_of_freedom) + " degrees of freedom",
                     "a confidence between 0 and 1 is required, for example 0.95, and three points or more");
  }
  const double upper = 0.5 + confidence / 2;
  if (std::isinf(degrees_of_freedom)) return boost::math::quantile(boost::math::normal(), upper);
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), upper);
}

double LineFit::degrees_of_freedom() const {
  return scale == DeviationScale::kStated ? std::numeric_limits<double>::infinity() : points - 2.0;
}

double LineFit::slope_half_width(double confidence) const {
  return coverage_factor(confidence, degrees_of_freedom()) * slope_deviation;
}

double LineFit::offset_half_width(double confidence) const {
  return coverage_factor(confidence, degrees_of_freedom()) * offset_deviation;
}

LineFit fit_line(const std::vector<LinePoint>& points, DeviationScale scale) {
  check_points(points);
  const Scaled s = scaled(points);
  double slope = least_squares_slope(s.points);
  bool settled = false;
  York york{};
  for (int step = 0; step < kMaxLineSteps && !settled; ++step) {
    york = york_step(s.points, slope);
    if (!std::isfinite(york.slope)) break;
    settled = std::abs(york.slope - slope) <= kSlopeSettled * std::max(1.0, std::abs(york.slope));
    slope = york.slope;
  }
  if (!settled) {
    throw InputError("the points do not fix a line: their scatter is as large as their range",
                     "measure over a wider range of loads");
  }
  york = york_step(s.points, slope);
  LineFit fit;
  fit.points = static_cast<int>(points.size());
  fit.scale = scale;
  fit.chi_squared = york.chi_squared;
  const double freedom = fit.points - 2.0;
  fit.chi_squared_probability = boost::math::gamma_q(freedom / 2, fit.chi_squared / 2);
  const double factor = scale == DeviationScale::kStated ? 1 : york.chi_squared / freedom;
  const double slope_variance = factor / york.squares;
  // Back to the units of the points: x = x_middle + x_unit x', y likewise.
  const double unit = s.y_unit / s.x_unit;
  const double mean = s.x_middle + s.x_unit * york.fitted_mean;
  fit.slope = slope * unit;
  fit.offset = s.y_middle + s.y_unit * york.y_mean - fit.slope * (s.x_middle + s.x_unit * york.x_mean);
  fit.slope_deviation = std::sqrt(slope_variance) * unit;
  fit.offset_deviation = std::hypot(std::sqrt(factor / york.weights) * s.y_unit, mean * fit.slope_deviation);
  fit.covariance = -mean * fit.slope_deviation * fit.slope_deviation;
  if (!std::isfinite(fit.slope) || !std::isfinite(fit.offset) || !std::isfinite(fit.slope_deviation) ||
      !std::isfinite(fit.offset_deviation) || !std::isfinite(fit.covariance)) {
    throw InputError("the slope of the line is out of the range of numbers", "check the units of load and signal");
  }
  return fit;
}

LineFit friction_load_line(const std::vector<LoadFriction>& loads, DeviationScale scale) {
  return line_of(loads, scale, &LoadFriction::tmr_V, &LoadFriction::tmr_deviation_V);
}

LineFit offset_load_line(const std::vector<LoadFriction>& loads, DeviationScale scale) {
  return line_of(loads, scale, &LoadFriction::offset_V, &LoadFriction::offset_deviation_V);
}

}  // namespace ringfilm::surface
