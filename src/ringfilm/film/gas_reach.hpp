#pragma once
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// How far the gas of each edge comes into the gap, and the lowest pressure of the film there (eq-pressure-bound). The
/// gases meet on the narrowest stretch of the gap: the nodes at which it is wider than at its lowest place by no more
/// than 0.2 % or 1 nm. Along it the bound falls from the one gas to the other as the pressure of a viscous flow does
/// that blows through (eq-gas-through-throat).
class GasReach {
 public:
  /// Refers to `inputs`.
  GasReach(const FilmGrid& grid, const FilmInputs& inputs);

  /// The lowest pressure that the film can have at node `i` [Pa].
  double pressure_bound(int i) const;
  /// The edge whose gas would fill a cavity at node `i`; nullptr: none, or that of both.
  const EdgeState* gas_at(int i) const;
  /// Would gas of an edge, or of both, fill a cavity at node `i`?
  bool is_filled(int i) const { return is_within(i) || gas_at(i) != nullptr; }
  /// Argument `carry` of carried_share() at node `i`. Steady films store nothing. Films with a full inlet pass nothing
  /// on to a wall that is followed: there theta is the share that flows.
  double carry(int i) const;

  /// The first and the last node of the narrowest stretch.
  int begin() const { return begin_; }
  int end() const { return end_; }

 private:
  bool is_within(int i) const { return i >= begin_ && i <= end_ && i > 0 && i < n_cells_; }
  /// Pressure of the gas at an edge; next to oil that of a cavity [Pa].
  double beside(const EdgeState& edge) const {
    return edge.fluid == EdgeFluid::kGas ? edge.pressure : inputs_->p_cavitation;
  }

  const FilmInputs* inputs_;
  int n_cells_;
  int begin_ = 0, end_ = 0;
  std::vector<double> bound_;  ///< at the nodes of the narrowest stretch [Pa]
};

}  // namespace ringfilm::film
