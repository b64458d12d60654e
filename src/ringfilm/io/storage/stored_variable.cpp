#include "ringfilm/io/storage/stored_variable.hpp"

#include <netcdf.h>

#include <optional>

namespace ringfilm::io {
namespace {

/// None of types of one byte, whose every value may be meant, and of those that are not numbers.
std::optional<double> default_fill(int type) {
  switch (type) {
    case NC_SHORT:
      return NC_FILL_SHORT;
    case NC_USHORT:
      return NC_FILL_USHORT;
    case NC_INT:
      return NC_FILL_INT;
    case NC_UINT:
      return NC_FILL_UINT;
    case NC_INT64:
      return static_cast<double>(NC_FILL_INT64);
    case NC_UINT64:
      return static_cast<double>(NC_FILL_UINT64);
    case NC_FLOAT:
      return static_cast<double>(NC_FILL_FLOAT);
    case NC_DOUBLE:
      return NC_FILL_DOUBLE;
    default:
      return std::nullopt;
  }
}

}  // namespace

void StoredVariable::add_default_fill(int type) {
  if (has_fill) return;
  if (const auto fill = default_fill(type)) missing.push_back(*fill);
}

}  // namespace ringfilm::io
