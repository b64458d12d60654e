#include "ringfilm/life/life_result.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/life/pack_gas.hpp"

namespace ringfilm::life {

WornProfile worn_profile(std::vector<double> depth, double area, std::optional<double> coating) {
  WornProfile worn;
  worn.worn_area = area;
  worn.largest_depth = *std::max_element(depth.begin(), depth.end());
  worn.end_gap_growth = end_gap_growth(worn.largest_depth);
  if (coating) worn.coating_left = *coating - worn.largest_depth;
  worn.depth = std::move(depth);
  return worn;
}

Band band_of(const LifeState& state, std::size_t quantity) {
  Band band{state.values[quantity], state.values[quantity]};
  for (const LifeValues& other : state.other_paths) {
    if (other.empty()) continue;
    band.low = std::min(band.low, other[quantity]);
    band.high = std::max(band.high, other[quantity]);
  }
  return band;
}

}  // namespace ringfilm::life
