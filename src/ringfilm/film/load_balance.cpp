#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::film {

double asperity_load(const FilmProblem& problem, double h_m) {
  if (problem.contact == nullptr || h_m >= problem.contact->reach()) return 0;
  const FilmGrid& grid = problem.grid;
  const auto pressure = [&](double h) {
    double p_a = 0;
    double slope = 0;
    if (h < problem.contact->reach()) problem.contact->pressure(h, p_a, slope);
    return p_a;
  };
  if (problem.contact_spread == ContactSpread::kNominal) return grid.width * pressure(h_m);
  double load = 0;
  for (std::size_t i = 0; i < grid.x.size(); ++i) load += grid.share[i] * pressure(h_m + grid.node_height[i]);
  return load;
}

double hydrodynamic_load(const FilmProblem& problem, const FilmState& state) {
  double load = 0;
  for (std::size_t i = 0; i < state.p.size(); ++i) load += problem.grid.share[i] * state.p[i];
  return load;
}

}  // namespace ringfilm::film
