#pragma once
#include <vector>

#include "ringfilm/io/text/toml_tree.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/life/life.hpp"

namespace ringfilm::io {

/// The table [wear]. What is wrong goes to `faults`.
/// @param base whose coating is used where the table states none; nullptr: it could not be read
life::Wear read_wear_table(const TomlValue& value, const cycle::Case* base, const Units& units,
                           std::vector<Fault>& faults);

}  // namespace ringfilm::io
