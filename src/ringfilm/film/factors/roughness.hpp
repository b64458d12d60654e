#pragma once

/// What roughness does in a film (docs/theory/flow-factors.md).
namespace ringfilm::film {

/// Factors of rough walls.
enum class Roughness {
  kNone,        ///< none: smooth walls
  kPatirCheng,  ///< those of Patir and Cheng
  kMeasured     ///< those of the gap of a measured pair
};

/// Film thickness that the gap stores and the wall carries.
enum class AverageGap {
  kNominal,    ///< film thickness between smooth walls
  kTruncated,  ///< mean of the local film thickness, where Gaussian heights do not overlap
  kMeasured    ///< mean of the true gap of a measured pair
};

}  // namespace ringfilm::film
