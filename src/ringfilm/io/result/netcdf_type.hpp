#pragma once
#include <netcdf.h>

#include <type_traits>

namespace ringfilm::io {

/// The type of a variable that holds such values: double, float, long, signed char, or text.
template <class Value>
inline constexpr int kNetcdfType = std::is_same_v<Value, double>        ? NC_DOUBLE
                                   : std::is_same_v<Value, float>       ? NC_FLOAT
                                   : std::is_same_v<Value, long>        ? NC_INT64
                                   : std::is_same_v<Value, signed char> ? NC_BYTE
                                                                        : NC_STRING;

}  // namespace ringfilm::io
