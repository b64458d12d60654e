#include "ringfilm/gas_path/network.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ringfilm::gas_path {
namespace {

/// Shortest time in which the groove of a seated ring comes into balance with the piston land above it [degree]. No
/// pressure of a cycle changes by more than some 1e-9 of itself in it, and steps of a degree keep rounding below their
/// error.
constexpr double kQuickestDeg = 1e-8;

Region region(const std::string& name, double volume, double temperature, double gas_constant) {
  return {name, temperature, std::max(volume, kMinVolume) / (gas_constant * temperature), nullptr};
}

std::string numbered(const char* name, std::size_t number) { return name + std::to_string(number); }

/// The channel between the flanks of a ring and of its groove.
models::GasChannel side_channel(const Pack& pack, const Ring& ring) {
  const double outer = pack.bore - 2 * ring.land_clearance, inner = pack.bore - 2 * ring.radial_thickness;
  return {std::numbers::pi * (outer + inner) / 2, (outer - inner) / 2, pack.gas.viscosity, pack.gas.gas_constant,
          ring.groove_temperature};
}

/// The gap over the face of a ring, around the bore. @param temperature of the gas above the ring [K]
models::GasChannel face_channel(const Pack& pack, const Ring& ring, double temperature) {
  return {std::numbers::pi * pack.bore, ring.face_width, pack.gas.viscosity, pack.gas.gas_constant, temperature};
}

double disc(double diameter) { return std::numbers::pi / 4 * diameter * diameter; }

}  // namespace

std::string path_name(const Path& path) {
  const std::size_t number = path.ring + 1;
  switch (path.kind) {
    case PathKind::kEndGap:
      return numbered("end gap ", number);
    case PathKind::kAboveRing:
      return numbered("above ring ", number);
    case PathKind::kBelowRing:
      return numbered("below ring ", number);
    case PathKind::kFace:
      return numbered("face of ring ", number);
  }
  return "";
}

Network::Network(const Pack& pack, GivenPressures given)
    : pack_(pack),
      given_(std::move(given)),
      law_(pack.gas.heat_capacity_ratio, pack.gas.choking_smoothing),
      borders_(pack.rings.size()) {
  const double R = pack.gas.gas_constant;
  const std::size_t n = pack.rings.size();
  given_.resize(n);
  regions_.push_back({"chamber", pack.chamber_temperature, 0, &pack.chamber});
  std::vector<std::size_t> groove(n), below(n);  // regions of each ring; below 0: the piston land below has no volume
  for (std::size_t i = 0; i < n; ++i) {
    const Ring& ring = pack.rings[i];
    if (ring.kind == RingKind::kCompression) {
      groove[i] = regions_.size();
      regions_.push_back(region(numbered("groove ", i + 1), ring.groove_volume, ring.groove_temperature, R));
    }
    if ((ring.volume_below > 0 || given_[i]) && i + 1 < n) {
      below[i] = regions_.size();
      regions_.push_back(region(numbered("land ", i + 2), ring.volume_below, ring.temperature_below, R));
      if (given_[i]) regions_.back().given = &*given_[i];
    }
  }
  const std::size_t crankcase = regions_.size();
  regions_.push_back({"crankcase", pack.crankcase_temperature, 0, &pack.crankcase});
  unknown_.resize(regions_.size());
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    if (!is_inner(r)) continue;
    unknown_[r] = inner_.size();
    inner_.push_back(r);
  }
  for (std::size_t i = n; i-- > 0;) {
    if (below[i] == 0) below[i] = i + 1 < n ? below[i + 1] : crankcase;
  }
  for (std::size_t i = 0; i < n; ++i) {
    borders_[i].groove = groove[i];
    channels_.push_back(side_channel(pack, pack.rings[i]));
    seated_clearance_.push_back(pack.rings[i].side_clearance);
    add_ring(i, i == 0 ? 0 : below[i - 1], below[i]);
  }
  narrow_quick_clearances();
}

/// The only path of a groove whose ring is seated is its side clearance. One that would bring the groove to the
/// pressure above the ring within kQuickestDeg is narrowed to do so in that time: the quasi-steady limit of the groove.
void Network::narrow_quick_clearances() {
  double highest = 0;
  for (const Region& region : regions_) {
    if (region.given != nullptr) highest = std::max(highest, region.given->peak());
  }
  const double quickest = kQuickestDeg * std::numbers::pi / 180 / pack_.speed;
  for (std::size_t i = 0; i < pack_.rings.size(); ++i) {
    if (!has_groove(i)) continue;
    const double slope = channels_[i].slope(seated_clearance_[i], highest);
    const double largest = regions_[borders_[i].groove].capacity / quickest;
    if (slope > largest) seated_clearance_[i] *= std::cbrt(largest / slope);
  }
}

