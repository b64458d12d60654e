#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "ringfilm/base/error.hpp"
#include "ringfilm/surface/contact/rough_contact.hpp"
#include "ringfilm/surface/topography/regions.hpp"

namespace ringfilm::surface {
namespace {

/// Calls `visit` for each pair of neighbours along x and y, across the edges of a periodic map, too.
template <class Visit>
void for_neighbours(const ContactGrid& grid, const Visit& visit) {
  const bool wraps = grid.edges == MapEdges::periodic;
  for (std::size_t j = 0; j < grid.points_y; ++j) {
    for (std::size_t i = 0; i < grid.points_x; ++i) {
      const std::size_t point = j * grid.points_x + i;
      if (i + 1 < grid.points_x || (wraps && grid.points_x > 1)) {
        visit(point, j * grid.points_x + (i + 1) % grid.points_x);
      }
      if (j + 1 < grid.points_y || (wraps && grid.points_y > 1)) {
        visit(point, (j + 1) % grid.points_y * grid.points_x + i);
      }
    }
  }
}

/// Index of a point among the images of a map with `points` points.
std::size_t mirrored_index(std::size_t k, std::size_t points) {
  const std::size_t within = k % (2 * points);
  return within < points ? within : 2 * points - 1 - within;
}

}  // namespace

std::size_t count_spots(std::span<const std::uint8_t> contact, const ContactGrid& grid) {
  std::vector<std::size_t> parent(contact.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t point) {
    while (parent[point] != point) {
      parent[point] = parent[parent[point]];
      point = parent[point];
    }
    return point;
  };
  for_neighbours(grid, [&](std::size_t a, std::size_t b) {
    if (contact[a] == 0 || contact[b] == 0) return;
    const std::size_t first = root(a), second = root(b);
    parent[std::max(first, second)] = std::min(first, second);
  });
  std::size_t count = 0;
  for (std::size_t point = 0; point < contact.size(); ++point) {
    if (contact[point] != 0 && parent[point] == point) ++count;
  }
  return count;
}

double corrected_area_share(std::span<const std::uint8_t> contact, const ContactGrid& grid, double points) {
  constexpr double kAreaOfSide = (std::numbers::pi - 1 + std::numbers::ln2) / 24;  // @cite yastrebov2017
  double touching = 0, sides = 0;
  for (const std::uint8_t mark : contact) touching += mark != 0 ? 1 : 0;
  for_neighbours(grid, [&](std::size_t a, std::size_t b) { sides += contact[a] != contact[b] ? 1 : 0; });
  return (touching - kAreaOfSide * sides) / points;
}

HeightMap sum_of_surfaces(const HeightMap& first, const HeightMap& second, MapEdges edges, std::size_t shift_x,
                          std::size_t shift_y) {
  const auto differs = [](double a, double b) { return !(std::abs(a / b - 1) < 1e-6); };
  if (differs(first.step_x_m, second.step_x_m) ||
      (!first.is_profile() && !second.is_profile() && differs(first.step_y_m, second.step_y_m))) {
    throw InputError(
        "the steps of the two maps differ: " + length_text(first.step_x_m) + " and " + length_text(second.step_x_m),
        "measure both with one step, or resample one of them");
  }
  if (first.is_profile() != second.is_profile()) {
    throw InputError("one of the surfaces is a profile, the other one a map", "two maps, or two profiles");
  }
  const bool is_periodic = edges == MapEdges::periodic;
  if (is_periodic && (first.points_x != second.points_x || first.points_y != second.points_y)) {
    throw InputError("two maps of different sizes do not repeat together", "cut them to one size, or --mirrored");
  }
  HeightMap sum = part_of_map(
      first, {0, 0, std::min(first.points_x, second.points_x), std::min(first.points_y, second.points_y), 0});
  const auto place = [&](std::size_t k, std::size_t points) {
    return is_periodic ? k % points : mirrored_index(k, points);
  };
  if (sum.missing.empty() && !second.missing.empty()) sum.missing.assign(sum.points(), std::uint8_t{0});
  for (std::size_t j = 0; j < sum.points_y; ++j) {
    const std::size_t row = place(j + shift_y, second.points_y);
    for (std::size_t i = 0; i < sum.points_x; ++i) {
      const std::size_t to = sum.index(i, j), from = second.index(place(i + shift_x, second.points_x), row);
      if (sum.measured(to) && second.measured(from)) {
        sum.height_m[to] += second.height_m[from];
      } else {
        sum.missing[to] = 1;
        sum.height_m[to] = 0;
      }
    }
  }
  return sum;
}

}  // namespace ringfilm::surface
