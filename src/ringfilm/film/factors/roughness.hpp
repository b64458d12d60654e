#pragma once

/// What roughness does in a film (docs/theory/flow-factors.md).
namespace ringfilm::film {

/// Factors of rough walls.
enum class Roughness {
  kNone,       ///< none: smooth walls
  kPatirCheng  ///< those of Patir and Cheng
};

/// Film thickness that the gap stores and the wall carries.
enum class AverageGap {
  kNominal,   ///< that of smooth walls
  kTruncated  ///< mean of the local one, where Gaussian heights do not overlap
};

}  // namespace ringfilm::film
