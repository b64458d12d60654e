#include "ringfilm/models/conformity/free_shape.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/models/conformity/linear_solution.hpp"

namespace ringfilm::models {
namespace {

using std::numbers::pi;
using ShapeRule = boost::math::quadrature::gauss<double, 7>;

/// Integral of the target moment over phi [N m rad].
double moment_between(const RingBeam& beam, double from, double to) {
  return ShapeRule::integrate([&](double phi) { return beam.target_moment(phi); }, from, to);
}

/// Point after point from the back of the ring on. @param way 1 or -1
void append_half(const RingBeam& beam, double step, std::size_t n_steps, std::vector<ShapePoint>& points) {
  const double r = beam.centroid_radius(), softness = 1 / (beam.stiffness() * r);
  constexpr int kParts = 4;  // of a step
  double phi = pi, direction = pi;
  ShapePoint at{-r, 0};
  for (std::size_t i = 0; i < n_steps; ++i) {
    for (int part = 0; part < kParts; ++part) {
      const double next = phi + step / kParts, begin = phi, first = direction;
      const auto along = [&](double s) { return first + (s - begin) - softness * moment_between(beam, begin, s); };
      at.x += ShapeRule::integrate([&](double s) { return -r * std::sin(along(s)); }, begin, next);
      at.y += ShapeRule::integrate([&](double s) { return r * std::cos(along(s)); }, begin, next);
      direction = along(next);
      phi = next;
    }
    points.push_back(at);
  }
}

/// Direction of the ring's normal between neighbours, without jumps [rad].
std::vector<double> directions(const std::vector<ShapePoint>& points) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double raw = std::atan2(points[i + 1].y - points[i].y, points[i + 1].x - points[i].x) - pi / 2;
    all.push_back(all.empty() ? raw : raw - 2 * pi * std::round((raw - all.back()) / (2 * pi)));
  }
  return all;
}

void check_length(const RingBeamSize& size, const std::vector<ShapePoint>& points) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    length += std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y);
  }
  const double expected = pi * (size.bore - size.radial_thickness) - size.end_gap;
  constexpr double kMost = 2e-3;
  if (points.size() >= 16 && std::abs(length - expected) <= kMost * expected) return;
  throw InputError("the free shape does not close: its " + number_text(static_cast<double>(points.size())) +
                       " points are " + number_text(length * 1e3) + " mm long, the centroid of the closed ring " +
                       number_text(expected * 1e3) + " mm",
                   "give 16 evenly spaced points of the centroid or more, from end to end of the ring, and the end gap "
                   "of the closed ring");
}

RingBeam unit_beam(RingBeamSize size, const FourierSeries& orders) {
  size.tangential_force = 1;
  return {size, orders};
}

/// Rotation from the first place on by each unknown of the fit: 1 N of mean pressure, then of the orders.
std::vector<std::vector<double>> rotations(const RingBeamSize& size, const std::vector<double>& places,
                                           int last_order) {
  const auto rotation = [&](const RingBeam& beam) {
    std::vector<double> all;
    double sum = 0, before = places.front();
    for (const double phi : places) {
      sum -= moment_between(beam, before, phi) / (beam.stiffness() * beam.centroid_radius());
      before = phi;
      all.push_back(sum);
    }
    return all;
  };
  std::vector<std::vector<double>> columns{std::vector<double>(places.size(), 1.0), rotation(unit_beam(size, {}))};
  for (int n = 2; n <= last_order; ++n) {
    for (const double phase : {0.0, pi / (2 * n)}) {
      std::vector<double> column = rotation(unit_beam(size, FourierSeries({{n, 1, phase}})));
      for (std::size_t i = 0; i < column.size(); ++i) column[i] -= columns[1][i];
      columns.push_back(std::move(column));
    }
  }
  return columns;
}

/// Shares of the columns whose sum is nearest to y.
std::vector<double> least_squares(const std::vector<std::vector<double>>& columns, const std::vector<double>& y) {
  const std::size_t n = columns.size();
  std::vector<double> scale;
  for (const auto& column : columns) {
    double sum = 0;
    for (const double value : column) sum += value * value;
    scale.push_back(1 / std::sqrt(sum));
  }
  std::vector<std::vector<double>> A(n, std::vector<double>(n, 0));
  std::vector<double> b(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < y.size(); ++k) b[i] += scale[i] * columns[i][k] * y[k];
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < y.size(); ++k) A[i][j] += scale[i] * scale[j] * columns[i][k] * columns[j][k];
    }
  }
  std::vector<double> shares = linear_solution(std::move(A), std::move(b));
  for (std::size_t i = 0; i < n; ++i) shares[i] *= scale[i];
  return shares;
}

}  // namespace

std::vector<ShapePoint> free_shape(const RingBeam& beam, int n_points) {
  const std::size_t n_steps = static_cast<std::size_t>(std::max(2, n_points)) - 1;
  const double step = 2 * (pi - beam.half_gap()) / static_cast<double>(n_steps);
  // From the back both ways: half a step first where no point is opposite the gap.
  const bool has_back = n_steps % 2 == 0;
  const std::size_t half = has_back ? n_steps / 2 : n_steps;
  const double width = has_back ? step : step / 2;
  std::vector<ShapePoint> forwards, backwards;
  append_half(beam, width, half, forwards);
  append_half(beam, -width, half, backwards);
  std::vector<ShapePoint> points;
  const std::size_t every = has_back ? 1 : 2;
  for (std::size_t i = backwards.size(); i > 0; i -= std::min(i, every)) points.push_back(backwards[i - 1]);
  if (has_back) points.push_back({-beam.centroid_radius(), 0});
  for (std::size_t i = 0; i < forwards.size(); i += every) points.push_back(forwards[i]);
  return points;
}

FreeShapeFit target_of_free_shape(const RingBeamSize& size, const std::vector<ShapePoint>& points, int last_order) {
  check_length(size, points);
  const RingBeam beam = unit_beam(size, {});
  const double step = 2 * (pi - beam.half_gap()) / static_cast<double>(points.size() - 1);
  std::vector<double> places, turned = directions(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    places.push_back(beam.half_gap() + (static_cast<double>(i) + 0.5) * step);
    turned[i] -= places.back();
  }
  const auto columns = rotations(size, places, last_order);
  const std::vector<double> shares = least_squares(columns, turned);
  FreeShapeFit fit;
  fit.tangential_force = shares[1];
  if (!(fit.tangential_force > 0)) {
    throw InputError(
        "the free shape presses inwards: its tangential force is " + number_text(fit.tangential_force) + " N",
        "list the points from one end of the ring to the other in the sense of the angle");
  }
  std::vector<FourierOrder> orders;
  for (int n = 2; n <= last_order; ++n) {
    const std::size_t k = 2 * static_cast<std::size_t>(n) - 2;
    const double cosine = shares[k] / shares[1], sine = shares[k + 1] / shares[1];
    orders.push_back({n, std::hypot(cosine, sine), std::atan2(sine, cosine) / n});
  }
  fit.pressure_orders = FourierSeries(std::move(orders));
  double sum = 0;
  for (std::size_t i = 0; i < turned.size(); ++i) {
    double miss = turned[i];
    for (std::size_t k = 0; k < columns.size(); ++k) miss -= shares[k] * columns[k][i];
    sum += miss * miss;
  }
  fit.residual = std::sqrt(sum / static_cast<double>(turned.size()));
  return fit;
}

}  // namespace ringfilm::models
