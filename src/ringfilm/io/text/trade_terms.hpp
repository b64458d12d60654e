#pragma once
#include <string>
#include <string_view>

namespace ringfilm::io {

/// A term of ring drawings and catalogues that is not a key of a case.
struct TradeTerm {
  std::string_view word;    ///< as part of a key, words joined by underscores: "barrel_drop"
  std::string_view key;     ///< the key to use; empty: not modelled
  std::string_view remedy;  ///< how to convert it, or what to state instead
};

/// The term that the last part of an unknown key or section contains as whole words; nullptr for none.
const TradeTerm* trade_term(const std::string& key);

}  // namespace ringfilm::io
