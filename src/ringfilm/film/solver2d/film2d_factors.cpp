#include "ringfilm/film/solver2d/film2d_factors.hpp"

#include "ringfilm/film/factors/factor_iteration.hpp"

namespace ringfilm::film {
namespace {

/// Calls visit(strip, its separation where that of the film is h_m), the strip with its gap in place of the mean one.
template <class Visit>
void for_strips(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& state, double h_m,
                const Visit& visit) {
  const std::vector<double> rise = rise_of_strips(problem, inputs, state.ring);
  FilmProblem strip = problem.strip;
  const int n_across = problem.n_across();
  for (int j = 0; j < problem.around.n_strips(); ++j) {
    strip.grid.node_height = row_of_strip(problem.gap.node, j, n_across);
    strip.grid.face_height = row_of_strip(problem.gap.face_x, j, n_across - 1);
    visit(j, strip, h_m + (rise.empty() ? 0.0 : rise[j]));
  }
}

void append(const std::vector<double>& strip, std::vector<double>& to) {
  to.insert(to.end(), strip.begin(), strip.end());
}

FilmHeights heights(const Film2dProblem& problem, const Film2dInputs& inputs, const FilmState& state) {
  FilmHeights all;
  for_strips(problem, inputs, state, state.h_m, [&](int, const FilmProblem& strip, double h) {
    const FilmHeights of = film_heights(strip.grid, h);
    append(of.node, all.node);
    append(of.face, all.face);
  });
  return all;
}

}  // namespace

std::shared_ptr<const FlowFactors> film2d_factors(const FactorLaws& laws, const Film2dProblem& problem,
                                                  const Film2dInputs& inputs, const FilmState& state, double h_m) {
  auto all = std::make_shared<FlowFactors>();
  FilmState of_strip;
  of_strip.laws = state.laws;
  for_strips(problem, inputs, state, h_m, [&](int j, const FilmProblem& strip, double h) {
    of_strip.p = row_of_strip(state.p, j, problem.n_across());
    const auto factors = flow_factors(laws, strip, inputs.strip, of_strip, h, FlowDirections::kBoth);
    for (const auto list : kFactorLists) append((*factors).*list, (*all).*list);
  });
  return all;
}

FilmReport solve_with_factors(const FactorLaws& laws, const Film2dProblem& problem, const Film2dInputs& inputs,
                              FilmState& state, const SolveFilm2d& solve) {
  if (laws.are_of_plain_film()) return solve(inputs, state);
  using Factors = FilmOfFactors::Factors;
  Film2dInputs held = inputs;
  return iterate_factors(
      {[&](const FilmState& of, double h_m) { return film2d_factors(laws, problem, inputs, of, h_m); },
       [&](const Factors& one, const Factors& other, const FilmState& of) {
         return difference(*one, *other, heights(problem, inputs, of));
       },
       [&](const Factors& factors, FilmState& of) {
         held.strip.factors = factors;
         return solve(held, of);
       }},
      enough_of_factors(problem.strip), state);
}

}  // namespace ringfilm::film
