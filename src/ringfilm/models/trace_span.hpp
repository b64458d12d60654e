#pragma once
#include <cmath>
#include <vector>

namespace ringfilm::models {

/// Do the samples cover one revolution of the crank, and so half a cycle of a four-stroke engine? Their span may differ
/// from 360 degrees by the distance that samples may have, as where the last one before 360 degrees is missing.
inline bool covers_one_revolution(const std::vector<double>& crank_angle_deg) {
  constexpr double kRevolutionDeg = 360, kLargestDistanceDeg = 10;  // of samples, see covers_cycle
  return !crank_angle_deg.empty() &&
         std::abs(crank_angle_deg.back() - crank_angle_deg.front() - kRevolutionDeg) <= kLargestDistanceDeg;
}

/// How messages name the span of such a trace.
inline constexpr const char* kOneRevolution = "one revolution; a four-stroke cycle of 720 degrees is expected";

}  // namespace ringfilm::models
