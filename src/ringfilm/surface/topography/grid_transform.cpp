#include "ringfilm/surface/topography/grid_transform.hpp"

#include <algorithm>
#include <unsupported/Eigen/FFT>

namespace ringfilm::surface {
namespace {

using Wave = std::complex<double>;

constexpr std::size_t kColumnsTransformedAtATime = 8;

/// Transforms all columns, forward or back, in place.
void transform_columns(std::vector<Wave>& waves, std::size_t columns, std::size_t rows, Eigen::FFT<double>& fft,
                       bool forward) {
  if (rows == 1) return;
  std::vector<Wave> block(kColumnsTransformedAtATime * rows), turned(rows);
  for (std::size_t begin = 0; begin < columns; begin += kColumnsTransformedAtATime) {
    const std::size_t count = std::min(kColumnsTransformedAtATime, columns - begin);
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t c = 0; c < count; ++c) block[c * rows + j] = waves[j * columns + begin + c];
    }
    for (std::size_t c = 0; c < count; ++c) {
      Wave* const column = block.data() + c * rows;
      const auto length = static_cast<Eigen::Index>(rows);
      if (forward) {
        fft.fwd(turned.data(), column, length);
      } else {
        fft.inv(turned.data(), column, length);
      }
      std::copy(turned.begin(), turned.end(), column);
    }
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t c = 0; c < count; ++c) waves[j * columns + begin + c] = block[c * rows + j];
    }
  }
}

Eigen::FFT<double> transform() {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::Unscaled);
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  return fft;
}

}  // namespace

std::vector<Wave> waves_of(std::span<const double> values, std::size_t points_x, std::size_t points_y) {
  const std::size_t columns = points_x / 2 + 1;
  std::vector<Wave> waves(columns * points_y);
  Eigen::FFT<double> fft = transform();
  for (std::size_t j = 0; j < points_y; ++j) {
    fft.fwd(waves.data() + j * columns, values.data() + j * points_x, static_cast<Eigen::Index>(points_x));
  }
  transform_columns(waves, columns, points_y, fft, true);
  return waves;
}

std::vector<double> values_of(std::vector<Wave> waves, std::size_t points_x, std::size_t points_y) {
  const std::size_t columns = points_x / 2 + 1;
  Eigen::FFT<double> fft = transform();
  transform_columns(waves, columns, points_y, fft, false);
  std::vector<double> values(points_x * points_y);
  for (std::size_t j = 0; j < points_y; ++j) {
    fft.inv(values.data() + j * points_x, waves.data() + j * columns, static_cast<Eigen::Index>(points_x));
  }
  const double points = static_cast<double>(points_x * points_y);
  for (double& value : values) value /= points;
  return values;
}

double wave_number(std::size_t k, std::size_t n) {
  return k <= n / 2 ? static_cast<double>(k) : static_cast<double>(k) - static_cast<double>(n);
}

}  // namespace ringfilm::surface
