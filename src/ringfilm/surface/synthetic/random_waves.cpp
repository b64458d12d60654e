#include "ringfilm/surface/synthetic/random_waves.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/synthetic/random_numbers.hpp"
#include "ringfilm/surface/topography/gaussian_kernel.hpp"
#include "ringfilm/surface/topography/grid_transform.hpp"

namespace ringfilm::surface {
namespace {

constexpr std::size_t kMaxWavePoints = std::size_t{1} << 28;

void check_grid(const SurfaceGrid& grid) {
  const auto is_step = [](double step) { return std::isfinite(step) && step > 0; };
  if (grid.points_x < 2 || grid.points_y < 1 || grid.points_x > kMaxWavePoints / grid.points_y ||
      !is_step(grid.step_x_m) || !is_step(grid.step_y_m)) {
    throw InputError("a surface of " + std::to_string(grid.points_x) + " x " + std::to_string(grid.points_y) +
                         " points cannot be made",
                     "2 x 1 to 2^28 points with positive steps");
  }
}

}  // namespace

RandomWaves::RandomWaves(const SurfaceGrid& grid, std::uint64_t seed) : grid_(grid) {
  check_grid(grid);
  whole_x_ = transform_length(grid.points_x);
  whole_y_ = transform_length(grid.points_y);
  std::vector<double> noise(whole_x_ * whole_y_);
  RandomNumbers random(seed);
  for (double& value : noise) value = random.normal();
  waves_ = waves_of(noise, whole_x_, whole_y_);
}

HeightMap RandomWaves::surface(const PowerSpectrum& spectrum) const {
  const std::size_t columns = whole_x_ / 2 + 1;
  const double per_x = 1 / (static_cast<double>(whole_x_) * grid_.step_x_m);
  const double per_y = 1 / (static_cast<double>(whole_y_) * grid_.step_y_m);
  std::vector<std::complex<double>> waves = waves_;
  double power = 0;
  for (std::size_t k = 0; k < whole_y_; ++k) {
    double row_power = 0;
    for (std::size_t m = 0; m < columns; ++m) {
      const bool mean = k == 0 && m == 0;
      const double density = mean ? 0.0 : spectrum(static_cast<double>(m) * per_x, wave_number(k, whole_y_) * per_y);
      if (!(std::isfinite(density) && density >= 0)) {
        throw InputError("the power spectrum of a synthetic surface is negative or not a number");
      }
      const bool own_mirror = m == 0 || 2 * m == whole_x_;
      row_power += (own_mirror ? 1 : 2) * density;
      waves[k * columns + m] *= std::sqrt(density);
    }
    power += row_power;
  }
  if (!(power > 0)) {
    throw InputError("the power spectrum of a synthetic surface is zero on all waves of its grid",
                     "take finer steps or more points");
  }
  const std::vector<double> heights = values_of(std::move(waves), whole_x_, whole_y_);
  const double factor = 1 / std::sqrt(power / static_cast<double>(whole_x_ * whole_y_));
  HeightMap map{grid_.points_x, grid_.points_y, grid_.step_x_m, grid_.step_y_m, {}, {}};
  map.height_m.resize(map.points());
  for (std::size_t j = 0; j < map.points_y; ++j) {
    for (std::size_t i = 0; i < map.points_x; ++i) {
      map.height_m[map.index(i, j)] = factor * heights[j * whole_x_ + i];
    }
  }
  return map;
}

}  // namespace ringfilm::surface
