#include "ringfilm/models/ring.hpp"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/base/table.hpp"

namespace ringfilm::models {
namespace {

void check_width(double face_width) {
  if (!(face_width > 0) || !std::isfinite(face_width)) {
    throw InputError("ring.face_width = " + text_in(face_width, kMillimetre) + " is not a positive length",
                     "give the axial width of the running face, for example \"1.2 mm\"");
  }
}

}  // namespace

RingFace::RingFace(std::function<double(double)> height, double face_width, std::vector<double> break_points)
    : height_(std::move(height)), face_width_(face_width), break_points_(std::move(break_points)) {}

RingFace RingFace::polynomial(std::vector<double> coefficients, double length_unit, double height_unit,
                              double face_width) {
  check_width(face_width);
  auto height = [c = std::move(coefficients), length_unit, height_unit](double x) {
    double sum = 0;
    for (const double c_k : c) sum = sum * (x / length_unit) + c_k;
    return height_unit * sum;
  };
  return {std::move(height), face_width, {0, face_width}};
}

RingFace RingFace::parabola(double crown_height, double apex, double face_width) {
  check_width(face_width);
  const double lowest = apex * face_width, farther = std::max(apex, 1 - apex) * face_width;
  auto height = [crown_height, lowest, farther](double x) {
    const double share = (x - lowest) / farther;
    return crown_height * share * share;
  };
  return {std::move(height), face_width, {0, lowest, face_width}};
}

RingFace RingFace::cosine(double crown_height, double apex, double face_width) {
  check_width(face_width);
  const double lowest = apex * face_width, turn = boost::math::double_constants::two_pi / face_width;
  auto height = [crown_height, lowest, turn](double x) {
    return 0.5 * crown_height * (1 - std::cos(turn * (x - lowest)));
  };
  return {std::move(height), face_width, {0, lowest, face_width}};
}

RingFace RingFace::points(std::vector<double> x, std::vector<double> height, double face_width) {
  check_width(face_width);
  if (x.size() < 2 || height.size() != x.size() ||
      std::adjacent_find(x.begin(), x.end(), std::greater_equal<>()) != x.end()) {
    throw InputError("the ring face has fewer than two points or their x does not increase",
                     "sort the points of ring.face.file by x and give each x once");
  }
  const double rounding = 1e-9 * face_width;  // what converting units may remove from the last point
  if (!(x.front() <= rounding && x.back() >= face_width - rounding)) {
    throw InputError("the points of the ring face reach from " + text_in(x.front(), kMillimetre) + " to " +
                         text_in(x.back(), kMillimetre) + " and do not cover the width, 0 to " +
                         text_in(face_width, kMillimetre),
                     "measure the whole face, or give the ring.face_width that was measured");
  }
  std::vector<double> break_points{0};
  for (const double x_k : x) {
    if (x_k > 0 && x_k < face_width) break_points.push_back(x_k);
  }
  break_points.push_back(face_width);
  auto interpolated = [x = std::move(x), h = std::move(height)](double at) { return interpolate_linear(x, h, at); };
  return {std::move(interpolated), face_width, std::move(break_points)};
}

double RingFace::height(double x) const { return height_(x); }

RingFace::Minimum RingFace::minimum() const {
  // Smooth pieces are searched where a sample lies below both its neighbours; 256 samples resolve every bend of a
  // polynomial of a degree that is in use.
  const int samples = break_points_.size() > 2 ? 2 : 256;
  Minimum lowest{0, std::numeric_limits<double>::infinity()};
  const auto consider = [&](double x, double height) {
    if (height < lowest.height) lowest = {x, height};
  };
  for (std::size_t piece = 0; piece + 1 < break_points_.size(); ++piece) {
    const double from = break_points_[piece], width = break_points_[piece + 1] - from;
    const auto x = [&](int k) { return k == samples ? break_points_[piece + 1] : from + width * k / samples; };
    consider(x(0), height_(x(0)));
    consider(x(samples), height_(x(samples)));
    for (int k = 1; k < samples; ++k) {
      const std::array<double, 3> h{height_(x(k - 1)), height_(x(k)), height_(x(k + 1))};
      if (h[1] > h[0] || h[1] > h[2]) continue;
      // In shares of the width, because the search's tolerance has an absolute part; half the digits are all that the
      // value of a minimum can resolve.
      const auto [share, height] = boost::math::tools::brent_find_minima(
          [&](double s) { return height_(s * face_width_); }, x(k - 1) / face_width_, x(k + 1) / face_width_,
          std::numeric_limits<double>::digits / 2);
      consider(share * face_width_, height);
      consider(x(k), h[1]);
    }
  }
  return lowest;
}

RingFace RingFace::turned() const {
  std::vector<double> mirrored(break_points_.rbegin(), break_points_.rend());
  for (double& x : mirrored) x = face_width_ - x;
  return {[height = height_, b = face_width_](double x) { return height(b - x); }, face_width_, std::move(mirrored)};
}

double elastic_pressure_from_tangential_force(double F_t, double face_width, double bore) {
  return 2 * F_t / (face_width * bore);
}

double tangential_force_from_elastic_pressure(double p_e, double face_width, double bore) {
  return p_e * face_width * bore / 2;
}

double elastic_pressure_from_free_gap(double free_gap, double radial_thickness, double E, double bore) {
  const double r = bore / 2;
  return E * std::pow(radial_thickness, 3) * free_gap / (36 * boost::math::double_constants::pi * std::pow(r, 4));
}

double elastic_pressure_from_section(double free_gap, double second_moment, double face_width, double E, double bore) {
  return E * second_moment * free_gap / (3 * boost::math::double_constants::pi * face_width * std::pow(bore / 2, 4));
}

}  // namespace ringfilm::models
