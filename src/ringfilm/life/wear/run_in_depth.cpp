#include "ringfilm/life/wear/run_in_depth.hpp"

#include <cmath>

namespace ringfilm::life {

RunInDepth run_in_depth(const std::vector<double>& depth, const std::vector<double>& width, double depth_scale) {
  double lost = 0, left = 0, smoothed = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double volume = depth[i] * (width.empty() ? 1.0 : width[i]), x = depth[i] / depth_scale;
    lost += volume;
    left += volume * std::exp(-x);
    smoothed += x > 0 ? volume * -std::expm1(-x) / x : 0;
  }
  return lost > 0 ? RunInDepth{left / lost, smoothed / lost} : RunInDepth{};
}

}  // namespace ringfilm::life
