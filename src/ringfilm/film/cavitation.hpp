#pragma once
#include <algorithm>
#include <limits>

#include "ringfilm/film/film_state.hpp"

/// Complementarity of pressure and film content by one number z per node [Pa]: z > 0 is a full film with p = p_c + z; z
/// <= 0 is a cavity at p_c whose film content is theta = 1 + z/scale (mass-conserving), or where z balances the broken
/// conservation of mass (Reynolds exit). eqs eq-complementarity, eq-film-content. A state keeps -z/scale as its
/// deficit.
namespace ringfilm::film {

/// theta at a node.
inline double film_content(Cavitation cavitation, double deficit) {
  return cavitation == Cavitation::kMassConserving ? 1 - deficit : 1.0;
}

/// z of the node at an edge: the wall brings a full gap, of which an inlet takes what there is (limit_inlet) [Pa].
inline double edge_z(const EdgeState& edge, double p_cavitation) {
  return edge.fluid == EdgeFluid::kGas ? 0 : edge.pressure - p_cavitation;
}

/// The deficit of the node at an edge: of the film that enters there, or of the one that leaves the node beside it [-].
/// @param full mass per area of the full gap there [kg/m2]
template <class Full>
double edge_deficit(const EdgeState& edge, const Full& full, double beside) {
  if (edge.fluid == EdgeFluid::kOil) return 0;
  return edge.supply < std::numeric_limits<double>::infinity() ? std::max(0.0, 1 - edge.supply / full()) : beside;
}

/// Is the node part of a cavity?
inline bool is_cavity(double deficit) { return deficit > kCavityThreshold; }

}  // namespace ringfilm::film
