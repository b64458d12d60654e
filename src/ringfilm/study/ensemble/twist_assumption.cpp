#include "ringfilm/study/ensemble/twist_assumption.hpp"

#include <string>

#include "ringfilm/cycle/setup/ring_section.hpp"
#include "ringfilm/study/ensemble/alternatives.hpp"

namespace ringfilm::study {

Assumption ring_twist(const cycle::Case& c) {
  Assumption twist;
  LedgerEntry& entry = twist.entry;
  entry.topic = "ring-twist";
  entry.source = "docs/theory/assumptions.md#ring-twist";
  if (!c.twists()) {
    entry.statement = "the section of the ring is stated, and its face does not turn";
    entry.consequence = "a face that turns by a minute of arc falls by a third of a micrometre over 1.2 mm";
  } else {
    const bool has_mass = cycle::section_mass(c) > 0, has_clearance = cycle::side_clearance(c.ring).has_value();
    entry.statement =
        "the section of the ring turns by the same angle all around, in balance with gas, film, friction" +
        std::string(has_mass ? " and inertia" : " (ring.mass is not stated: without inertia)") +
        " on the flanks of its groove at each instant";
    entry.consequence =
        "the flanks are flat and stiff, the end gap is omitted, and oil between the flanks carries "
        "nothing; the twist of a ring that leaves its flank follows the static force";
    if (!has_clearance) entry.consequence += "; without ring.side_clearance the groove does not limit the twist";
  }
  if (c.can_twist()) twist.alternatives = other_choices("ring.twist", c);
  entry.can_be_lifted = !twist.alternatives.empty();
  return twist;
}

}  // namespace ringfilm::study
