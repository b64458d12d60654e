#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/friction_loop/lateral_force.hpp"

namespace ringfilm::io {

/// What a file of lateral force microscopy holds: friction loops, or their summary load by load; the other list is
/// empty.
struct ForceFile {
  std::string sample;  ///< name in a line "# sample: NAME" before the header; empty if there is none
  surface::LoadUnit load_unit{};
  std::vector<surface::FrictionLoop> loops;
  std::vector<surface::LoadFriction> loads;
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads a CSV file. Loops have the columns `load`, `position`, `trace`, `retrace`, one row a place, and `loop`, its
/// number, where a load has more than one; a new loop begins where load or number change, or the position falls back.
/// Both ways have the same, rising positions. A summary has `load` and `tmr` (half of trace minus retrace), and may
/// have `load_deviation` and `tmr_deviation`, standard deviations, and `loops`, a count. Loads are in volts or newtons,
/// signals in volts, with their units in the header. Throws InputError with file and line of each fault.
ForceFile read_force(const NamedFile& file, const Units& units);

}  // namespace ringfilm::io
