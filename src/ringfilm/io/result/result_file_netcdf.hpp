#pragma once
#include <mutex>

namespace ringfilm::io {

/// Whoever calls the NetCDF library holds this: it is not made for several threads. HDF5 beneath it would print every
/// question about what a file has not; the library silences it on the first thread alone, this on every one.
class NetcdfInUse {
 public:
  NetcdfInUse();

 private:
  std::unique_lock<std::mutex> lock_;
};

}  // namespace ringfilm::io
