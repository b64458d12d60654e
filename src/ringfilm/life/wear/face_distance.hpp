#pragma once
#include <vector>

namespace ringfilm::life {

/// How far two faces are apart near their middle: rms of their difference about its own straight line, since offset and
/// tilt of a scan are not known [m]. @param x of both [m] @param half_width to both sides of the middle [m]
double rms_distance(const std::vector<double>& x, const std::vector<double>& one, const std::vector<double>& other,
                    double half_width);

/// Half widths over which faces are compared, the largest first: without the outer part, where scans are least to be
/// trusted [m].
const std::vector<double>& compared_half_widths();

}  // namespace ringfilm::life
