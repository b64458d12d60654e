#pragma once
#include <string>

#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// The document as a command prints it, in lines of at most 100 characters: title, sources, what was done, the values
/// of each group with their standard error and what they hold for, the tables, then the notes. Engineer's units.
/// Throws std::logic_error as check_measurement does.
std::string measurement_text(const Measurement& measurement, const Units& units);

/// "0.4123 +- 0.0021" in the display unit, without the unit: the error rounded up to one digit (two where the first is
/// 1), the value to the same place; four digits where there is no error; "none" where there is no value.
std::string measured_number(const MeasuredValue& described, double value, double standard_error, const Units& units);

/// From SI to the display unit; the SI value is used where no display unit is named.
Scale display_scale(const std::string& unit, const std::string& display_unit, const Units& units);

}  // namespace ringfilm::io
