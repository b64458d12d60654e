#include "ringfilm/film/gas_holding.hpp"

#include <algorithm>

namespace ringfilm::film {
namespace {

double inverse_cube(double h) { return 1 / (h * h * h); }

}  // namespace

double gas_holding_integral(const FilmGrid& grid, double h_m, FilmEdge exit) {
  const int n = grid.n_cells();
  const bool to_right = exit == FilmEdge::kRight;
  const auto node = [&](int k) { return h_m + grid.node_height[to_right ? k : n - k]; };
  double squares = 0, cubes = 0, largest = 0;  // int dx/h^2 and int dx/h^3 from the inlet
  for (int k = 0; k <= n; ++k) {
    largest = std::max(largest, squares - node(k) * cubes);
    if (k == n) break;
    const int cell = to_right ? k : n - 1 - k;
    const double before = node(k), middle = h_m + grid.face_height[cell], after = node(k + 1);
    const double sixth = grid.spacing[cell] / 6;
    squares += sixth * (1 / (before * before) + 4 / (middle * middle) + 1 / (after * after));
    cubes += sixth * (inverse_cube(before) + 4 * inverse_cube(middle) + inverse_cube(after));
  }
  return largest;
}

double mean_viscosity(const models::OilAtTemperature& oil, double p_low, double p_high) {
  return 6 / (1 / oil.viscosity(p_low) + 4 / oil.viscosity(0.5 * (p_low + p_high)) + 1 / oil.viscosity(p_high));
}

}  // namespace ringfilm::film
