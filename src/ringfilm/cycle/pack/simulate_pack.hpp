#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "ringfilm/cycle/cycle_run.hpp"
#include "ringfilm/cycle/simulate.hpp"

namespace ringfilm::cycle {

/// Do the rings of a pack share the oil on the liner, so that one cannot be computed without the others?
bool shares_oil(const Case& pack);

/// Topic of the note on a piston land whose height the case leaves open.
inline constexpr const char* kRingDistanceAssumed = "ring-distance-assumed";

/// A ring of a pack.
struct RingOutcome {
  CycleResult result;        ///< all up to the last good angle if the integration of a ring stopped
  std::optional<Stop> stop;  ///< why that of this ring did
};

/// Integrates the rings of a pack that shares the oil on the liner, in the order from the chamber to the crankcase,
/// until the state of each repeats. In each stroke the ring that leads comes first, and each of the others finds the
/// film that the ring before it has left. As with `simulate`, a ring without a film is tried again on graded cells.
/// @param iteration how the oil on the liner comes to rest
std::vector<RingOutcome> simulate_pack(std::vector<Setup> rings, Observer* observer = nullptr,
                                       OilIteration iteration = OilIteration::kMixed);

/// Are the rings after one that stopped integrated as well?
enum class AtStop {
  kEnd,      ///< they are not
  kContinue  ///< each ring is integrated, whatever the others do
};

/// Integrates all rings of a case whose pressures are known, from the chamber to the crankcase: one after another, or
/// with `simulate_pack` where they share the oil on the liner. @returns the one ring of a case that is not a pack
/// @param c each rail of an oil ring by itself (with_rails)
/// @param begins called with the number of each ring, from 0, that is integrated by itself
std::vector<RingOutcome> simulate_rings(const Case& c, Observer* observer = nullptr, AtStop at_stop = AtStop::kEnd,
                                        const std::function<void(std::size_t)>& begins = {});

}  // namespace ringfilm::cycle
