#include "ringfilm/surface/topography/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <string>
#include <unsupported/Eigen/FFT>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/topography/gaussian_kernel.hpp"
#include "ringfilm/surface/topography/grid_transform.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMinPointsOfSpectrum = 16;
constexpr std::size_t kLinesAtATime = 16;

std::vector<double> hann(std::size_t points) {
  std::vector<double> window(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double s = std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(points));
    window[i] = s * s;
  }
  return window;
}

[[noreturn]] void too_short() {
  throw InputError("no spectrum is found: a line needs " + std::to_string(kMinPointsOfSpectrum) +
                       " points or more, half of them measured",
                   "take a larger region, or one with fewer missing points");
}

/// Adds the power of one line to a spectrum.
class LinePower {
 public:
  LinePower(std::size_t points, double step_m)
      : window_(hann(points)),
        length_(transform_length(points)),
        step_m_(step_m),
        line_(length_),
        waves_(length_ / 2 + 1) {
    power_.assign(length_ / 2 + 1, 0.0);
    fft_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  }

  void add(std::span<const double> heights, std::span<const unsigned char> measured) {
    double sum = 0, weights = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      if (!measured[i]) continue;
      sum += heights[i];
      weights += window_[i] * window_[i];
      ++count;
    }
    if (count < kMinPointsOfSpectrum || 2 * count < heights.size()) return;
    const double mean = sum / static_cast<double>(count);
    for (std::size_t i = 0; i < heights.size(); ++i) line_[i] = measured[i] ? window_[i] * (heights[i] - mean) : 0.0;
    fft_.fwd(waves_.data(), line_.data(), static_cast<Eigen::Index>(length_));
    for (std::size_t k = 0; k < waves_.size(); ++k) power_[k] += std::norm(waves_[k]) / weights;
    ++lines_;
  }

  LineSpectrum spectrum() const {
    if (lines_ == 0) too_short();
    LineSpectrum of;
    of.lines = lines_;
    const double frequency_step = 1 / (static_cast<double>(length_) * step_m_);
    for (std::size_t k = 1; k < power_.size(); ++k) {
      const double sides = 2 * k == length_ ? 1 : 2;
      of.frequency_per_m.push_back(static_cast<double>(k) * frequency_step);
      of.density_m3.push_back(sides * step_m_ * power_[k] / static_cast<double>(lines_));
    }
    return of;
  }

 private:
  std::vector<double> window_;
  std::size_t length_;
  double step_m_;
  std::vector<double> line_, power_;
  std::vector<std::complex<double>> waves_;
  Eigen::FFT<double> fft_;
  std::size_t lines_ = 0;
};

}  // namespace

LineSpectrum line_spectrum(const HeightMap& map, LineDirection direction) {
  check_map(map);
  const bool along_x = direction == LineDirection::x;
  const std::size_t points = along_x ? map.points_x : map.points_y, lines = along_x ? map.points_y : map.points_x;
  if (points < kMinPointsOfSpectrum) too_short();
  LinePower power(points, along_x ? map.step_x_m : map.step_y_m);
  const std::size_t at_a_time = std::min(kLinesAtATime, lines);  // a long profile is one line
  std::vector<double> heights(at_a_time * points);
  std::vector<unsigned char> measured(at_a_time * points);
  for (std::size_t begin = 0; begin < lines; begin += at_a_time) {
    const std::size_t count = std::min(at_a_time, lines - begin);
    for (std::size_t i = 0; i < points; ++i) {
      for (std::size_t c = 0; c < count; ++c) {
        const std::size_t point = along_x ? map.index(i, begin + c) : map.index(begin + c, i);
        heights[c * points + i] = map.height_m[point];
        measured[c * points + i] = map.measured(point) ? 1 : 0;
      }
    }
    for (std::size_t c = 0; c < count; ++c) {
      power.add(std::span<const double>(heights).subspan(c * points, points),
                std::span<const unsigned char>(measured).subspan(c * points, points));
    }
  }
  return power.spectrum();
}

RadialSpectrum radial_spectrum(const HeightMap& map) {
  check_map(map);
  const std::size_t count = measured_points(map);
  if (map.points_x < kMinPointsOfSpectrum || map.points_y < kMinPointsOfSpectrum || 2 * count < map.points())
    too_short();
  const std::size_t length_x = transform_length(map.points_x), length_y = transform_length(map.points_y);
  double mean = 0;
  for (std::size_t i = 0; i < map.points(); ++i) {
    if (map.measured(i)) mean += map.height_m[i] / static_cast<double>(count);
  }
  const std::vector<double> window_x = hann(map.points_x), window_y = hann(map.points_y);
  std::vector<double> values(length_x * length_y, 0.0);
  double weights = 0;
  for (std::size_t j = 0; j < map.points_y; ++j) {
    double row = 0;
    for (std::size_t i = 0; i < map.points_x; ++i) {
      const std::size_t point = map.index(i, j);
      if (!map.measured(point)) continue;
      const double weight = window_x[i] * window_y[j];
      values[j * length_x + i] = weight * (map.height_m[point] - mean);
      row += weight * weight;
    }
    weights += row;
  }
  const std::vector<std::complex<double>> waves = waves_of(values, length_x, length_y);
  const double per_x = 1 / (static_cast<double>(length_x) * map.step_x_m);
  const double per_y = 1 / (static_cast<double>(length_y) * map.step_y_m);
  const double ring = std::max(per_x, per_y), highest = 0.5 / std::max(map.step_x_m, map.step_y_m);
  const auto rings = static_cast<std::size_t>(highest / ring);
  std::vector<double> power(rings + 1, 0.0), frequency(rings + 1, 0.0);
  std::vector<std::size_t> in_ring(rings + 1, 0);
  const std::size_t columns = length_x / 2 + 1;
  for (std::size_t k = 0; k < length_y; ++k) {
    for (std::size_t m = 0; m < columns; ++m) {
      const double f = std::hypot(static_cast<double>(m) * per_x, wave_number(k, length_y) * per_y);
      const auto at = static_cast<std::size_t>(std::lround(f / ring));
      if (at == 0 || at > rings) continue;
      const std::size_t both = m == 0 || 2 * m == length_x ? 1 : 2;  // a wave and its mirror
      power[at] += static_cast<double>(both) * std::norm(waves[k * columns + m]);
      frequency[at] += static_cast<double>(both) * f;
      in_ring[at] += both;
    }
  }
  RadialSpectrum of;
  for (std::size_t at = 1; at <= rings; ++at) {
    if (in_ring[at] == 0) continue;
    const double number = static_cast<double>(in_ring[at]);
    of.frequency_per_m.push_back(frequency[at] / number);
    of.density_m4.push_back(map.step_x_m * map.step_y_m * power[at] / number / weights);
    of.waves.push_back(in_ring[at]);
  }
  return of;
}

}  // namespace ringfilm::surface
