#pragma once
#include <limits>
#include <string>

namespace ringfilm::io {

/// One active key of the case as the run used it.
struct CaseEntry {
  std::string key;                                             ///< "engine.bore"
  std::string value;                                           ///< TOML right-hand side in SI, exact
  std::string shown;                                           ///< in the unit people use, e.g. "89 mm"
  bool assumed = false;                                        ///< the user did not state it
  std::string help;                                            ///< what the key is, one line
  double value_si = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the value is not a single number
  /// Unit of `value_si`, SI in UDUNITS spelling; "1" dimensionless, "" if the value is not a number.
  std::string unit = {};
};

}  // namespace ringfilm::io
