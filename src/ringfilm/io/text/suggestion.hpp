#pragma once
#include <string>
#include <vector>

namespace ringfilm::io {

/// The word of `known` that `written` most likely means; empty if none is near. Counts exchanged, missing,
/// superfluous and wrong letters (Damerau-Levenshtein, restricted); a key in the wrong section counts as near.
/// A name in an earlier version (base/renamed.hpp) means its present name.
std::string nearest_word(const std::string& written, const std::vector<std::string>& known);

/// The end of the sentence on an unknown word, "; did you mean speed?"; empty if no word of `known` is near.
std::string did_you_mean(const std::string& written, const std::vector<std::string>& known);

/// What to answer to an unknown key.
struct KeyProposal {
  std::string near;     ///< the key that is most likely meant; empty for none
  std::string message;  ///< the end of the sentence "unknown key ring.closed_gap"; may be empty
  std::string remedy;   ///< may be empty
};

/// The key of `known` that `written` most likely means, by nearest_word or as a term of the trade (trade_term); for a
/// term of what is not modelled what to state instead.
KeyProposal key_proposal(const std::string& written, const std::vector<std::string>& known);

}  // namespace ringfilm::io
