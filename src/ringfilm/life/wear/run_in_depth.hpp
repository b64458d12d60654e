#pragma once
#include <vector>

/// What worn depths do to the roughness of the surface that loses them (docs/theory/life.md).
namespace ringfilm::life {

/// Mean height of what lies above the mean plane of a Gaussian surface, over its rms: F_1(0) of eq-gaussian-integral.
inline constexpr double kMeanPeakHeight = 0.39894228040143268;

/// How far a surface has run in: means over its places, each weighted with the volume that it has lost. A surface that
/// has lost nothing has 1 in both.
struct RunInDepth {
  /// Excess of the roughness over its limit, over that at the start, eq-life-run-in-mean [-].
  double excess_left = 1;
  /// Excess that was lost per worn depth, over that of the first depth, eq-life-run-in-volume [-].
  double loss_per_depth = 1;
};

/// @param depth worn depths at the places of the surface [m] @param width of each place; empty: equal widths [m]
/// @param depth_scale depth over which the excess falls to 1/e of itself [m]
RunInDepth run_in_depth(const std::vector<double>& depth, const std::vector<double>& width, double depth_scale);

}  // namespace ringfilm::life
