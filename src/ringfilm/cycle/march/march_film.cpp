#include "ringfilm/cycle/march/march_film.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/film/first_guess.hpp"
#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::cycle {
namespace {

/// Cells before grading: fewer than usual may be why no film was found.
constexpr int kFewestGraded = 200;

film::FilmProblem film_across(const Setup& setup) {
  const auto& input = setup.input;
  film::FilmProblem problem;
  problem.grid = face_grid(setup);
  problem.oil = setup.oil.get();
  problem.contact = &setup.contact;
  problem.cavitation = input.film.cavitation == Cavitation::kMassConserving ? film::Cavitation::kMassConserving
                                                                            : film::Cavitation::kReynoldsExit;
  problem.contact_spread = input.contact.film_parameter == FilmParameter::kLocal ? film::ContactSpread::kLocal
                                                                                 : film::ContactSpread::kNominal;
  problem.tolerance = input.solver.tolerance;
  problem.kernels = setup.kernels;
  return problem;
}

std::optional<sheet::SheetProblem> film_on_ring(const Setup& setup, const film::FilmProblem& across) {
  if (!setup.input.is_unrolled()) return std::nullopt;
  sheet::SheetProblem problem;
  problem.strip = across;
  problem.around = strips_of(setup.input);
  problem.gap = sheet::gap_of_strips(across.grid, problem.around);
  return problem;
}

film::Method film_method(Method method) {
  switch (method) {
    case Method::kPointRelaxation:
      return film::Method::kPointRelaxation;
    case Method::kNestedSecant:
      return film::Method::kNestedSecant;
    case Method::kCoupledNewton:
      break;
  }
  return film::Method::kCoupledNewton;
}

}  // namespace

film::FilmGrid face_grid(const Setup& setup) {
  const Solver& solver = setup.input.solver;
  const Ring& ring = setup.input.ring;
  const models::RingFace face = ring.face.orientation == Orientation::kX0Crankcase ? setup.face.turned() : setup.face;
  const double lowest = face.minimum().height;  // so that h_m is the true minimum film
  const auto height = [&](double x) { return face.height(x) - lowest; };
  if (setup.cells == CellsOfFace::kUniform) return film::uniform_grid(solver.cells, ring.face_width, height);
  const bool turns = ring.face.orientation == Orientation::kLeadingEdge;
  return film::graded_grid(std::max(solver.cells, kFewestGraded), ring.face_width, height, film::kAtom,
                           turns ? film::Turning::kPossible : film::Turning::kNever);
}

sheet::Around strips_of(const Case& c) {
  const double length = c.ring_length();
  return c.ring.end_gap ? sheet::refined_around(c.solver.cells_y, length, c.end_cell())
                        : sheet::uniform_around(c.solver.cells_y, length, sheet::Ends::kJoined);
}

sheet::SheetInputs sheet_inputs(const film::FilmInputs& inputs) {
  const double p_end = 0.5 * (inputs.left.pressure + inputs.right.pressure);
  return {inputs, p_end, p_end, {}};
}

MarchFilm::Workspace MarchFilm::workspace_of(const Setup& setup, const MarchFilm& film) {
  if (film.sheet_) return sheet::SheetWorkspace(*film.sheet_);
  return film::workspace_of(film_method(setup.input.solver.method), film.across_);
}

MarchFilm::MarchFilm(const Setup& setup)
    : across_(film_across(setup)), sheet_(film_on_ring(setup, across_)), workspace_(workspace_of(setup, *this)) {}

film::FilmReport MarchFilm::solve(const film::FilmInputs& inputs, const film::FilmState& previous,
                                  film::FilmState& state) {
  if (!sheet_) return film::solve_film(across_, inputs, previous, state, std::get<film::MethodWorkspace>(workspace_));
  return sheet::solve_sheet(*sheet_, sheet_inputs(inputs), previous, state,
                            std::get<sheet::SheetWorkspace>(workspace_));
}

film::FilmReport MarchFilm::solve_steady(const film::FilmInputs& inputs, film::FilmState& before,
                                         film::FilmState& state) {
  state = film::first_guess(across(), inputs);
  if (sheet_) {
    film::FilmWorkspace workspace(across());
    film::FilmState strip = state;
    if (film::solve_film(across(), inputs, state, strip, workspace).converged) state = std::move(strip);
    state = sheet::of_strips(*sheet_, state);
  }
  before = state;
  return solve(inputs, before, state);
}

}  // namespace ringfilm::cycle
