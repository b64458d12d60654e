#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "variations.hpp"

namespace ringfilm::app {

/// Does the gas of a ring pack alone follow from the key, of one ring or of a ring of a pack? True for an unknown key,
/// which the reader of the case reports.
bool acts_on_gas(const std::string& key);

/// How --vary has its variations.
const VariationForm& vary_form();

/// Computes the gas of a pack for each combination of the values, the last key fastest. Throws InputError where a
/// varied key is one of `overrides` or has no effect on the gas.
/// @returns a header and one row each: the values, blow-by, peak pressures of the regions of all combinations (empty
/// where one has no such region), flutter, and why one was not solved
std::string gas_variations_csv(const std::string& case_path, const std::vector<io::Override>& overrides,
                               const std::vector<Variation>& varied);

}  // namespace ringfilm::app
