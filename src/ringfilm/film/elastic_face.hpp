#pragma once
#include <functional>
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Face and liner that give way locally to the pressure between them, as half-spaces in plane strain
/// (docs/theory/ring.md, eq-local-deformation).
class ElasticFace {
 public:
  /// @param grid with the heights of the face without load @param E_prime of 2/E' = sum (1 - nu^2)/E [Pa]
  ElasticFace(const FilmGrid& grid, double E_prime);

  const FilmGrid& unloaded() const { return unloaded_; }  ///< with the heights of the face without load

  /// By how much face and liner are pressed apart at each node, over the mean of both edges, by what film and
  /// asperities press beyond the straight line between the pressures at the edges [m].
  std::vector<double> displacement(const FilmProblem& problem, const FilmInputs& inputs, const FilmState& state) const;

  /// The gap of a face that is displaced so, its lowest node as high as that of the face without load: so h_m remains
  /// the minimum film thickness.
  void lay(const std::vector<double>& displacement, FilmGrid& grid) const;

  /// Solves a film with the gap that is held in the problem, from the state on.
  using Solve = std::function<FilmReport(FilmState&)>;
  /// Film and deformation together, from the deformation of `state` on. @param problem whose gap is laid anew
  /// @returns the report of the last film, with the iterations of all
  FilmReport solve(FilmProblem& problem, const FilmInputs& inputs, FilmState& state, const Solve& solve) const;

 private:
  FilmGrid unloaded_;
  double lowest_;                  ///< height of the lowest node of the unloaded face [m]
  std::vector<double> influence_;  ///< displacement at node i by pressure about node j, row-major [m/Pa]
};

}  // namespace ringfilm::film
