#pragma once
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ringfilm/io/storage/stored_variable.hpp"

namespace ringfilm::io {

/// What of a classic file is wrong, in words that follow "cannot be read as NetCDF: ".
class ClassicNetcdfError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Variables of a NetCDF file of the classic kinds (CDF-1, CDF-2 and CDF-5 of the format specification), read by
/// ourselves because the library breaks down on damaged ones. Throws ClassicNetcdfError: a file that is damaged or cut
/// off.
/// @param bytes the whole file; must outlive what is returned
std::map<std::string, StoredVariable> classic_netcdf_variables(std::string_view bytes);

}  // namespace ringfilm::io
