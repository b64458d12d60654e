#include "ringfilm/life/life_result.hpp"

#include <algorithm>
#include <utility>

#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/life/pack_gas.hpp"

namespace ringfilm::life {

const std::vector<WornQuantity>& worn_quantities() {
  static const std::vector<WornQuantity> table = {
      {{"worn_area", "m2", "um mm", "worn area of the cross-section", "A", "eq-life-volume"},
       "worn area",
       &WornProfile::worn_area},
      {{"largest_worn_depth", "m", "um", "largest worn depth of the face", "w_max", "eq-life-archard"},
       "largest depth",
       &WornProfile::largest_depth},
      {{"coating_left", "m", "um", "coating left at the deepest place", "", ""},
       "coating left",
       &WornProfile::coating_left},
      {{"end_gap_growth", "m", "mm", "growth of the end gap", "Delta g", "eq-life-gap"},
       "growth of the end gap",
       &WornProfile::end_gap_growth},
      {{"running_in_roughness", "m", "um", "roughness that runs in", "sigma_w", "eq-life-run-in-mean"},
       "running-in roughness",
       &WornProfile::running_in_roughness},
      {{"smoothing_share", "1", "%", "share of the worn volume from the peaks", "s_w", "eq-life-run-in-volume"},
       "share from the peaks",
       &WornProfile::smoothing_share},
      {cycle::leading_gas_sum(), "blow-by per cylinder", &WornProfile::blow_by}};
  return table;
}

std::optional<double> value_of(const WornQuantity& quantity, const WornProfile& worn) {
  return std::visit([&](auto member) { return std::optional<double>(worn.*member); }, quantity.value);
}

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

Band band_of(const LifeState& state, const WornQuantity& quantity) {
  const double own = value_of(quantity, *state.worn).value();
  Band band{own, own};
  for (const std::optional<WornProfile>& other : state.other_worn) {
    if (!other) continue;
    const double value = value_of(quantity, *other).value();
    band = {std::min(band.low, value), std::max(band.high, value)};
  }
  return band;
}

}  // namespace ringfilm::life
