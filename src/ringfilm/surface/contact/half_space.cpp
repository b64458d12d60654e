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

HalfSpace::HalfSpace(const ContactGrid& grid, double E_star) : grid_(grid) {
  const bool is_periodic = grid.edges == MapEdges::periodic;
  const std::size_t columns = is_periodic ? grid.points_x / 2 + 1 : grid.points_x;
  const std::vector<double> q_x = wave_numbers(columns, grid.points_x, grid.step_x_m, grid.edges);
  const std::vector<double> q_y =
      wave_numbers(grid.points_y, grid.points_y, grid.points_y > 1 ? grid.step_y_m : 1, grid.edges);
  for (const double q_along_y : q_y) {
    for (const double q_along_x : q_x) stiffness_.push_back(0.5 * E_star * std::hypot(q_along_x, q_along_y));
  }
  longest_ = std::numeric_limits<double>::max();
  if (q_x.size() > 1) longest_ = std::min(longest_, stiffness_[1]);
  if (q_y.size() > 1) longest_ = std::min(longest_, stiffness_[columns]);
  for (std::size_t k = 0; k < columns; ++k) {
    const bool is_its_own_image = k == 0 || (is_periodic && 2 * k == grid.points_x);
    images_x_.push_back(is_its_own_image ? 1 : 2);
  }
  images_y_.assign(grid.points_y, is_periodic ? 1.0 : 2.0);
  images_y_.front() = 1;
  if (is_periodic) {
    periodic_.emplace(grid.points_x, grid.points_y);
    periodic_waves_.resize(periodic_->waves());
  } else {
    mirrored_.emplace(grid.points_x, grid.points_y);
    mirrored_waves_.resize(grid.points());
  }
}

template <class Factor>
void HalfSpace::apply(std::span<const double> from, std::span<double> to, const Factor& factor) {
  const auto scale = [&](auto waves) {
    for (std::size_t k = 0; k < waves.size(); ++k) waves[k] *= factor(stiffness_[k]);
  };
  if (periodic_) {
    periodic_->forward(from, periodic_waves_);
    scale(std::span(periodic_waves_));
    periodic_->back(periodic_waves_, to);
  } else {
    std::copy(from.begin(), from.end(), to.begin());
    mirrored_->forward(to);
    scale(to);
    mirrored_->back(to);
  }
}

void HalfSpace::displace(std::span<const double> pressure, std::span<double> displacement) {
  apply(pressure, displacement, [](double stiffness) { return stiffness > 0 ? 1 / stiffness : 0.0; });
}

void HalfSpace::press(std::span<const double> displacement, std::span<double> pressure) {
  apply(displacement, pressure, [this](double stiffness) { return std::max(stiffness, longest_); });
}

double HalfSpace::work(std::span<const double> pressure) {
  if (periodic_) {
    periodic_->forward(pressure, periodic_waves_);
  } else {
    std::copy(pressure.begin(), pressure.end(), mirrored_waves_.begin());
    mirrored_->forward(mirrored_waves_);
  }
  const std::size_t columns = images_x_.size();
  double sum = 0;
  const auto add_row = [&](std::size_t j, const auto& waves) {
    double row = 0;
    for (std::size_t i = 0; i < columns; ++i) {
      const double stiffness = stiffness_[j * columns + i];
      if (stiffness > 0) row += images_x_[i] * std::norm(waves[j * columns + i]) / stiffness;
    }
    sum += images_y_[j] * row;
  };
  for (std::size_t j = 0; j < images_y_.size(); ++j) {
    periodic_ ? add_row(j, periodic_waves_) : add_row(j, mirrored_waves_);
  }
  return sum / static_cast<double>(grid_.points());
}

}  // namespace ringfilm::surface
