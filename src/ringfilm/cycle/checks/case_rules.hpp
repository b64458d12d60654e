#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"

namespace ringfilm::cycle {

/// Rules that join several keys: exclusive tensions, moduli against composite modulus, lists that must not be empty,
/// solver and output angles that must fit. Empty if all hold. Each entry names the key at fault and the remedy.
struct RuleBreach {
  /// What breaks the rule.
  enum class By {
    kValues,     ///< values that do not fit together
    kMissingKey  ///< a key that the case does not state; holds whatever other keys are missing, too
  };
  std::string key;
  std::string message;
  std::string remedy;
  By by = By::kValues;
  std::vector<std::vector<std::string>> ways = {};  ///< keys of each stated way, where one way alone may remain
};
std::vector<RuleBreach> broken_rules(const Case& c);

/// The rules of a case of which the gas of the ring pack alone is computed.
std::vector<RuleBreach> broken_gas_rules(const Case& c);

/// Rules that join the rings of a pack; keys are those of the pack, "ring.2.kind".
std::vector<RuleBreach> broken_pack_rules(const Case& pack);

}  // namespace ringfilm::cycle
