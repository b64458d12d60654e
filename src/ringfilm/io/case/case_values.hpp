#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// Puts the value of one key into the case: unit, dimension, range, choice, finite numbers. What is wrong goes to
/// `faults`, and the case keeps what it had. @returns whether the value was good
bool set_value(cycle::Case& c, const cycle::Field& field, const TomlEntry& entry, const Units& units,
               std::vector<Fault>& faults);

/// A range in the units people read: "above 0 mm, up to 50 mm".
std::string range_words(const cycle::Field& field, const Units& units);

}  // namespace ringfilm::io
