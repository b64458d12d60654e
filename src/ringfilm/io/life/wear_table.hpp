#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/text/toml_table.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/life/life.hpp"

namespace ringfilm::io {

/// A quantity of a life's file in `unit`, refused where it is not one. @param example the right-hand side as one would
/// write it
std::optional<double> life_quantity(TomlTable& table, const std::string& key, const TomlValue& value,
                                    const std::string& unit, const std::string& example, const Units& units);

/// The table [wear]. What is wrong goes to `faults`.
/// @param base whose coating is used where the table states none; nullptr: it could not be read
life::Wear read_wear_table(const TomlValue& value, const cycle::Case* base, const Units& units,
                           std::vector<Fault>& faults);

}  // namespace ringfilm::io
