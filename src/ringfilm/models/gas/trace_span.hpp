#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "ringfilm/base/constants.hpp"

/// Which parts of a cycle the samples of a trace cover.
namespace ringfilm::models {

/// Largest distance between neighbouring samples, the last one and the first of the next cycle included [degree]. The
/// pressure between samples is interpolated.
inline constexpr double kMaxSampleDistanceDeg = 10;

/// A trace over part of the cycle is joined from exhaust to intake pressure between these angles [degree] ...
inline constexpr double kJoinedOverlapBeginDeg = 340, kJoinedOverlapEndDeg = 380;
/// ... and with each of the two over this angle at least [degree].
inline constexpr double kMinBlendDeg = 40;
/// Such a trace lies between minus and plus this angle from firing TDC [degree].
inline constexpr double kMaxPartialTraceDeg = kJoinedOverlapBeginDeg - kMinBlendDeg;
static_assert(kMaxPartialTraceDeg == base::kCycleDeg - kJoinedOverlapEndDeg - kMinBlendDeg);

/// Such a trace covers this span at least [degree]: the valves of a four-stroke engine are closed over 200 degrees and
/// more, and no blend of a few values makes up for compression and expansion.
inline constexpr double kMinPartialTraceDeg = 180;

/// By this share the span of samples may differ from whole revolutions, as where the last one is missing.
inline constexpr double kScatterOfSpan = 0.05;
/// Two revolutions in radians: numbers that span more are degrees.
inline constexpr double kMaxSpanInRadians = 4 * std::numbers::pi * (1 + kScatterOfSpan);

/// Do the samples span one or two revolutions in radians, while they are read as degrees? The last one may be missing.
inline bool spans_radians(const std::vector<double>& crank_angle_deg) {
  constexpr double kRevolution = 2 * std::numbers::pi, kScatter = kScatterOfSpan;
  if (crank_angle_deg.empty()) return false;
  const double span = crank_angle_deg.back() - crank_angle_deg.front();
  return std::abs(span - kRevolution) <= kScatter * kRevolution ||
         std::abs(span - 2 * kRevolution) <= kScatter * 2 * kRevolution;
}

/// Do the samples cover one revolution of the crank, and so half a cycle of a four-stroke engine? Their span may differ
/// from 360 degrees by the distance that samples may have, as where the last one before 360 degrees is missing.
inline bool covers_one_revolution(const std::vector<double>& crank_angle_deg) {
  constexpr double kRevolutionDeg = base::kCycleDeg / 2;
  return !crank_angle_deg.empty() &&
         std::abs(crank_angle_deg.back() - crank_angle_deg.front() - kRevolutionDeg) <= kMaxSampleDistanceDeg;
}

/// How messages name the span of such a trace.
inline constexpr const char* kOneRevolution = "one revolution; a four-stroke cycle of 720 degrees is expected";

}  // namespace ringfilm::models
