#pragma once
#include <mutex>

namespace ringfilm::io {

/// The NetCDF library is not made for several threads: whoever calls it holds this.
std::mutex& netcdf_in_use();

}  // namespace ringfilm::io
