#pragma once
#include <string>

#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/friction_loop/lateral_force_calibration.hpp"

namespace ringfilm::io {

struct LeverFile {
  surface::Lever lever;
  std::string sha256;
};

/// Reads the data of a cantilever from TOML: `shape` ("rectangular", "v-shaped"), `length`, `tip_height`,
/// `poissons_ratio` and `sensitivity_ratio` (optional, 1), and where loads are in newtons also `youngs_modulus`,
/// `width`, `thickness`, `torsional_sensitivity`; sizes as texts such as "450 um +- 5 um". Throws InputError with the
/// place of each fault: a key that is missing or unknown, no unit.
LeverFile read_lever(const NamedFile& file, surface::LoadUnit load_unit, const Units& units);

}  // namespace ringfilm::io
