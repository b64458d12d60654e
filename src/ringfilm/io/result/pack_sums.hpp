#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// What the faces of one ring of a pack add up to.
struct RingSums {
  std::size_t ring = 0;       ///< number of the ring, from 1
  cycle::CycleValues values;  ///< cycle::summed_quantities() alone
};

/// The friction of each ring of a pack, the rails of an oil ring added up.
std::vector<RingSums> ring_sums(const ResultDocument& pack);

/// Oil at the chamber's side of a pack whose rings share the oil on the liner (docs/theory/gas-path.md).
struct PackOil {
  /// Mean film thickness on the liner above the first ring at BDC after the power stroke [m].
  double film_after_power_stroke = 0;
  /// Mean film thickness on the liner above the first ring at BDC after the intake stroke [m].
  double film_after_intake_stroke = 0;
  double left_at_tdc = 0;  ///< oil that the first ring leaves above it at TDC, per cycle [kg]
  /// All oil that the first ring leaves on the liner in its two downstrokes, as if it burned or were thrown off; no
  /// more can reach the chamber from the liner in a cycle [kg].
  double to_chamber_upper_bound = 0;
};

/// A value of PackOil.
struct PackOilQuantity : cycle::Quantity {
  double PackOil::*value;
};
const std::vector<PackOilQuantity>& pack_oil_quantities();  ///< in the order of files and tables

/// Nothing where the oil on the liner is not followed or a ring stopped.
std::optional<PackOil> pack_oil(const ResultDocument& pack);

}  // namespace ringfilm::io
