#pragma once
#include <cstdint>

/// Random numbers without a state: what the n-th is depends on nothing but the seed and n, so that any part of a plan
/// can be computed anywhere. Whole numbers alone: the same bits on every machine.
namespace ringfilm::study {

/// Mixes the bits of a word one to one; the finisher of splitmix64, as written by @cite steele2014 with the
/// constants of its 13th variant.
constexpr std::uint64_t mixed(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
  return word ^ (word >> 31);
}

/// A random word for each seed and words; their order counts.
template <class... Words>
constexpr std::uint64_t hash(std::uint64_t seed, Words... words) {
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;  // odd, so that no word is lost
  std::uint64_t result = mixed(seed + kStep);
  ((result = mixed((result ^ static_cast<std::uint64_t>(words)) + kStep)), ...);
  return result;
}

/// The middle of one of 2^52 equal parts of (0, 1); never 0 or 1. @param word its upper 52 bits count
constexpr double share_of(std::uint64_t word) { return static_cast<double>(2 * (word >> 12) + 1) * 0x1.0p-53; }

/// A whole number below `n`, all equally often to n / 2^32. @param n above 0 and below 2^32
constexpr std::uint64_t below(std::uint64_t n, std::uint64_t word) { return ((word >> 32) * n) >> 32; }

}  // namespace ringfilm::study
