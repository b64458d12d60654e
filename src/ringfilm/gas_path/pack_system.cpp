#include "ringfilm/gas_path/pack_system.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace ringfilm::gas_path {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
/// Relative change of an unknown by which slopes are found; they guide the iteration alone.
constexpr double kProbe = 1e-8;
/// No iterate of a pressure goes below [Pa].
constexpr double kMinPressure = 1.0;
/// Largest share of a pressure by which one iteration reduces it.
constexpr double kMaxFall = 0.8;

}  // namespace

PackSystem::PackSystem(const Network& network)
    : network_(network),
      n_inner_(network.inner().size()),
      seconds_per_degree_(kRadians / network.pack().speed),
      place_(network.pack().rings.size(), kNotFree),
      fixed_position_(network.pack().rings.size(), 0),
      pressure_(network.n_regions()) {}

void PackSystem::set_contacts(const PackState& state) {
  free_.clear();
  for (std::size_t i = 0; i < place_.size(); ++i) {
    place_[i] = kNotFree;
    fixed_position_[i] = state.position[i];
    if (state.contact[i] != Contact::kFree) continue;
    place_[i] = place(free_.size());
    free_.push_back(i);
  }
}

void PackSystem::unknowns(const PackState& state, std::vector<double>& y) const {
  y = state.pressure;
  for (const std::size_t ring : free_) {
    y.push_back(state.position[ring]);
    y.push_back(state.velocity[ring]);
  }
}

void PackSystem::take(std::span<const double> y, PackState& state) const {
  std::copy(y.begin(), y.begin() + n_inner_, state.pressure.begin());
  for (const std::size_t ring : free_) {
    state.position[ring] = y[place_[ring]];
    state.velocity[ring] = y[place_[ring] + 1];
  }
}

double PackSystem::position(std::size_t ring, std::span<const double> y) const {
  return place_[ring] == kNotFree ? fixed_position_[ring] : y[place_[ring]];
}

void PackSystem::fill_pressures(double angle, std::span<const double> y, std::span<double> pressure) const {
  const auto& regions = network_.regions();
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const models::CyclePressure* given = regions[r].given;
    pressure[r] = given ? given->pressure(angle) : std::max(kPressureUnit * y[network_.unknown(r)], kMinPressure);
  }
}

double PackSystem::flow(const Path& path, double p_from, double p_to, double at) const {
  const double unit = path.kind == PathKind::kFace ? 1 : network_.pack().rings[path.ring].side_clearance;
  return network_.flow(path, p_from, p_to, at * unit);
}

double PackSystem::place_of(const Path& path, double angle, std::span<const double> y,
                            std::span<const double> pressure) const {
  return path.kind == PathKind::kFace ? network_.face_opening(path.ring, angle, pressure) : position(path.ring, y);
}

void PackSystem::flows(double angle, std::span<const double> y, std::span<double> pressure,
                       std::span<double> flow_of) const {
  fill_pressures(angle, y, pressure);
  const auto& paths = network_.paths();
  for (std::size_t k = 0; k < paths.size(); ++k) {
    flow_of[k] = flow(paths[k], pressure[paths[k].from], pressure[paths[k].to], place_of(paths[k], angle, y, pressure));
  }
}

void PackSystem::conductances(double angle, std::span<const double> y, std::span<double> conductance) {
  fill_pressures(angle, y, pressure_);
  const auto& paths = network_.paths();
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const FlowSlopes slope = slopes(paths[k], place_of(paths[k], angle, y, pressure_));
    conductance[k] = std::max({slope.from, -slope.to, 0.0});
  }
}

double PackSystem::acceleration_of(std::size_t ring, double angle, std::span<const double> pressure) const {
  const RingBorders& at = network_.borders(ring);
  const double unit = seconds_per_degree_ * seconds_per_degree_ / network_.pack().rings[ring].side_clearance;
  return unit * network_.acceleration(ring, angle * kRadians, pressure[at.above], pressure[at.groove],
                                      pressure[at.below], pressure.back());
}

double PackSystem::acceleration(std::size_t ring, double angle, std::span<const double> y) {
  fill_pressures(angle, y, pressure_);
  return acceleration_of(ring, angle, pressure_);
}

