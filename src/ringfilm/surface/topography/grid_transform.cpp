#include "ringfilm/surface/topography/grid_transform.hpp"

#include <algorithm>
#include <unsupported/Eigen/FFT>

namespace ringfilm::surface {
namespace {

using Wave = std::complex<double>;

constexpr std::size_t kColumnsTransformedAtATime = 8;

}  // namespace

struct GridTransform::Plan {
  Plan(std::size_t n_columns, std::size_t rows)
      : columns(n_columns), block(kColumnsTransformedAtATime * rows), turned(rows) {
    fft.SetFlag(Eigen::FFT<double>::Unscaled);
    fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  }

  Eigen::FFT<double> fft;
  std::size_t columns;
  std::vector<Wave> block, turned;
};

GridTransform::GridTransform(std::size_t points_x, std::size_t points_y)
    : points_x_(points_x), points_y_(points_y), plan_(std::make_unique<Plan>(points_x / 2 + 1, points_y)) {}

GridTransform::~GridTransform() = default;

/// Transforms all columns, forward or back, in place.
void GridTransform::transform_columns(std::span<Wave> waves, bool forward) {
  if (points_y_ == 1) return;
  const std::size_t columns = plan_->columns, rows = points_y_;
  std::vector<Wave>& block = plan_->block;
  for (std::size_t begin = 0; begin < columns; begin += kColumnsTransformedAtATime) {
    const std::size_t count = std::min(kColumnsTransformedAtATime, columns - begin);
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t c = 0; c < count; ++c) block[c * rows + j] = waves[j * columns + begin + c];
    }
    for (std::size_t c = 0; c < count; ++c) {
      Wave* const column = block.data() + c * rows;
      const auto length = static_cast<Eigen::Index>(rows);
      if (forward) {
        plan_->fft.fwd(plan_->turned.data(), column, length);
      } else {
        plan_->fft.inv(plan_->turned.data(), column, length);
      }
      std::copy(plan_->turned.begin(), plan_->turned.end(), column);
    }
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t c = 0; c < count; ++c) waves[j * columns + begin + c] = block[c * rows + j];
    }
  }
}

void GridTransform::forward(std::span<const double> values, std::span<Wave> waves) {
  for (std::size_t j = 0; j < points_y_; ++j) {
    plan_->fft.fwd(waves.data() + j * plan_->columns, values.data() + j * points_x_,
                   static_cast<Eigen::Index>(points_x_));
  }
  transform_columns(waves, true);
}

void GridTransform::back(std::span<Wave> waves, std::span<double> values) {
  transform_columns(waves, false);
  for (std::size_t j = 0; j < points_y_; ++j) {
    plan_->fft.inv(values.data() + j * points_x_, waves.data() + j * plan_->columns,
                   static_cast<Eigen::Index>(points_x_));
  }
  const double points = static_cast<double>(points_x_ * points_y_);
  for (double& value : values) value /= points;
}

std::vector<Wave> waves_of(std::span<const double> values, std::size_t points_x, std::size_t points_y) {
  GridTransform transform(points_x, points_y);
  std::vector<Wave> waves(transform.waves());
  transform.forward(values, waves);
  return waves;
}

std::vector<double> values_of(std::vector<Wave> waves, std::size_t points_x, std::size_t points_y) {
  std::vector<double> values(points_x * points_y);
  GridTransform(points_x, points_y).back(waves, values);
  return values;
}

double wave_number(std::size_t k, std::size_t n) {
  return k <= n / 2 ? static_cast<double>(k) : static_cast<double>(k) - static_cast<double>(n);
}

}  // namespace ringfilm::surface
