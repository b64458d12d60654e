#include "ringfilm/life/life_result.hpp"

#include <algorithm>

namespace ringfilm::life {

Band band_of(const LifeState& state, std::size_t quantity) {
  Band band{state.values[quantity], state.values[quantity]};
  for (const LifeValues& other : state.other_paths) {
    band.low = std::min(band.low, other[quantity]);
    band.high = std::max(band.high, other[quantity]);
  }
  return band;
}

}  // namespace ringfilm::life
