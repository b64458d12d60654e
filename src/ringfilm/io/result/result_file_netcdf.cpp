#include "ringfilm/io/result/result_file_netcdf.hpp"

#include <H5Epublic.h>

namespace ringfilm::io {
namespace {

std::mutex& one_thread_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

NetcdfInUse::NetcdfInUse() : lock_(one_thread_at_a_time()) { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

}  // namespace ringfilm::io
