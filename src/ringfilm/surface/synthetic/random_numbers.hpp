#pragma once
#include <array>
#include <cstdint>

namespace ringfilm::surface {

/// Random numbers that are the same on every machine for the same seed: xoshiro256++ of @cite blackman2021, filled from
/// the seed by splitmix64.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed);

  double uniform();  ///< even in [0, 1)
  double normal();   ///< mean 0, variance 1; the polar method

 private:
  std::uint64_t next();

  std::array<std::uint64_t, 4> state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace ringfilm::surface
