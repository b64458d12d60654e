#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"

/// Checks of a case as a whole: keys that are missing, keys that nothing uses, rules that join keys.
namespace ringfilm::io {

/// Where a key is stated.
struct KeyPlace {
  SourceMark key_mark, value_mark;
};

/// What a case states, and where.
struct StatedKeys {
  std::string path;                       ///< path of the case, for faults that have no place in it
  std::map<std::string, KeyPlace> given;  ///< each of them a known key
  std::set<std::string> faulty;           ///< keys, or whole sections ("engine."), that cannot be checked further
  std::set<std::string> from_oil_file;    ///< keys that describe the oil, whether this case has a use for them or not
};

/// A fault, and the key whose fault it is.
struct KeyFault {
  std::string key;
  Fault fault;
  std::string used_where = {};  ///< where the key is used, in words, if the case does not use it; else empty
};

/// Everything that is wrong with a case whose values are good one by one. Empty if nothing is.
std::vector<KeyFault> case_faults(const cycle::Case& c, const StatedKeys& stated);

}  // namespace ringfilm::io
