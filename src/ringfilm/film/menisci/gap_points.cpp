#include "ringfilm/film/menisci/gap_points.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {
namespace {

/// Height of a cell at a share of its length, by the parabola through its ends and its middle [m].
double height_in_cell(const FilmGrid& grid, std::size_t i, double share) {
  const double rest = 1 - share;
  return grid.node_height[i] * rest * (rest - share) + 4 * grid.face_height[i] * share * rest +
         grid.node_height[i + 1] * share * (share - rest);
}

std::size_t cell_at(const FilmGrid& grid, double x) {
  const auto next = std::upper_bound(grid.x.begin(), grid.x.end(), x) - grid.x.begin();
  return static_cast<std::size_t>(std::clamp(static_cast<int>(next) - 1, 0, grid.n_cells() - 1));
}

}  // namespace

double gap_height(const FilmGrid& grid, double x) {
  const std::size_t i = cell_at(grid, x);
  return height_in_cell(grid, i, (x - grid.x[i]) / grid.spacing[i]);
}

LowestPlace lowest_place(const FilmGrid& grid) {
  LowestPlace lowest{grid.x.front(), grid.node_height.front()};
  const auto look_at = [&](std::size_t i, double share) {
    const double height = height_in_cell(grid, i, share);
    if (height < lowest.height) lowest = {grid.x[i] + share * grid.spacing[i], height};
  };
  for (std::size_t i = 0; i < grid.face_height.size(); ++i) {
    const double first = grid.node_height[i], middle = grid.face_height[i], last = grid.node_height[i + 1];
    look_at(i, 0.5);
    look_at(i, 1);
    const double bend = first - 2 * middle + last;
    if (bend > 0) look_at(i, std::clamp(0.5 + 0.25 * (first - last) / bend, 0.0, 1.0));
  }
  constexpr double kAtEdge = 1e-3;  // share of a cell
  if (lowest.x < kAtEdge * grid.spacing.front()) return {0, grid.node_height.front()};
  if (lowest.x > grid.width - kAtEdge * grid.spacing.back()) return {grid.width, grid.node_height.back()};
  return lowest;
}

void GapPoints::set(const FilmGrid& grid, double h_m, double begin, double place, double end) {
  const double between = std::clamp(place, std::min(begin, end), std::max(begin, end));
  for (std::vector<double>* list : {&cell_, &x_, &h_, &weight_}) list->resize(most(grid));
  cells_ = 0;
  size_ = 1;
  x_[0] = begin;
  h_[0] = h_m + gap_height(grid, begin);
  weight_[0] = 0;
  if (between != begin) add_stretch(grid, h_m, begin, between);
  at_place_ = size() - 1;
  if (between != end) add_stretch(grid, h_m, between, end);
}

/// A cell from the last point on. @param middle,last gap there [m]
void GapPoints::add_cell(double to, double middle, double last) {
  const double from = x_[size_ - 1], length = std::abs(to - from);
  cell_[cells_++] = length;
  x_[size_] = 0.5 * (from + to);
  x_[size_ + 1] = to;
  h_[size_] = middle;
  h_[size_ + 1] = last;
  weight_[size_ - 1] += length / 6;
  weight_[size_] = 4 * length / 6;
  weight_[size_ + 1] = length / 6;
  size_ += 2;
}

void GapPoints::add_stretch(const FilmGrid& grid, double h_m, double begin, double end) {
  const bool forward = end > begin;
  std::size_t i = cell_at(grid, begin);
  const std::size_t last = cell_at(grid, end);
  if (!forward && begin == grid.x[i] && i > 0) --i;
  for (;; forward ? ++i : --i) {
    const double entry = forward ? grid.x[i] : grid.x[i + 1], exit = forward ? grid.x[i + 1] : grid.x[i];
    const double from = x_[size_ - 1], to = i == last ? end : exit;
    if (from == to) return;  // the stretch ends at the first node of its last cell
    if (from == entry && to == exit) {
      add_cell(to, h_m + grid.face_height[i], h_m + (forward ? grid.node_height[i + 1] : grid.node_height[i]));
    } else {
      const auto height = [&](double x) { return h_m + height_in_cell(grid, i, (x - grid.x[i]) / grid.spacing[i]); };
      add_cell(to, height(0.5 * (from + to)), height(to));
    }
    if (i == last) return;
  }
}

}  // namespace ringfilm::film
