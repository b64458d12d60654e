#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/case/case.hpp"

/// What can only be said of a case as a whole: keys that are missing, keys that nothing uses, rules that join keys.
namespace ringfilm::io {

/// Where a key stands.
struct KeyPlace {
  SourceMark key_mark, value_mark;
};

/// What a case states, and where.
struct StatedKeys {
  std::string path;                       ///< of the case, for what stands nowhere
  std::map<std::string, KeyPlace> given;  ///< each of them a known key
  std::set<std::string> faulty;           ///< keys, or whole sections ("engine."), on which nothing more can be said
  std::set<std::string> from_oil_file;    ///< keys that describe the oil, whether this case has a use for them or not
};

/// Everything that is wrong with a case whose values are good one by one. Empty if nothing is.
std::vector<Fault> case_faults(const cycle::Case& c, const StatedKeys& stated);

}  // namespace ringfilm::io
