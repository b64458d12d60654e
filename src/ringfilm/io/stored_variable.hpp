#pragma once
#include <functional>
#include <string>
#include <vector>

namespace ringfilm::io {

/// A variable of a NetCDF file, however the file is read.
struct StoredVariable {
  std::vector<int> dimensions;       ///< their numbers in the file
  std::vector<std::size_t> lengths;  ///< of each
  std::string units;                 ///< empty if it has none
  std::string packed_by;             ///< the attribute that packs it; mostly empty
  std::vector<double> missing;       ///< values that mark a hole
  /// All of them, the last dimension running first. Throws the errors of its file.
  std::function<std::vector<double>()> values;
};

}  // namespace ringfilm::io
