#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ringfilm::study {

/// Points of the Sobol sequence @cite sobol1967 with the direction numbers of @cite joe2008, in Gray code order from
/// the origin on, each coordinate scrambled after @cite owen1995: every binary digit is flipped or not at random, by a
/// hash of the seed, the dimension and the digits before it. Every point is even in the cube, and 2^m of them from a
/// multiple of 2^m on are as evenly spread as without scrambling. Point n depends on the seed, its dimension and n
/// alone; eq-owen.
class SobolPoints {
 public:
  /// Most dimensions that there are direction numbers for.
  static constexpr std::size_t kMaxDimensions = 3667;
  /// Points from 0 on.
  static constexpr std::uint64_t kMaxPoints = std::uint64_t{1} << 32;

  SobolPoints() = default;
  /// Throws std::invalid_argument if there are more dimensions than direction numbers.
  SobolPoints(std::size_t n_dimensions, std::uint64_t seed);

  /// Coordinate of a point, in (0, 1). @param point below kMaxPoints
  double share(std::uint64_t point, std::size_t dimension) const;
  /// Coordinate before it is scrambled: 32 binary digits, the first the uppermost.
  std::uint32_t digits(std::uint64_t point, std::size_t dimension) const;

 private:
  std::size_t n_dimensions_ = 0;
  std::uint64_t seed_ = 0;
  std::vector<std::uint32_t> directions_;  ///< [dimension * 32 + digit]
};

/// Nested uniform scrambling of 32 binary digits, and 20 more below them that are random. @returns the middle of one of
/// 2^52 parts of (0, 1)
double scrambled(std::uint32_t digits, std::uint64_t seed);

}  // namespace ringfilm::study
