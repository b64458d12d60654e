#pragma once
#include <functional>
#include <memory>

#include "ringfilm/film/integrals/film_integrals.hpp"
#include "ringfilm/film/solver/film_solver.hpp"
#include "ringfilm/film/solver/first_guess.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"

/// Films of constant oil between smooth surfaces, for which books have answers.
namespace ringfilm::film::testing {

/// Owns what a FilmProblem refers to.
struct SmoothFilm {
  std::shared_ptr<const models::OilAtTemperature> oil;
  models::GreenwoodTripp no_contact;
  FilmProblem problem;

  SmoothFilm(int n_cells, double width, const std::function<double(double)>& height, double eta, Cavitation cavitation)
      : oil(models::closed_form_oil(eta, 1.0, 0.0, {0.0, 0.0})), no_contact({1.0, 1e-9, 1e-12, 1.0}) {
    problem.grid = uniform_grid(n_cells, width, height);
    problem.contact = &no_contact;
    problem.cavitation = cavitation;
    problem.tolerance = 1e-10;
  }

  /// At rest and without load.
  FilmInputs inputs() const {
    FilmInputs inputs;
    inputs.oil = oil;
    return inputs;
  }
};

struct Solved {
  FilmState state;
  FilmReport report;
  FilmIntegrals integrals;
};

/// Steady film from a first guess at `h_m`, by one of the two solvers of film_solver.hpp.
inline Solved steady(const FilmProblem& problem, const FilmInputs& inputs, double h_m, decltype(&solve_film) solver) {
  FilmWorkspace workspace(problem);
  const FilmState previous = first_guess(problem, inputs);
  Solved solved;
  solved.state = previous;
  solved.state.h_m = h_m;
  solved.report = solver(problem, inputs, previous, solved.state, workspace);
  solved.integrals = film_integrals(problem, inputs, previous, solved.state);
  return solved;
}

/// Steady film at a given separation.
inline Solved steady_at(const FilmProblem& problem, const FilmInputs& inputs, double h_m) {
  return steady(problem, inputs, h_m, solve_film_at_separation);
}

/// Steady film under a given load.
inline Solved steady_under_load(const FilmProblem& problem, const FilmInputs& inputs, double guess_h_m) {
  return steady(problem, inputs, guess_h_m, solve_film);
}

}  // namespace ringfilm::film::testing
