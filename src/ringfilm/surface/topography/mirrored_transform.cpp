#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "ringfilm/surface/topography/grid_transform.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMirroredLinesAtATime = 8;  // even: two lines share a transform

}  // namespace

/// Cosine transforms of two lines at once: they are the real and the imaginary part of one line, in the order 0, 2, 4,
/// ..., 5, 3, 1 (Makhoul 1980).
class LineTransform {
 public:
  explicit LineTransform(std::size_t n) : n_(n), turn_(n), line_(n), waves_(n) {
    fft_.SetFlag(Eigen::FFT<double>::Unscaled);
    for (std::size_t k = 0; k < n; ++k) {
      turn_[k] = std::polar(1.0, -std::numbers::pi * static_cast<double>(k) / (2 * static_cast<double>(n)));
    }
  }

  /// sum over j of a[j] cos(pi k (j + 1/2)/n), and of b.
  void forward(double* a, double* b) {
    for (std::size_t j = 0; j < n_; ++j) line_[place(j)] = {a[j], b[j]};
    fft_.fwd(waves_.data(), line_.data(), static_cast<Eigen::Index>(n_));
    for (std::size_t k = 0; k < n_; ++k) {
      const Wave one = waves_[k], other = std::conj(waves_[k == 0 ? 0 : n_ - k]);
      const Wave sum = one + other, difference = one - other;
      a[k] = 0.5 * (turn_[k].real() * sum.real() - turn_[k].imag() * sum.imag());
      b[k] = 0.5 * (turn_[k].real() * difference.imag() + turn_[k].imag() * difference.real());
    }
  }

  /// The lines of such waves.
  void back(double* a, double* b) {
    for (std::size_t k = 0; k < n_; ++k) {
      const double a_rest = k == 0 ? 0 : a[n_ - k], b_rest = k == 0 ? 0 : b[n_ - k];
      // Waves of the line of a, and i times those of b.
      waves_[k] = std::conj(turn_[k]) * Wave(a[k] + b_rest, b[k] - a_rest);
    }
    fft_.inv(line_.data(), waves_.data(), static_cast<Eigen::Index>(n_));
    const double scale = 1 / static_cast<double>(n_);
    for (std::size_t j = 0; j < n_; ++j) {
      a[j] = scale * line_[place(j)].real();
      b[j] = scale * line_[place(j)].imag();
    }
  }

 private:
  using Wave = std::complex<double>;
  std::size_t place(std::size_t j) const { return j % 2 == 0 ? j / 2 : n_ - 1 - j / 2; }

  std::size_t n_;
  Eigen::FFT<double> fft_;
  std::vector<Wave> turn_, line_, waves_;
};

struct MirroredTransform::Plan {
  Plan(std::size_t points_x, std::size_t points_y)
      : along_x(points_x), along_y(points_y), spare(points_x), block(kMirroredLinesAtATime * points_y) {}

  LineTransform along_x, along_y;
  std::vector<double> spare, block;
};

MirroredTransform::MirroredTransform(std::size_t points_x, std::size_t points_y)
    : points_x_(points_x), points_y_(points_y), plan_(std::make_unique<Plan>(points_x, points_y)) {}

MirroredTransform::~MirroredTransform() = default;

void MirroredTransform::transform_rows(std::span<double> grid, bool forward) {
  for (std::size_t j = 0; j < points_y_; j += 2) {
    double* const a = grid.data() + j * points_x_;
    const bool is_alone = j + 1 == points_y_;
    if (is_alone) std::fill(plan_->spare.begin(), plan_->spare.end(), 0.0);
    double* const b = is_alone ? plan_->spare.data() : a + points_x_;
    forward ? plan_->along_x.forward(a, b) : plan_->along_x.back(a, b);
  }
}

void MirroredTransform::transform_columns(std::span<double> grid, bool forward) {
  if (points_y_ == 1) return;
  const std::size_t rows = points_y_;
  std::vector<double>& block = plan_->block;
  for (std::size_t begin = 0; begin < points_x_; begin += kMirroredLinesAtATime) {
    const std::size_t count = std::min(kMirroredLinesAtATime, points_x_ - begin);
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t c = 0; c < count; ++c) block[c * rows + j] = grid[j * points_x_ + begin + c];
      if (count % 2 == 1) block[count * rows + j] = 0;  // shares the transform of the last one
    }
    for (std::size_t c = 0; c < count; c += 2) {
      double *const a = block.data() + c * rows, *const b = a + rows;
      forward ? plan_->along_y.forward(a, b) : plan_->along_y.back(a, b);
    }
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t c = 0; c < count; ++c) grid[j * points_x_ + begin + c] = block[c * rows + j];
    }
  }
}

void MirroredTransform::forward(std::span<double> grid) {
  transform_rows(grid, true);
  transform_columns(grid, true);
}

void MirroredTransform::back(std::span<double> grid) {
  transform_columns(grid, false);
  transform_rows(grid, false);
}

}  // namespace ringfilm::surface
