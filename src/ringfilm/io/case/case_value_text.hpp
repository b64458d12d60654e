#pragma once
#include <string>

#include "ringfilm/cycle/case/case_fields.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// The value of a key as the right-hand side of TOML, in SI, exact to the last bit; empty where the case has none.
std::string exact_value(const cycle::Field& field, const cycle::Case& c);

/// The same in the unit that people use, rounded to 8 digits: 89 mm, wiebe, 40 degC: 59.99 mm2/s.
std::string shown_value(const cycle::Field& field, const cycle::Case& c, const Units& units);

/// The shown value as one would write it in TOML: "89 mm" with its quotes, 0.3 without.
std::string written_value(const cycle::Field& field, const cycle::Case& c, const Units& units);

}  // namespace ringfilm::io
