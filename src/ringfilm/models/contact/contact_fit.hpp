#pragma once
#include <array>

#include "ringfilm/models/oil/polynomial.hpp"

namespace ringfilm::models {

/// One polynomial each that replaces the exact Gaussian integrals in the inner loop: F_5/2 = P52^8 and F_2 = P2^8
/// for 0 <= lambda <= kEnd and zero beyond, eq-contact-fit; P in t = 2 lambda/kEnd - 1, lowest power first. The eighth
/// root falls by a factor of 50 where F falls by 14 decades, and stays positive: so does F.
struct ContactFit {
  static constexpr int kDegree = 15, kSlopeDegree = 8;
  static constexpr double kEnd = 7;  ///< where 5e-14 of F(0) is left

  using Coefficients = std::array<double, kDegree + 1>;
  Coefficients P52, P2;
  /// dP52/dt where it only steers the iteration: within 3e-5 of the derivative.
  std::array<double, kSlopeDegree + 1> P52_slope;
  double error;  ///< bound of |P^8 - F|/F(0) for all lambda >= 0, of both [-]

  /// P^8 and its slope in lambda, 0 <= lambda <= kEnd.
  template <class Value>
  static ValueAndSlope<Value> integral(const Coefficients& P, const Value& lambda) {
    const auto root = polynomial_and_slope(P, Value(lambda * (2 / kEnd) - 1.0));
    const Value square = root.value * root.value, fourth = square * square;
    return {fourth * fourth, fourth * square * root.value * root.slope * (16 / kEnd)};
  }
};

/// The fit of the exact integrals; it has no parameter.
const ContactFit& contact_fit();

}  // namespace ringfilm::models
