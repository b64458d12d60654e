#pragma once
#include <cmath>
#include <cstdint>

/// Numbers by chance that are the same on every machine and with every library.
namespace ringfilm::scenarios {

/// splitmix64 of Steele, Lea and Flood (2014), its upper 53 bits.
class RepeatableNumbers {
 public:
  explicit RepeatableNumbers(std::uint64_t seed) : state_(seed) {}

  /// In [0, 1).
  double next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

  double between(double low, double high) { return low + (high - low) * next(); }
  double log_between(double low, double high) { return low * std::pow(high / low, next()); }
  int one_of(int n) { return static_cast<int>(n * next()); }

 private:
  std::uint64_t state_;
};

}  // namespace ringfilm::scenarios
