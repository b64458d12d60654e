#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "commands/commands.hpp"

namespace ringfilm::app {

/// A key and its values, of `--vary KEY=VALUE, VALUE, ...`.
struct Variation {
  std::string key;
  std::vector<std::string> values;  ///< as written
};

/// Throws InputError where a text is not of that form, or a key is varied twice.
std::vector<Variation> variations(const std::vector<std::string>& texts);

/// Computes the gas of a pack for each combination of the values, the last key fastest.
/// @returns a header and one row each: the values, blow-by, peak pressures of the regions of all combinations (empty
/// where one has no such region), flutter, and why one was not solved
std::string gas_variations_csv(const std::string& case_path, const std::vector<io::Override>& overrides,
                               const std::vector<Variation>& varied);

}  // namespace ringfilm::app
