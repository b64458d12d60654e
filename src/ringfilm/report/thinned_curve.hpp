#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/io/measurement.hpp"

namespace ringfilm::report {

/// The points of one series that a page carries; NaN where the line has a gap.
struct ThinnedSeries {
  std::vector<double> x, y;
};

/// All points where there are few; else the lowest, the highest, the first and the last of each of `stretches` even
/// parts of the axis (even on its scale), so that no peak is lost.
ThinnedSeries thinned(const io::MeasuredCurve& curve, const io::MeasuredSeries& series, std::size_t stretches);

}  // namespace ringfilm::report
