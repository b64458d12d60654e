#pragma once
#include <memory>
#include <span>
#include <vector>

namespace ringfilm::surface {

/// Weights of a sampled Gaussian, 1 in sum: weights[0] in the middle, weights[k] at k steps to both sides. They are cut
/// at 1.3 cut-offs, where 4e-11 of the middle is left, and so wide that just half of a wave of the cut-off passes,
/// which a plainly sampled Gaussian misses below 5 steps; eq-surface-gaussian.
/// @param cutoff_steps cut-off in steps, 2 or more
std::vector<double> gaussian_kernel(double cutoff_steps);

/// Convolves lines of equal length with a symmetric kernel; beyond the ends the data are 0. Short kernels are summed,
/// long ones go through a Fourier transform of two lines at a time.
class LineConvolution {
 public:
  LineConvolution(std::span<const double> kernel, std::size_t points);
  ~LineConvolution();
  LineConvolution(const LineConvolution&) = delete;
  LineConvolution& operator=(const LineConvolution&) = delete;

  /// Both lines in place; the second may be empty.
  void apply(std::span<double> first, std::span<double> second);

 private:
  struct Transform;
  void sum(std::span<double> line);

  std::vector<double> kernel_, padded_;
  std::unique_ptr<Transform> transform_;  // none for a short kernel
};

/// Convolves every row, then every column of points_x * points_y values in place. An empty kernel leaves a direction
/// alone.
void convolve_grid(std::span<double> values, std::size_t points_x, std::size_t points_y,
                   std::span<const double> kernel_x, std::span<const double> kernel_y);

/// The smallest number from n on that has no prime factor above 5: such transforms are fast.
std::size_t transform_length(std::size_t n);

}  // namespace ringfilm::surface
