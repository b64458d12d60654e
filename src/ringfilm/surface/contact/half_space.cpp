#include "ringfilm/surface/contact/half_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ringfilm::surface {
namespace {

using std::numbers::pi;

/// Wave numbers of an axis [rad/m].
std::vector<double> wave_numbers(std::size_t count, std::size_t points, double step, MapEdges edges) {
  std::vector<double> q(count);
  const double length = static_cast<double>(points) * step;
  for (std::size_t k = 0; k < count; ++k) {
    q[k] = edges == MapEdges::mirrored ? pi * static_cast<double>(k) / length
                                       : 2 * pi * std::abs(wave_number(k, points)) / length;
  }
  return q;
}

}  // namespace

HalfSpace::HalfSpace(const ContactGrid& grid, double E_star) : grid_(grid), stiffness_(E_star / 2) {
  const bool is_periodic = grid.edges == MapEdges::periodic;
  const std::size_t columns = is_periodic ? grid.points_x / 2 + 1 : grid.points_x;
  q_x_ = wave_numbers(columns, grid.points_x, grid.step_x_m, grid.edges);
  q_y_ = wave_numbers(grid.points_y, grid.points_y, grid.points_y > 1 ? grid.step_y_m : 1, grid.edges);
  longest_ = std::numeric_limits<double>::max();
  if (q_x_.size() > 1) longest_ = std::min(longest_, q_x_[1]);
  if (q_y_.size() > 1) longest_ = std::min(longest_, q_y_[1]);
  if (is_periodic) {
    periodic_.emplace(grid.points_x, grid.points_y);
    waves_.resize(periodic_->waves());
  } else {
    mirrored_.emplace(grid.points_x, grid.points_y);
  }
}

void HalfSpace::displace(std::span<const double> pressure, std::span<double> displacement) {
  apply(pressure, displacement, Direction::to_displacement);
}

void HalfSpace::press(std::span<const double> displacement, std::span<double> pressure) {
  apply(displacement, pressure, Direction::to_pressure);
}

void HalfSpace::apply(std::span<const double> from, std::span<double> to, Direction direction) {
  const auto filter = [&](auto waves) {
    const std::size_t columns = q_x_.size();
    for (std::size_t j = 0; j < q_y_.size(); ++j) {
      for (std::size_t i = 0; i < columns; ++i) {
        const double q = std::sqrt(q_x_[i] * q_x_[i] + q_y_[j] * q_y_[j]);
        auto& wave = waves[j * columns + i];
        if (direction == Direction::to_pressure) {
          wave *= stiffness_ * std::max(q, longest_);
        } else {
          wave *= q > 0 ? 1 / (stiffness_ * q) : 0.0;
        }
      }
    }
  };
  if (periodic_) {
    periodic_->forward(from, waves_);
    filter(std::span<std::complex<double>>(waves_));
    periodic_->back(waves_, to);
  } else {
    std::copy(from.begin(), from.end(), to.begin());
    mirrored_->forward(to);
    filter(to);
    mirrored_->back(to);
  }
}

}  // namespace ringfilm::surface