void Network::add_ring(std::size_t ring, std::size_t above, std::size_t below) {
  borders_[ring].above = above;
  borders_[ring].below = below;
  if (above != below) paths_.push_back({PathKind::kEndGap, ring, above, below});
  faces_.push_back(face_channel(pack_, pack_.rings[ring], regions_[above].temperature));
  if (above != below && (pack_.rings[ring].leaves_liner || !pack_.rings[ring].face_opening.empty())) {
    paths_.push_back({PathKind::kFace, ring, above, below});
  }
  if (!has_groove(ring)) return;
  paths_.push_back({PathKind::kAboveRing, ring, above, borders_[ring].groove});
  if (pack_.ring_motion == RingMotion::kAxial) {
    paths_.push_back({PathKind::kBelowRing, ring, borders_[ring].groove, below});
  }
}

double Network::flow(const Path& path, double p_from, double p_to, double position) const {
  const Ring& ring = pack_.rings[path.ring];
  if (path.kind == PathKind::kEndGap) {
    return orifice_flow(law_, pack_.gas.discharge_coefficient * ring.gap_area, pack_.gas.gas_constant,
                        {p_from, regions_[path.from].temperature}, {p_to, regions_[path.to].temperature});
  }
  if (path.kind == PathKind::kFace) return faces_[path.ring].limited_flow(law_, position, p_from, p_to);
  const models::GasChannel& channel = channels_[path.ring];
  if (pack_.ring_motion == RingMotion::kSeated) return channel.flow(seated_clearance_[path.ring], p_from, p_to);
  const double clearance = path.kind == PathKind::kAboveRing ? ring.side_clearance - position : position;
  return channel.limited_flow(law_, clearance, p_from, p_to);
}

double Network::pressure_off_liner(std::size_t index, std::span<const double> pressure) const {
  const Ring& ring = pack_.rings[index];
  const RingBorders& at = borders_[index];
  return ring.collapse.excess(pressure[at.above], pressure[at.below], ring.elastic_pressure + pressure[at.groove]);
}

Network::CollapseSlopes Network::collapse_slopes(std::size_t index, std::span<const double> pressure) const {
  const models::RadialCollapse& collapse = pack_.rings[index].collapse;
  if (!pack_.rings[index].leaves_liner) return {};
  const double distance = collapse.distance(pressure_off_liner(index, pressure));
  if (distance <= 0 || distance >= collapse.farthest) return {};
  return {collapse.share_above / collapse.stiffness, (1 - collapse.share_above) / collapse.stiffness,
          -1 / collapse.stiffness};
}

double Network::face_opening(std::size_t index, double angle, std::span<const double> pressure) const {
  const Ring& ring = pack_.rings[index];
  const double stated = ring.face_opening.empty() ? 0 : stated_opening(index, angle);
  if (!ring.leaves_liner) return stated;
  return stated + ring.collapse.distance(pressure_off_liner(index, pressure));
}

double Network::stated_opening(std::size_t ring, double angle) const {
  const std::vector<double>& opening = pack_.rings[ring].face_opening;
  const std::size_t n = opening.size();
  const double at = std::fmod(angle, static_cast<double>(n));
  const auto before = static_cast<std::size_t>(at);
  const double share = at - static_cast<double>(before);
  return (1 - share) * opening[before % n] + share * opening[(before + 1) % n];
}

double Network::gas_and_friction(std::size_t index, double crank_angle, double p_above, double p_groove, double p_below,
                                 double p_crankcase) const {
  const Ring& ring = pack_.rings[index];
  const double outer = pack_.bore - 2 * ring.land_clearance, inner = pack_.bore - 2 * ring.radial_thickness;
  const double edge = disc(pack_.bore) - disc(outer), flank = disc(outer) - disc(inner);
  const double gas = edge * (p_below - p_above) + flank * (models::mean_channel_pressure(p_groove, p_below) -
                                                           models::mean_channel_pressure(p_above, p_groove));
  return gas + friction_on_bore(index, crank_angle, p_groove, p_crankcase);
}

double Network::friction_on_bore(std::size_t index, double crank_angle, double p_groove, double p_crankcase) const {
  const Ring& ring = pack_.rings[index];
  if (ring.bore_friction_coefficient == 0) return 0;
  const double sliding = pack_.crank.velocity(crank_angle, pack_.speed) / pack_.sliding_smoothing_speed;
  const double on_bore =
      std::numbers::pi * pack_.bore * ring.face_width * (ring.elastic_pressure + p_groove - p_crankcase);
  return -ring.bore_friction_coefficient * on_bore * std::tanh(sliding);
}

double Network::axial_force(std::size_t ring, double crank_angle, double p_above, double p_groove, double p_below,
                            double p_crankcase) const {
  const double force = gas_and_friction(ring, crank_angle, p_above, p_groove, p_below, p_crankcase);
  const double mass = pack_.rings[ring].mass;
  return mass == 0 ? force : force - mass * pack_.crank.acceleration(crank_angle, pack_.speed);
}

double Network::acceleration(std::size_t ring, double crank_angle, double p_above, double p_groove, double p_below,
                             double p_crankcase) const {
  return gas_and_friction(ring, crank_angle, p_above, p_groove, p_below, p_crankcase) / pack_.rings[ring].mass -
         pack_.crank.acceleration(crank_angle, pack_.speed);
}

}  // namespace ringfilm::gas_path
