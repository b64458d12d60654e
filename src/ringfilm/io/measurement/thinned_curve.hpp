#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "ringfilm/io/measurement/measurement.hpp"

namespace ringfilm::io {

/// The points of one series that a page carries; NaN where the line has a gap.
struct ThinnedSeries {
  std::vector<double> x, y;
};

/// All points where there are few; else the lowest, the highest, the first and the last of each of `stretches` even
/// parts of the axis (even on its scale), so that no peak is lost.
ThinnedSeries thinned(const MeasuredCurve& curve, const MeasuredSeries& series, std::size_t stretches);

/// All series of a curve over one axis, thinned to at most `most_points` provided that its places do not turn back;
/// empty where all points stay.
std::optional<MeasuredCurve> thinned(const MeasuredCurve& curve, std::size_t most_points);

}  // namespace ringfilm::io
