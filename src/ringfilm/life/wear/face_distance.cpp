#include "ringfilm/life/wear/face_distance.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::life {

const std::vector<double>& compared_half_widths() {
  static const std::vector<double> all = {0.5e-3, 0.3e-3};
  return all;
}

double rms_distance(const std::vector<double>& x, const std::vector<double>& one, const std::vector<double>& other,
                    double half_width) {
  const double middle = 0.5 * (x.front() + x.back());
  double n = 0, sum = 0, first = 0, second = 0, moment = 0, square = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double s = x[i] - middle, d = one[i] - other[i];
    constexpr double kRounding = 1e-12;
    if (std::abs(s) > half_width + kRounding) continue;
    n += 1;
    sum += d;
    first += s;
    second += s * s;
    moment += s * d;
    square += d * d;
  }
  const double spread = second - first * first / n, slope = (moment - first * sum / n) / spread;
  return std::sqrt(std::max(0.0, (square - sum * sum / n - slope * slope * spread) / n));
}

}  // namespace ringfilm::life