void PackSystem::rates(double angle, std::span<const double> y, std::span<double> f) {
  fill_pressures(angle, y, pressure_);
  std::fill(f.begin(), f.end(), 0.0);
  for (const Path& path : network_.paths()) {
    const double m = flow(path, pressure_[path.from], pressure_[path.to], place_of(path, angle, y, pressure_));
    if (is_inner(path.from)) f[network_.unknown(path.from)] -= m;
    if (is_inner(path.to)) f[network_.unknown(path.to)] += m;
  }
  for (std::size_t i = 0; i < n_inner_; ++i) {
    f[i] *= seconds_per_degree_ / (network_.regions()[network_.inner()[i]].capacity * kPressureUnit);
  }
  for (const std::size_t ring : free_) {
    f[place_[ring]] = y[place_[ring] + 1];
    f[place_[ring] + 1] = acceleration_of(ring, angle, pressure_);
  }
}

PackSystem::FlowSlopes PackSystem::slopes(const Path& path, double at) const {
  const double p_from = pressure_[path.from], p_to = pressure_[path.to], m = flow(path, p_from, p_to, at);
  // Away from the pressure at which the flow turns, where its slope jumps.
  const double away = p_from >= p_to ? kProbe : -kProbe;
  const double d_from = away * p_from, d_to = -away * p_to;
  FlowSlopes slope{(flow(path, p_from + d_from, p_to, at) - m) / d_from,
                   (flow(path, p_from, p_to + d_to, at) - m) / d_to, 0};
  const bool is_at_flank = path.kind == PathKind::kAboveRing || path.kind == PathKind::kBelowRing;
  const bool moves = is_at_flank && place_[path.ring] != kNotFree;
  if (moves) slope.position = (flow(path, p_from, p_to, at + kProbe) - m) / kProbe;
  if (path.kind != PathKind::kFace || !network_.pack().rings[path.ring].leaves_liner) return slope;
  const Network::CollapseSlopes opens = network_.collapse_slopes(path.ring, pressure_);
  const double probe = kProbe * at;
  const double by_opening = probe > 0 ? (flow(path, p_from, p_to, at + probe) - m) / probe : 0;
  slope.from += by_opening * opens.above;
  slope.to += by_opening * opens.below;
  slope.groove = by_opening * opens.behind;
  return slope;
}

void PackSystem::add_to_jacobian(const Path& path, const FlowSlopes& slope, std::span<double> J) const {
  const std::size_t n = size();
  for (const auto& [region, sign] : {std::pair{path.from, -1.0}, std::pair{path.to, 1.0}}) {
    if (!is_inner(region)) continue;
    const double unit = sign * seconds_per_degree_ / network_.regions()[region].capacity;
    double* const row = J.data() + network_.unknown(region) * n;
    if (is_inner(path.from)) row[network_.unknown(path.from)] += unit * slope.from;
    if (is_inner(path.to)) row[network_.unknown(path.to)] += unit * slope.to;
    if (slope.groove != 0) row[network_.unknown(network_.borders(path.ring).groove)] += unit * slope.groove;
    if (slope.position != 0) row[place_[path.ring]] += unit * slope.position / kPressureUnit;
  }
}

void PackSystem::add_ring_to_jacobian(std::size_t ring, double angle, std::span<double> J) {
  const RingBorders& at = network_.borders(ring);
  const std::size_t n = size(), row = place_[ring];
  J[row * n + row + 1] = 1;
  const double a = acceleration_of(ring, angle, pressure_);
  for (const std::size_t region : {at.above, at.groove, at.below}) {
    if (!is_inner(region)) continue;
    const double p = pressure_[region], d = kProbe * p;
    pressure_[region] += d;
    J[(row + 1) * n + network_.unknown(region)] = (acceleration_of(ring, angle, pressure_) - a) / d * kPressureUnit;
    pressure_[region] = p;
  }
}

void PackSystem::limit(std::span<const double> y, std::span<double> change) const {
  for (std::size_t i = 0; i < n_inner_; ++i) change[i] = std::max(change[i], -kMaxFall * y[i]);
}

void PackSystem::jacobian(double angle, std::span<const double> y, std::span<double> J) {
  fill_pressures(angle, y, pressure_);
  for (const Path& path : network_.paths()) add_to_jacobian(path, slopes(path, place_of(path, angle, y, pressure_)), J);
  for (const std::size_t ring : free_) add_ring_to_jacobian(ring, angle, J);
}

}  // namespace ringfilm::gas_path
