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
  bool has_fill = false;             ///< is one of them its _FillValue?
  /// All of them, the last dimension running first. Throws the errors of its file.
  std::function<std::vector<double>()> values;

  /// Without _FillValue, what is never written holds the default of its type: marks that as a hole.
  /// @param type its number, which the classic files and NetCDF-4 share
  void add_default_fill(int type);
};

}  // namespace ringfilm::io
