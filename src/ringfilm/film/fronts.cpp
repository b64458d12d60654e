#include "ringfilm/film/fronts.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {
namespace {

/// How many cells beyond its last node a film ends, by the pressures above p_c at its last three nodes, all of one
/// spacing: where the parabola through them has its lowest point if it touches p_c there, as at a rupture; where it
/// crosses p_c if it does so at a slope, as where film forms again (docs/theory/film.md, "fronts between nodes").
double cells_beyond(double last, double before, double third, double lowest_point) {
  const double bend = third - 2 * before + last;
  const double slope = before - last - 0.5 * bend;  // at the last node, falling outwards
  const double root = std::sqrt(std::max(slope * slope - 2 * bend * last, 0.0));
  const double crossing = slope + root > 0 ? std::min(2 * last / (slope + root), 1.0) : 1.0;
  if (bend <= 0) return crossing;
  // Cells are too coarse to resolve a slope of less than half of what the bend makes in one of them.
  const double share = std::clamp(root / bend - 0.5, 0.0, 1.0);
  return lowest_point + share * (crossing - lowest_point);
}

}  // namespace

bool ends_level(const FilmProblem& problem, const FilmInputs& inputs, bool cavity_on_right) {
  return problem.cavitation == Cavitation::kReynoldsExit || (inputs.U >= 0) == cavity_on_right;
}

double front_position(const FilmGrid& grid, const double* p, double p_c, int i, int outer, bool ends_level) {
  const double cell = grid.x[outer] - grid.x[i];  // negative where the film lies on the right
  const auto above = [&](int node) { return p[node] - p_c; };
  const int before = 2 * i - outer;
  const int third = 3 * i - 2 * outer;
  const int n = grid.n_cells();
  if (before < 0 || before > n) return grid.x[i] + (above(i) > 0 ? 0.5 * cell : 0.0);  // node i is an edge
  // At the lowest place, where gas has broken through, the film beyond has less pressure than the gas.
  if (above(i) < 0 || above(before) < 0) return grid.x[i] + 0.5 * cell;
  const double last = above(i), spacing = (grid.x[i] - grid.x[before]) / cell;
  if (third >= 0 && third <= n) {
    // The parabola through the three, at distances of one cell.
    const double next = (grid.x[before] - grid.x[third]) / cell;
    const double first = (above(before) - last) / spacing, second = (above(third) - above(before)) / next;
    const double half_bend = (second - first) / (spacing + next), slope = first - half_bend * spacing;
    // By the balance of mass of node i.
    const double source = 2 * (first - last) / (spacing + 1);
    constexpr double kFarthest = 1.5;
    const double rupture = source > 0 ? std::min(first / source - 0.5 * spacing, kFarthest) : kFarthest;
    if (ends_level && source > 0) return grid.x[i] + std::max(rupture, 0.0) * cell;
    const double before_1 = last + slope + half_bend, before_2 = last + 2 * slope + 4 * half_bend;
    return grid.x[i] + cells_beyond(last, before_1, before_2, rupture) * cell;
  }
  const double fall = above(before) - last;
  const double straight = fall > 0 ? last / fall * spacing : 1.0;
  return grid.x[i] + std::min(straight, 1.0) * cell;
}

}  // namespace ringfilm::film
