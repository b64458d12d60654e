#pragma once
#include <cmath>
#include <vector>

#include "ringfilm/base/constants.hpp"

/// Which parts of a cycle the samples of a trace cover.
namespace ringfilm::models {

/// Largest distance between neighbouring samples, the last one and the first of the next cycle included [degree]. The
/// pressure between samples is interpolated.
inline constexpr double kLargestSampleDistanceDeg = 10;

/// A trace over part of the cycle is joined from exhaust to intake pressure between these angles [degree] ...
inline constexpr double kJoinedOverlapBeginDeg = 340, kJoinedOverlapEndDeg = 380;
/// ... and with each of the two over this angle at least [degree].
inline constexpr double kShortestBlendDeg = 40;
/// Such a trace lies between minus and plus this angle from firing TDC [degree].
inline constexpr double kLongestPartialTraceDeg = kJoinedOverlapBeginDeg - kShortestBlendDeg;
static_assert(kLongestPartialTraceDeg == base::kCycleDeg - kJoinedOverlapEndDeg - kShortestBlendDeg);

/// Do the samples cover one revolution of the crank, and so half a cycle of a four-stroke engine? Their span may differ
/// from 360 degrees by the distance that samples may have, as where the last one before 360 degrees is missing.
inline bool covers_one_revolution(const std::vector<double>& crank_angle_deg) {
  constexpr double kRevolutionDeg = base::kCycleDeg / 2;
  return !crank_angle_deg.empty() &&
         std::abs(crank_angle_deg.back() - crank_angle_deg.front() - kRevolutionDeg) <= kLargestSampleDistanceDeg;
}

/// How messages name the span of such a trace.
inline constexpr const char* kOneRevolution = "one revolution; a four-stroke cycle of 720 degrees is expected";

}  // namespace ringfilm::models
