#pragma once
#include <cstddef>
#include <cstdint>

namespace ringfilm::study {

/// The place of `i` in a random order of 0 ... n - 1, without a table: a Feistel network of hashes that is walked until
/// it ends below n. One to one for every n and seed. @param i below n, which is above 0
std::uint64_t shuffled(std::uint64_t i, std::uint64_t n, std::uint64_t seed);

/// Points of a Latin hypercube @cite mckay1979: of n points, each of n equal parts of every dimension holds one, at a
/// random place in it; eq-latin-hypercube. Point i depends on n: more points are another hypercube.
class LatinHypercube {
 public:
  LatinHypercube() = default;
  LatinHypercube(std::uint64_t n_points, std::uint64_t seed) : n_points_(n_points), seed_(seed) {}

  /// Coordinate of a point, in (0, 1). @param point below the number of points
  double share(std::uint64_t point, std::size_t dimension) const;

 private:
  std::uint64_t n_points_ = 0, seed_ = 0;
};

}  // namespace ringfilm::study
