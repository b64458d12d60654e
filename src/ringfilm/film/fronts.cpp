#include "ringfilm/film/fronts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ringfilm::film {
namespace {

/// Cells beyond its last node within which a film ends.
constexpr double kFarthest = 1.5;

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

/// How many cells beyond its last node a film ends that ends level, by the balance of mass of its last two nodes: what
/// they gain or lose, the bend of the pressure, goes on as a straight line up to where the slope of the pressure is 0.
/// @param first, second slopes of the last two cells between nodes, falling outwards, and `last` that to a node at p_c
/// Nothing where the pressure does not bend that way.
/// @param spacing, next lengths of these two cells; all in lengths of the cell that holds the end
std::optional<double> level_end(double first, double second, double last, double spacing, double next) {
  const double bend = 2 * (first - last) / (1 + spacing), bend_before = 2 * (second - first) / (spacing + next);
  const double at_face = 0.5 * (bend + bend_before), growth = (bend - bend_before) / spacing;
  const double root = at_face * at_face + 2 * growth * first;
  const double straight = root > 0 ? at_face + std::sqrt(root) : 0;
  if (straight <= 0 && bend <= 0) return std::nullopt;
  // Where a straight line has no such place, the bend of the last node alone.
  const double from_face = straight > 0 ? 2 * first / straight : first / bend;
  return std::clamp(from_face - 0.5 * spacing, 0.0, kFarthest);
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
    const std::optional<double> level = level_end(first, second, last, spacing, next);
    if (ends_level && level) return grid.x[i] + *level * cell;
    const double before_1 = last + slope + half_bend, before_2 = last + 2 * slope + 4 * half_bend;
    return grid.x[i] + cells_beyond(last, before_1, before_2, level.value_or(kFarthest)) * cell;
  }
  const double fall = above(before) - last;
  const double straight = fall > 0 ? last / fall * spacing : 1.0;
  return grid.x[i] + std::min(straight, 1.0) * cell;
}

}  // namespace ringfilm::film
