#pragma once
#include <functional>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// A rigid face that turns with the section of its ring (docs/theory/ring-section.md, eq-section-face). A positive tilt
/// takes the edge at x = 0 away from the liner.
class TiltingFace {
 public:
  /// @param grid with the heights of the face of a ring that does not twist
  explicit TiltingFace(const FilmGrid& grid);

  const FilmGrid& level() const { return level_; }  ///< with the heights of the face of a ring that does not twist

  /// The gap of the face at a tilt [rad], its lowest node as high as without: so h_m remains the minimum film
  /// thickness.
  void lay(double tilt, FilmGrid& grid) const;

  /// Solves a film with the gap that is held in the problem, from the state on.
  using Solve = std::function<FilmReport(FilmState&)>;
  /// Tilt at which a ring is in balance with that film, falling with the tilt of the film or constant [rad].
  using Balance = std::function<double(const FilmState&)>;
  /// Film and tilt together, from the tilt of `state` on. Where they do not agree the film keeps that tilt.
  /// @param problem whose gap is laid anew @returns the report of the last film, with the iterations of all
  FilmReport solve(FilmProblem& problem, FilmState& state, const Solve& solve, const Balance& balance) const;

 private:
  FilmGrid level_;
  double lowest_;  ///< height of the lowest node without tilt [m]
};

}  // namespace ringfilm::film
