#pragma once
#include <array>
#include <cstddef>

namespace ringfilm::models {

/// c[0] + c[1] t + c[2] t^2 + ..., for any type with sums and products; at least two coefficients.
template <class Value, std::size_t n>
Value polynomial(const std::array<double, n>& c, const Value& t) {
  Value sum = t * c[n - 1] + c[n - 2];
  for (std::size_t k = n - 2; k-- > 0;) sum = sum * t + c[k];
  return sum;
}

template <class Value>
struct ValueAndSlope {
  Value value, slope;
};

/// Value of the polynomial and its slope in t; at least three coefficients.
template <class Value, std::size_t n>
ValueAndSlope<Value> polynomial_and_slope(const std::array<double, n>& c, const Value& t) {
  Value value = t * c[n - 1] + c[n - 2];
  Value slope = t * c[n - 1] + value;
  for (std::size_t k = n - 2; k-- > 1;) {
    value = value * t + c[k];
    slope = slope * t + value;
  }
  return {value * t + c[0], slope};
}

}  // namespace ringfilm::models
