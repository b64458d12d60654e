#pragma once
#include <complex>
#include <memory>
#include <span>
#include <vector>

namespace ringfilm::surface {

/// Fourier transform of real grids of one size, forward and back, with the memory for both: for what is transformed
/// again and again.
class GridTransform {
 public:
  GridTransform(std::size_t points_x, std::size_t points_y);
  ~GridTransform();

  /// points_x/2 + 1 waves along x, points_y along y, row after row, not scaled.
  void forward(std::span<const double> values, std::span<std::complex<double>> waves);
  /// The grid of such waves, divided by the number of points; leaves the waves transformed along y.
  void back(std::span<std::complex<double>> waves, std::span<double> values);

  std::size_t waves() const { return (points_x_ / 2 + 1) * points_y_; }  ///< how many there are

 private:
  struct Plan;
  void transform_columns(std::span<std::complex<double>> waves, bool forward);

  std::size_t points_x_, points_y_;
  std::unique_ptr<Plan> plan_;
};

/// Fourier transform of a real grid: points_x/2 + 1 waves along x, points_y along y, row after row, not scaled.
std::vector<std::complex<double>> waves_of(std::span<const double> values, std::size_t points_x, std::size_t points_y);

/// The grid of such waves, divided by the number of points: the way back.
std::vector<double> values_of(std::vector<std::complex<double>> waves, std::size_t points_x, std::size_t points_y);

/// Frequency of wave k of n, in waves over the whole length: 0, 1, ..., n/2, ..., -1.
double wave_number(std::size_t k, std::size_t n);

/// Cosine transform of real grids of one size, each axis continued by its mirror image about the half points beyond its
/// ends: of n heights n waves of k/(2 n) per point, k = 0, ..., n - 1. It equals the Fourier transform of the tile of
/// two by two images at a quarter of its cost, eq-cosine-transform.
class MirroredTransform {
 public:
  MirroredTransform(std::size_t points_x, std::size_t points_y);
  ~MirroredTransform();

  void forward(std::span<double> grid);  ///< heights to waves in place, not scaled
  void back(std::span<double> grid);     ///< waves to heights in place: the inverse of forward

 private:
  struct Plan;
  void transform_rows(std::span<double> grid, bool forward);
  void transform_columns(std::span<double> grid, bool forward);

  std::size_t points_x_, points_y_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace ringfilm::surface
