#pragma once
#include <cstddef>
#include <optional>

#include "ringfilm/gas_path/network.hpp"

namespace ringfilm::gas_path {

/// How the forces of one instant twist a ring on its lower flank (docs/theory/gas-path.md#static-twist). Moments and
/// angles are positive where they turn the outer side of the ring towards the chamber.
struct StaticTwist {
  double moment = 0;  ///< moment of all forces except that of the flank, about the centroid, eq-twist-moment [N m]
  std::optional<double>
      reaction_place;  ///< radius at which the flank holds it, eq-flank-reaction; nothing: not seated [m]
  double angle = 0;    ///< eq-static-twist; 0 where the flank holds it or the ring is not seated [rad]
};

/// Static twist of a compression ring with a width and a modulus; of one whose section is stated with its assembly
/// twist and on either flank (docs/theory/ring-section.md#eq-section-twist). @param as of Network::axial_force()
StaticTwist static_twist(const Network& network, std::size_t ring, double crank_angle, double p_above, double p_groove,
                         double p_below, double p_crankcase);

}  // namespace ringfilm::gas_path
