#pragma once
#include <string>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// The value of a key as the right-hand side of TOML, in SI, exact to the last bit; empty where the case has none.
std::string exact_value(const cycle::Field& field, const cycle::Case& c);

/// The number that the key holds in its SI unit; NaN for text, choices, files and lists, and where the case has none.
double si_number(const cycle::Field& field, const cycle::Case& c);

/// The exact value in the unit that people use, rounded to 8 digits: 89 mm, wiebe, 40 degC: 59.99 mm2/s.
std::string shown_value(const cycle::Field& field, const cycle::Case& c, const Units& units);

/// The shown value as one would write it in TOML: "89 mm" with its quotes, 0.3 without.
std::string written_value(const cycle::Field& field, const cycle::Case& c, const Units& units);

}  // namespace ringfilm::io
