#pragma once
#include <string>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/friction_loop/lateral_force_calibration.hpp"

namespace ringfilm::io {

/// A value in `si_unit` and its standard deviation, from a text such as "450 um +- 5 um", "450 +- 5 um",
/// "(450 +- 5) um", "450 um +- 2 %" or "0.19 +- 0.1" ("1": a number without unit); a deviation that is not stated is 0.
/// Throws UnitError as Units::quantity, and for a deviation below zero.
/// @param example what one could have written
surface::Uncertain uncertain_quantity(const std::string& text, const std::string& si_unit, const std::string& example,
                                      const Units& units);

}  // namespace ringfilm::io
