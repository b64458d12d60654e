#pragma once
#include "ringfilm/film/film_state.hpp"

/// Complementarity of pressure and fill by one number z per node [Pa]: z > 0 is a full film with p = p_c + z; z <= 0 is
/// a cavity at p_c whose fill is theta = 1 + z/scale (mass-conserving), or where z balances the broken conservation of
/// mass (Reynolds exit). eqs eq-complementarity, eq-fill. A state keeps -z/scale as its deficit.
namespace ringfilm::film {

/// theta at a node.
inline double fill(Cavitation cavitation, double deficit) {
  return cavitation == Cavitation::kMassConserving ? 1 - deficit : 1.0;
}

/// Is the node part of a cavity?
inline bool is_cavity(double deficit) { return deficit > kHardlyCavity; }

}  // namespace ringfilm::film
