#pragma once
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

/// z of the node at an edge [Pa]. @param content_scale what z of a cavity is divided by for its film content [Pa]
inline double edge_z(const EdgeState& edge, double p_cavitation, double content_scale) {
  return edge.fluid == EdgeFluid::kGas ? (edge.film_content - 1) * content_scale : edge.pressure - p_cavitation;
}

/// The deficit of the node at an edge [-].
inline double edge_deficit(const EdgeState& edge) { return edge.fluid == EdgeFluid::kGas ? 1 - edge.film_content : 0; }

/// Is the node part of a cavity?
inline bool is_cavity(double deficit) { return deficit > kCavityThreshold; }

}  // namespace ringfilm::film
