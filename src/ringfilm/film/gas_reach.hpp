#pragma once
#include <algorithm>
#include <vector>

#include "ringfilm/film/film_state.hpp"

namespace ringfilm::film {

/// Faces of the grid through which gas of a higher pressure blows against the motion, and what holds the oil back there
/// (eq-broken-film).
struct Throat {
  int first_face = 0, last_face = -1;  ///< none where last < first
  double pressure = 0;                 ///< pressure of the gas behind them, absolute [Pa]
  double reach = 0;  ///< gap times the root of pressure, by which the passing oil is limited [m Pa^1/2]
  double place = 0;  ///< distance of the narrowest place from the node before the face in the direction of the motion,
                     ///< over the length of the cell, 0 to 1 [-]
};

/// Length of a throat, int (h_t/h)^3 dx with h_t the gap at its lowest place, by which a parabola of radius R has
/// sqrt(2 R h_t), eq-broken-film [m]. @param lowest height of that place [m]
double throat_length(const FilmGrid& grid, double h_m, double lowest);

/// `reach` of the Throat of this length. @param viscosity at the pressure behind it [Pa s]
double throat_reach(BrokenFilm broken, double viscosity, double U, double length);

/// Twice the share of the gap that a retreating meniscus leaves on the wall (eq-meniscus-film) [-].
double left_by_meniscus(double capillary_number);

/// The two nodes about a place between them where gases meet. Where gas fills one of them, its pressure acts up to the
/// place itself, and not halfway to the other node.
struct MeetingPlace {
  int before = 0, after = 0;                             ///< in +x
  double beyond = 0;                                     ///< from the place to the middle between the nodes [m]
  double per_deficit_before = 0, per_deficit_after = 0;  ///< share of gas in a node, over its deficit [-]

  /// By how much more of the gap has the pressure of node `after` than belongs to it, and less that of `before` [m].
  double shift(double deficit_before, double deficit_after) const {
    return beyond *
           std::clamp(std::max(deficit_before * per_deficit_before, deficit_after * per_deficit_after), 0., 1.);
  }
};

/// How far the gas of each edge comes into the gap, and the lowest pressure of the film there (eq-pressure-bound). The
/// gases meet on the narrowest stretch of the gap: the nodes at which it is wider than at its lowest place by no more
/// than 0.2 % or 0.1 nm. Along it the bound falls from the one gas to the other as the pressure of a viscous flow does
/// that blows through (eq-gas-through-throat). Of a rounded face it is a place between two nodes.
class GasReach {
 public:
  /// Refers to `grid` and `inputs`.
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
  /// Twice the share of the gap that the meniscus behind the film leaves on the wall, 1 for half of the gap
  /// (eq-outlet).
  double outlet() const;
  /// Is node `i` where that meniscus may be?
  bool is_outlet(int i) const { return gas_at(i) == &behind() && carry(i) > kBetweenWalls; }

  /// The first and the last node of the narrowest stretch; of a place between two nodes the one after it and the one
  /// before it.
  int begin() const { return begin_; }
  int end() const { return end_; }
  /// Are they the nodes about a place?
  bool is_place() const { return end_ < begin_; }
  double begin_place() const { return is_place() ? place_ : grid_->x[begin_]; }  ///< [m]
  double end_place() const { return is_place() ? place_ : grid_->x[end_]; }      ///< [m]

  Throat throat() const;
  MeetingPlace meeting_place() const;
  /// What gas up to the place itself adds to the load [N/m]. @param deficit at the nodes; empty: gas fills all
  double load_beyond_place(const std::vector<double>& p, const std::vector<double>& deficit) const;

 private:
  bool is_within(int i) const { return i >= begin_ && i <= end_ && i > 0 && i < n_cells_; }
  /// The edge at which the film leaves.
  const EdgeState& behind() const { return inputs_->U >= 0 ? inputs_->right : inputs_->left; }
  /// Pressure of the gas at an edge; next to oil that of a cavity [Pa].
  double beside(const EdgeState& edge) const {
    return edge.fluid == EdgeFluid::kGas ? edge.pressure : inputs_->p_cavitation;
  }
  void share_fall(double narrowest, double widest);
  void set_place();

  const FilmGrid* grid_;
  const FilmInputs* inputs_;
  int n_cells_;
  int begin_ = 0, end_ = 0;
  double place_ = 0;           ///< [m]
  double throat_length_ = 0;   ///< l of eq-broken-film [m]
  std::vector<double> bound_;  ///< at the nodes of the narrowest stretch [Pa]
};

}  // namespace ringfilm::film
