#pragma once
#include <optional>
#include <variant>

#include "ringfilm/cycle/closure/bending_ring.hpp"
#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/elastic_face.hpp"
#include "ringfilm/film/factors/factor_iteration.hpp"
#include "ringfilm/film/integrals/film_heating.hpp"
#include "ringfilm/film/solver/method.hpp"
#include "ringfilm/film/solver2d/film2d_solver.hpp"
#include "ringfilm/film/tilting_face.hpp"

namespace ringfilm::cycle {

/// Cells across the face, heights above its lowest point.
film::FilmGrid face_grid(const Setup& setup);

/// The film of an integration: across the face alone, or on the unrolled ring (film.dimension).
class CycleFilm {
 public:
  explicit CycleFilm(const Setup& setup);
  CycleFilm(const CycleFilm&) = delete;  // its workspace may refer to its problem

  /// Across the face: that of each strip of an unrolled film. Its gap is that of the film that was solved last, where
  /// the face gives way to it.
  const film::FilmProblem& across() const { return across_; }
  /// Grid of `across()` with the gap of a face without load.
  const film::FilmGrid& unloaded_grid() const {
    return elastic_ ? elastic_->unloaded() : tilting_ ? tilting_->level() : across_.grid;
  }
  bool tilts() const { return tilting_.has_value(); }  ///< does the face turn with its section?
  /// The gap of `across()` as it is of a film that was solved, where the face turns.
  void lay_gap_of(const film::FilmState& state) {
    if (tilting_) tilting_->lay(state.tilt, across_.grid);
  }
  /// nullptr: the film is that across the face.
  const film::Film2dProblem* film2d() const { return film2d_ ? &*film2d_ : nullptr; }

  /// A steady film from nothing. @param before what it was solved from; only its `mass_per_area` enters
  film::FilmReport solve_steady(const RingConditions& at, film::FilmState& before, film::FilmState& state);

  /// By the method of the case; parameters as of film::solve_film.
  film::FilmReport solve(const RingConditions& at, const film::FilmState& previous, film::FilmState& state);

  /// The film under a ring that is held off the liner at this separation, state.h_m; only where has_simple_gap().
  film::FilmReport solve_off_liner(const RingConditions& at, const film::FilmState& previous, film::FilmState& state);
  /// A film across the face of rigid surfaces, by the coupled Newton method?
  bool has_simple_gap() const;

  /// What acts on an unrolled film, and on its ring.
  film::Film2dInputs film2d_inputs(const RingConditions& at) const;

  /// What heats a film that was solved with `inputs`; of an unrolled film its strip halfway.
  film::FilmHeating heating(const film::FilmInputs& inputs, const film::FilmState& state) const {
    const int strip = film2d_ ? film2d_->around.halfway() : 0;
    return film::film_heating(across_, inputs, state, strip, rise(state, strip));
  }

  /// Length of the ring that node `i` of a state represents, to a factor common to all.
  double weight(std::size_t i) const { return film2d_ ? film2d_->around.share[i / film2d_->n_across()] : 1; }

  /// Radius of the bore at each strip over that of the round one; empty for a ring that does not bend, whose bore is
  /// taken as round [m].
  std::vector<double> bore_at_strips(const RingConditions& at) const {
    return ring_ ? ring_->bore_at_strips(at.below_tdc, at.crank_angle_deg) : std::vector<double>();
  }

  /// By how much the separation of a strip exceeds h_m: that of a ring that bends [m].
  double rise(const film::FilmState& state, int strip) const {
    return state.ring.empty() ? 0 : state.ring[film2d_->ring.of_strip(strip)];
  }

 private:
  using Workspace = std::variant<film::MethodWorkspace, film::Film2dWorkspace>;
  film::FilmReport solve_across(const film::FilmInputs& inputs, const film::FilmState& previous,
                                film::FilmState& state);
  static Workspace workspace_of(const Setup& setup, const CycleFilm& film);

  const Setup& setup_;
  film::FilmProblem across_;
  std::optional<film::ElasticFace> elastic_;   ///< nothing: face and liner are rigid
  std::optional<film::TiltingFace> tilting_;   ///< nothing: the face does not turn
  film::FactorIteration factors_;              ///< flow factors of the film across the face
  std::optional<BendingRing> ring_;            ///< nothing: it is rigid
  std::optional<film::Film2dProblem> film2d_;  ///< unrolled film, if there is one
  Workspace workspace_;
};

/// What acts on the unrolled ring: at both ends of its gap the mean of the pressures at the edges (eq-film-2d-ends).
film::Film2dInputs film2d_inputs(const film::FilmInputs& inputs);

/// How finely the unrolled ring of a case is cut.
film::CircumferentialGrid strips_of(const Case& c);

/// Longer than asked for by as much, the cells at the ends of the ring are reported.
inline constexpr double kEndCellMissed = 1.1;

}  // namespace ringfilm::cycle
