#include "ringfilm/cycle/pack/rails_of_pack.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ringfilm::cycle {
namespace {

std::string rail_name(const Ring& ring, int rail) {
  const std::string name = ring.name.empty() ? "oil ring" : ring.name;
  if (rail == 0) return name + ", upper rail";
  return rail + 1 == ring.rails ? name + ", lower rail" : name + ", rail " + std::to_string(rail + 1);
}

/// Between two rails, where the groove drains: the pressure below the ring.
LandPressure drained_pressure(const Case& ring) {
  if (ring.ring.pressure_below.is_stated()) return ring.ring.pressure_below;
  LandPressure crankcase;
  if (ring.gas.crankcase_trace) {
    crankcase.file = ring.gas.crankcase_pressure_file;
    crankcase.trace = ring.gas.crankcase_trace;
  } else {
    crankcase.constant = ring.gas.crankcase_pressure;
  }
  return crankcase;
}

Case rail_of(const Case& ring, int rail) {
  Case one = ring;
  const int n = ring.ring.rails;
  const bool is_last = rail + 1 == n;
  one.ring.rails = 1;
  one.ring.rail_distance.reset();
  one.ring.name = rail_name(ring.ring, rail);
  for (auto force : {&Ring::tangential_force, &Ring::expander_force}) {
    if (one.ring.*force) *(one.ring.*force) /= n;
  }
  if (rail > 0) one.ring.pressure_above = drained_pressure(ring);
  if (is_last) return one;
  one.ring.pressure_below = drained_pressure(ring);
  one.ring.land_below = ring.ring.rail_distance.value_or(ring.ring.face_width);
  one.ring.gas_path.volume_below = 0;
  return one;
}

}  // namespace

Case with_rails(Case pack) {
  std::vector<Case> rings;
  for (Case& ring : pack.rings) {
    if (ring.ring.rails == 1) {
      rings.push_back(std::move(ring));
      continue;
    }
    for (int rail = 0; rail < ring.ring.rails; ++rail) rings.push_back(rail_of(ring, rail));
  }
  pack.rings = std::move(rings);
  return pack;
}

std::size_t rail_number(const Case& pack, std::size_t ring) {
  for (const Case& one : pack.rings) {
    const auto n = static_cast<std::size_t>(one.ring.rails);
    if (ring < n) return n > 1 ? ring + 1 : 0;
    ring -= n;
  }
  return 0;
}

std::string ring_label(const Case& pack, std::size_t ring) {
  const std::size_t rail = rail_number(pack, ring);
  std::size_t number = 1, before = 0;
  for (const Case& one : pack.rings) {
    before += static_cast<std::size_t>(one.ring.rails);
    if (ring < before) break;
    ++number;
  }
  return std::to_string(number) + (rail > 0 ? ", rail " + std::to_string(rail) : std::string());
}

}  // namespace ringfilm::cycle
