#include "ringfilm/surface/topography/gaussian_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace ringfilm::surface {
namespace {

constexpr double kReach = 1.3;          // cut-offs
constexpr std::size_t kMaxSummed = 48;  // steps to one side: there both ways take about as long
constexpr std::size_t kColumnsSummedAtATime = 16;
constexpr std::size_t kPointsAtATime = 512;  // a piece of a line that stays close to the processor

std::vector<double> sampled_gaussian(double width_steps, std::size_t reach) {
  std::vector<double> weights(reach + 1);
  for (std::size_t k = 0; k <= reach; ++k) {
    const double place = static_cast<double>(k) / width_steps;
    weights[k] = std::exp(-std::numbers::pi * place * place);
  }
  double sum = weights[0];
  for (std::size_t k = 1; k <= reach; ++k) sum += 2 * weights[k];
  for (double& weight : weights) weight /= sum;
  return weights;
}

double passing_share(std::span<const double> weights, double wavelength_steps) {
  double share = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) {
    share += 2 * weights[k] * std::cos(2 * std::numbers::pi * static_cast<double>(k) / wavelength_steps);
  }
  return share;
}

}  // namespace

std::vector<double> gaussian_kernel(double cutoff_steps) {
  const double alpha = std::sqrt(std::log(2.0) / std::numbers::pi);
  const auto reach = static_cast<std::size_t>(std::ceil(kReach * cutoff_steps)) + 1;
  double narrow = 0.95 * alpha, wide = 1.6 * alpha;
  for (int halving = 0; halving < 52; ++halving) {
    const double middle = 0.5 * (narrow + wide);
    const bool too_much = passing_share(sampled_gaussian(middle * cutoff_steps, reach), cutoff_steps) > 0.5;
    (too_much ? narrow : wide) = middle;
  }
  return sampled_gaussian(0.5 * (narrow + wide) * cutoff_steps, reach);
}

std::size_t transform_length(std::size_t n) {
  for (std::size_t length = std::max<std::size_t>(n, 1);; ++length) {
    std::size_t rest = length;
    for (const std::size_t factor : {2u, 3u, 5u}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return length;
  }
}

struct LineConvolution::Transform {
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> lines, waves;
  std::vector<double> passing;  // transmission of each wave, with the factor 1/n of the inverse transform
};

LineConvolution::LineConvolution(std::span<const double> kernel, std::size_t points)
    : kernel_(kernel.begin(), kernel.end()) {
  // What lies further away than the line is long meets nothing.
  if (kernel_.size() > points) kernel_.resize(points);
  const std::size_t reach = kernel_.size() - 1;
  if (reach <= kMaxSummed) {
    padded_.assign(points + 2 * reach, 0.0);
    return;
  }
  transform_ = std::make_unique<Transform>();
  transform_->fft.SetFlag(Eigen::FFT<double>::Unscaled);
  const std::size_t length = transform_length(points + reach);
  auto& [fft, lines, waves, passing] = *transform_;
  lines.assign(length, 0.0);
  waves.assign(length, 0.0);
  passing.resize(length);
  lines[0] = kernel_[0];
  for (std::size_t k = 1; k <= reach; ++k) {
    lines[k] += kernel_[k];
    lines[length - k] += kernel_[k];
  }
  fft.fwd(waves.data(), lines.data(), static_cast<Eigen::Index>(length));
  for (std::size_t k = 0; k < length; ++k) passing[k] = waves[k].real() / static_cast<double>(length);
}

LineConvolution::~LineConvolution() = default;

void LineConvolution::sum(std::span<double> line) {
  const std::size_t reach = kernel_.size() - 1;
  std::copy(line.begin(), line.end(), padded_.begin() + static_cast<std::ptrdiff_t>(reach));
  for (std::size_t begin = 0; begin < line.size(); begin += kPointsAtATime) {
    const std::size_t end = std::min(begin + kPointsAtATime, line.size());
    double* const out = line.data();
    const double* const middle = padded_.data() + reach;
    for (std::size_t i = begin; i < end; ++i) out[i] = kernel_[0] * middle[i];
    for (std::size_t k = 1; k <= reach; ++k) {
      const double weight = kernel_[k];
      const double* const before = middle - k;
      const double* const after = middle + k;
      for (std::size_t i = begin; i < end; ++i) out[i] += weight * (before[i] + after[i]);
    }
  }
}

void LineConvolution::apply(std::span<double> first, std::span<double> second) {
  if (!transform_) {
    sum(first);
    if (!second.empty()) sum(second);
    return;
  }
  auto& [fft, lines, waves, passing] = *transform_;
  for (std::size_t i = 0; i < first.size(); ++i) lines[i] = {first[i], second.empty() ? 0.0 : second[i]};
  std::fill(lines.begin() + static_cast<std::ptrdiff_t>(first.size()), lines.end(), 0.0);
  const auto length = static_cast<Eigen::Index>(lines.size());
  fft.fwd(waves.data(), lines.data(), length);
  for (std::size_t k = 0; k < waves.size(); ++k) waves[k] *= passing[k];
  fft.inv(lines.data(), waves.data(), length);
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = lines[i].real();
  for (std::size_t i = 0; i < second.size(); ++i) second[i] = lines[i].imag();
}

void convolve_grid(std::span<double> values, std::size_t points_x, std::size_t points_y,
                   std::span<const double> kernel_x, std::span<const double> kernel_y) {
  if (!kernel_x.empty()) {
    LineConvolution along_x(kernel_x, points_x);
    for (std::size_t j = 0; j < points_y; j += 2) {
      const bool pair = j + 1 < points_y;
      along_x.apply(values.subspan(j * points_x, points_x),
                    pair ? values.subspan((j + 1) * points_x, points_x) : std::span<double>{});
    }
  }
  if (kernel_y.empty()) return;
  LineConvolution along_y(kernel_y, points_y);
  std::vector<double> columns(kColumnsSummedAtATime * points_y);
  for (std::size_t begin = 0; begin < points_x; begin += kColumnsSummedAtATime) {
    const std::size_t count = std::min(kColumnsSummedAtATime, points_x - begin);
    for (std::size_t j = 0; j < points_y; ++j) {
      for (std::size_t c = 0; c < count; ++c) columns[c * points_y + j] = values[j * points_x + begin + c];
    }
    const std::span<double> all(columns);
    for (std::size_t c = 0; c < count; c += 2) {
      along_y.apply(all.subspan(c * points_y, points_y),
                    c + 1 < count ? all.subspan((c + 1) * points_y, points_y) : std::span<double>{});
    }
    for (std::size_t j = 0; j < points_y; ++j) {
      for (std::size_t c = 0; c < count; ++c) values[j * points_x + begin + c] = columns[c * points_y + j];
    }
  }
}

}  // namespace ringfilm::surface
