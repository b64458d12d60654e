#include "ringfilm/cycle/closure/bending_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/integration/setup.hpp"
#include "ringfilm/models/conformity/ring_closure.hpp"

namespace ringfilm::cycle {
namespace {

using std::numbers::pi;

/// Angles of the nodes: those of the strips, and the ends of a ring without end gap.
std::vector<double> angles_of_nodes(const models::RingBeam& beam, const film::CircumferentialGrid& around) {
  const double first = beam.half_gap(), turn = 2 * (pi - first);
  std::vector<double> phi;
  if (around.ends == film::Ends::kJoined) phi.push_back(0);
  for (const double y : around.y) phi.push_back(first + turn * y / around.length);
  if (around.ends == film::Ends::kJoined) phi.push_back(2 * pi);
  return phi;
}

}  // namespace

BendingRing::BendingRing(const Case& c, const film::CircumferentialGrid& around)
    : case_(c),
      beam_(ring_beam(c)),
      first_node_(around.ends == film::Ends::kJoined ? 1 : 0),
      elements_(beam_, angles_of_nodes(beam_, around)),
      elastic_load_(elastic_pressure(c) * c.ring.face_width),
      heights_(bore_heights(c)) {
  for (int j = 0; j < around.n_strips(); ++j) {
    target_.push_back(beam_.target_force()(elements_.phi()[j + first_node_]) / beam_.size().tangential_force);
  }
  if (heights_.empty()) force_.push_back(elements_.force_of_shape(bore_at(0)));
  for (const double height : heights_) force_.push_back(elements_.force_of_shape(bore_at(height)));
}

models::FourierSeries BendingRing::bore_at(double below_tdc) const {
  return bore_deviation(case_, below_tdc).turned(case_.ring.gap_position_deg * pi / 180);
}

film::ElasticRing BendingRing::elastic_ring() const {
  static_assert(film::ElasticRing::kWidth == models::BeamElements::kWidth);
  return {first_node_, elements_.stiffness()};
}

void BendingRing::press(double below_tdc, film::Film2dInputs& inputs) const {
  inputs.strip_loads.clear();
  for (const double share : target_) inputs.strip_loads.push_back(inputs.strip.load + elastic_load_ * (share - 1));
  const auto above = std::upper_bound(heights_.begin(), heights_.end(), below_tdc);
  const auto next = static_cast<std::size_t>(above - heights_.begin());
  inputs.bore_force = force_[std::min(next, force_.size() - 1)];
  if (next == 0 || next == heights_.size()) return;
  const double share = (below_tdc - heights_[next - 1]) / (heights_[next] - heights_[next - 1]);
  for (std::size_t i = 0; i < inputs.bore_force.size(); ++i) {
    inputs.bore_force[i] = (1 - share) * force_[next - 1][i] + share * force_[next][i];
  }
}

std::vector<double> BendingRing::without_film(double below_tdc, double gas_load) const {
  std::vector<double> clearance(2 * static_cast<std::size_t>(elements_.n_nodes()), 0.0);
  const double gas = std::max(gas_load, 0.0) * case_.engine.bore / 2;
  try {
    const models::RingClosure closed(models::RingAtWall(beam_, bore_at(below_tdc), gas));
    for (int i = 0; i < elements_.n_nodes(); ++i) {
      const double phi = elements_.phi()[i], step = 0.1 * elements_.slope_length(i);
      const double before = std::max(phi - step, elements_.phi().front());
      const double after = std::min(phi + step, elements_.phi().back());
      clearance[2 * i] = closed.clearance(phi);
      clearance[2 * i + 1] =
          (closed.clearance(after) - closed.clearance(before)) / (after - before) * elements_.slope_length(i);
    }
  } catch (const ConvergenceError&) {
  }
  return clearance;
}

}  // namespace ringfilm::cycle
