#pragma once
#include <string>
#include <vector>

namespace ringfilm::io {

/// The word of `known` that `written` most likely means; empty if none is near. Counts exchanged, missing,
/// superfluous and wrong letters (Damerau-Levenshtein, restricted); a key in the wrong section counts as near. A name
/// of an earlier version (base/renamed.hpp) means its present name.
std::string nearest_word(const std::string& written, const std::vector<std::string>& known);

}  // namespace ringfilm::io
