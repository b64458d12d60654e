#include "ringfilm/cycle/integration/cycle_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "ringfilm/cycle/integration/twist_balance.hpp"
#include "ringfilm/film/load_balance.hpp"
#include "ringfilm/film/solver/first_guess.hpp"
#include "ringfilm/film/solver2d/bent_ring_guess.hpp"
#include "ringfilm/film/solver2d/film2d_factors.hpp"

namespace ringfilm::cycle {
namespace {

/// Cells before grading: fewer than usual may be why no film was found.
constexpr int kMinGraded = 200;
/// A film for which cells by gap are laid out, of the rise of the face. Between 0.01 and 0.3 the values of a cycle were
/// closest to those of 1600 cells with this one [-].
constexpr double kReferenceFilm = 0.03;
/// Factors of the separation of a ring off the liner that are tried one after the other, and where they end.
constexpr double kFurther = 1.2, kMaxFurther = 4;
/// Places at which the rise of the face is looked for.
constexpr int kSamplesOfFace = 250;

film::FilmProblem film_across(const Setup& setup) {
  const auto& input = setup.input;
  film::FilmProblem problem;
  problem.grid = face_grid(setup);
  problem.contact = setup.ring.contact.get();
  problem.land = setup.ring.land.get();
  problem.cavitation = input.film.cavitation == Cavitation::kMassConserving ? film::Cavitation::kMassConserving
                                                                            : film::Cavitation::kReynoldsExit;
  problem.contact_spread =
      input.contact.lambda_ratio == LambdaRatio::kLocal ? film::ContactSpread::kLocal : film::ContactSpread::kNominal;
  problem.tolerance = input.solver.tolerance;
  const bool is_plain = !input.film.has_gas_edge() && setup.ring.factors.are_of_plain_film();
  problem.terms = is_plain ? film::Terms::kPlain : film::Terms::kAll;
  problem.kernels = setup.kernels;
  return problem;
}

std::optional<film::ElasticFace> elastic_face(const Setup& setup, const film::FilmProblem& across) {
  if (setup.input.ring.local_deformation == LocalDeformation::kNone || setup.input.is_unrolled()) return std::nullopt;
  return film::ElasticFace(across.grid, setup.ring.E_prime);
}

std::optional<BendingRing> bending_ring(const Case& c) {
  if (!c.bends()) return std::nullopt;
  return BendingRing(c, strips_of(c));
}

/// Flattening of two half-spaces that a strip presses together, whose pressed part is a tenth of the face wide: (3.7)
/// between the middle of that part and the ends of the face, eq-ring-flattening [m2/N].
double flattening(double E_prime) {
  constexpr double kPressedPart = 0.1;
  return 4 / (std::numbers::pi * E_prime) * (std::log(1 / kPressedPart) + 1);
}

std::optional<film::Film2dProblem> film_on_ring(const Setup& setup, const film::FilmProblem& across,
                                                const std::optional<BendingRing>& ring) {
  if (!setup.input.is_unrolled()) return std::nullopt;
  film::Film2dProblem problem;
  problem.strip = across;
  problem.around = strips_of(setup.input);
  problem.gap = film::gap_of_strips(across.grid, problem.around);
  if (ring) problem.ring = ring->elastic_ring();
  if (ring && setup.surfaces == Surfaces::kFlattening) problem.ring.flattening = flattening(setup.ring.E_prime);
  return problem;
}

}  // namespace

film::FilmGrid face_grid(const Setup& setup) {
  const Solver& solver = setup.input.solver;
  const Ring& ring = setup.input.ring;
  const models::RingFace face =
      ring.face.orientation == Orientation::kX0Crankcase ? setup.ring.face.turned() : setup.ring.face;
  const double lowest = face.minimum().height;  // so that h_m is the true minimum film
  const auto height = [&](double x) { return face.height(x) - lowest; };
  const film::Turning turning =
      ring.face.orientation == Orientation::kLeadingEdge ? film::Turning::kPossible : film::Turning::kNever;
  if (setup.cells == CellsOfFace::kGraded) {
    return film::graded_grid(std::max(solver.cells, kMinGraded), ring.face_width, height, film::kAtom, turning);
  }
  if (solver.cell_lengths == CellLengths::kUniform) return film::uniform_grid(solver.cells, ring.face_width, height);
  double rise = 0;
  for (int k = 0; k <= kSamplesOfFace; ++k) rise = std::max(rise, height(ring.face_width * k / kSamplesOfFace));
  if (!(rise > 0)) return film::uniform_grid(solver.cells, ring.face_width, height);  // a flat face
  return film::grid_by_gap(solver.cells, ring.face_width, height, kReferenceFilm * rise, turning);
}

film::CircumferentialGrid strips_of(const Case& c) {
  const double length = c.ring_length();
  if (c.ring.end_gap) return film::refined_around(c.solver.cells_y, length, c.end_cell());
  film::CircumferentialGrid joined = film::uniform_around(c.solver.cells_y, length, film::Ends::kJoined);
  // The ends of a ring that bends are free, and no strip has both.
  for (std::size_t j = 0; j < joined.y.size() && c.bends(); ++j) joined.y[j] += 0.5 * length / c.solver.cells_y;
  return joined;
}

film::Film2dInputs film2d_inputs(const film::FilmInputs& inputs) {
  const double p_end = 0.5 * (inputs.left.pressure + inputs.right.pressure);
  return {inputs, p_end, p_end, {}, {}, {}};
}

film::Film2dInputs CycleFilm::film2d_inputs(const RingConditions& at) const {
  film::Film2dInputs inputs = cycle::film2d_inputs(at.inputs);
  if (ring_) ring_->press(at.below_tdc, at.crank_angle_deg, inputs);
  return inputs;
}

CycleFilm::Workspace CycleFilm::workspace_of(const Setup& setup, const CycleFilm& film) {
  if (film.film2d_) return film::Film2dWorkspace(*film.film2d_);
  if (setup.input.solver.method == Method::kPointRelaxation) return film::RelaxationWorkspace();
  return film::FilmWorkspace(film.across_);
}

CycleFilm::CycleFilm(const Setup& setup)
    : setup_(setup),
      across_(film_across(setup)),
      elastic_(elastic_face(setup, across_)),
      tilting_(setup.ring.twisting ? std::optional<film::TiltingFace>(across_.grid) : std::nullopt),
      factors_(across_, setup.ring.factors),
      ring_(bending_ring(setup.input)),
      film2d_(film_on_ring(setup, across_, ring_)),
      workspace_(workspace_of(setup, *this)) {}

film::FilmReport CycleFilm::solve_across(const film::FilmInputs& inputs, const film::FilmState& previous,
                                         film::FilmState& state) {
  return factors_.solve(inputs, state, [&](const film::FilmInputs& held, film::FilmState& found) {
    return film::solve_film(across_, held, previous, found, std::get<film::MethodWorkspace>(workspace_));
  });
}

film::FilmReport CycleFilm::solve(const RingConditions& at, const film::FilmState& previous, film::FilmState& state) {
  if (elastic_) {
    return elastic_->solve(across_, at.inputs, state,
                           [&](film::FilmState& found) { return solve_across(at.inputs, previous, found); });
  }
  if (tilting_) {
    return tilting_->solve(
        across_, state, [&](film::FilmState& found) { return solve_across(at.inputs, previous, found); },
        [&](const film::FilmState& found) { return balanced_twist(setup_, at, across_, previous, found); });
  }
  if (!film2d_) return solve_across(at.inputs, previous, state);
  return film::solve_with_factors(
      factors_.laws(), *film2d_, film2d_inputs(at), state, [&](const film::Film2dInputs& held, film::FilmState& found) {
        return film::solve_film2d(*film2d_, held, previous, found, std::get<film::Film2dWorkspace>(workspace_));
      });
}

bool CycleFilm::has_simple_gap() const {
  if (film2d_ || elastic_) return false;
  return std::holds_alternative<film::FilmWorkspace>(std::get<film::MethodWorkspace>(workspace_));
}

film::FilmReport CycleFilm::solve_off_liner(const RingConditions& at, const film::FilmState& previous,
                                            film::FilmState& state) {
  auto& workspace = std::get<film::FilmWorkspace>(std::get<film::MethodWorkspace>(workspace_));
  const film::FilmState guess = state;
  film::FilmReport report;
  // Where no film is found, one of a ring a little further off is: that distance is known roughly.
  for (double further = 1; further < kMaxFurther; further *= kFurther) {
    state = guess;
    state.h_m *= further;
    report = factors_.solve(at.inputs, state, [&](const film::FilmInputs& held, film::FilmState& found) {
      return film::solve_film_at_separation(across_, held, previous, found, workspace);
    });
    if (report.converged) break;
  }
  return report;
}

film::FilmReport CycleFilm::solve_steady(const RingConditions& at, film::FilmState& before, film::FilmState& state) {
  const film::FilmInputs& inputs = at.inputs;
  state = film::first_guess(across(), inputs);
  if (film2d_) {
    film::FilmWorkspace workspace(across());
    film::FilmState strip = state;
    if (film::solve_film(across(), inputs, state, strip, workspace).converged) state = std::move(strip);
    state = ring_ ? film::guess_of_bent_ring(*film2d_, film2d_inputs(at), state) : film::of_strips(*film2d_, state);
  }
  before = state;
  return solve(at, before, state);
}

}  // namespace ringfilm::cycle
