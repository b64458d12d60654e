#include "ringfilm/cycle/closure/bending_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/setup/kinematics.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

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

/// Those at which the bore is given, within the stroke, and its ends: lists of the bore may reach to different heights.
std::vector<double> heights_of_stroke(const Case& c) {
  std::vector<double> given = bore_heights(c), heights;
  if (given.empty()) return given;
  const double stroke = c.engine.stroke;
  heights.push_back(0);
  for (const double height : given) {
    if (height > 0 && height < stroke) heights.push_back(height);
  }
  heights.push_back(stroke);
  return heights;
}

/// Two neighbours in a cycle, and how far from the first towards the second.
struct Between {
  std::size_t first, second;
  double share;
};

Between sections_at(const std::vector<double>& angle, double crank_angle_deg) {
  const std::size_t n = angle.size();
  const auto above = std::upper_bound(angle.begin(), angle.end(), crank_angle_deg);
  const std::size_t second = static_cast<std::size_t>(above - angle.begin()) % n, first = (second + n - 1) % n;
  const auto from_first = [&](double to) { return std::fmod(to - angle[first] + kCycleDeg, kCycleDeg); };
  const double step = n == 1 ? kCycleDeg : from_first(angle[second]);
  return {first, second, from_first(crank_angle_deg) / step};
}

}  // namespace

BendingRing::BendingRing(const Case& c, const film::CircumferentialGrid& around)
    : case_(c),
      beam_(ring_beam(c)),
      first_node_(around.ends == film::Ends::kJoined ? 1 : 0),
      elements_(beam_, angles_of_nodes(beam_, around)),
      elastic_load_(elastic_pressure(c) * c.ring.face_width),
      heights_(heights_of_stroke(c)) {
  for (int j = 0; j < around.n_strips(); ++j) {
    target_.push_back(beam_.target_force()(elements_.phi()[j + first_node_]) / beam_.size().tangential_force);
  }
  if (heights_.empty()) force_.push_back(elements_.force_of_shape(bore_at(0)));
  for (const double height : heights_) force_.push_back(elements_.force_of_shape(bore_at(height)));
  append_dynamic_forces();
}

/// Each order once, whose shares in the sections add up.
void BendingRing::append_dynamic_forces() {
  for (const models::FourierSeries& section : dynamic_deviations(case_)) {
    dynamic_.push_back(section.turned(case_.ring.gap_position_deg * pi / 180));
    dynamic_force_.emplace_back(2 * elements_.phi().size(), 0.0);
  }
  const std::size_t n_orders = dynamic_.empty() ? 0 : dynamic_.front().orders().size();
  for (std::size_t k = 0; k < n_orders; ++k) {
    const int n = dynamic_.front().orders()[k].order;
    for (const double phase : {0.0, pi / (2 * std::max(n, 1))}) {
      const std::vector<double> unit = elements_.force_of_shape(models::FourierSeries({{n, 1, phase}}));
      for (std::size_t i = 0; i < dynamic_.size(); ++i) {
        const models::FourierOrder& one = dynamic_[i].orders()[k];
        const double share = one.amplitude * (phase == 0 ? std::cos(n * one.phase) : std::sin(n * one.phase));
        for (std::size_t j = 0; j < unit.size(); ++j) dynamic_force_[i][j] += share * unit[j];
      }
    }
  }
}

models::FourierSeries BendingRing::bore_at(double below_tdc) const {
  return bore_deviation(case_, below_tdc).turned(case_.ring.gap_position_deg * pi / 180);
}

std::vector<double> BendingRing::bore_at_strips(double below_tdc, double crank_angle_deg) const {
  const models::FourierSeries bore = bore_at(below_tdc);
  std::vector<double> at;
  for (std::size_t j = 0; j < target_.size(); ++j) at.push_back(bore(elements_.phi()[j + first_node_]));
  if (dynamic_.empty()) return at;
  const Between now = sections_at(case_.liner.dynamic->crank_angle_deg, crank_angle_deg);
  for (std::size_t j = 0; j < at.size(); ++j) {
    const double phi = elements_.phi()[j + first_node_];
    at[j] += (1 - now.share) * dynamic_[now.first](phi) + now.share * dynamic_[now.second](phi);
  }
  return at;
}

film::ElasticRing BendingRing::elastic_ring() const {
  static_assert(film::ElasticRing::kWidth == models::BeamElements::kWidth);
  return {first_node_, elements_.stiffness()};
}

void BendingRing::press(double below_tdc, double crank_angle_deg, film::Film2dInputs& inputs) const {
  inputs.strip_loads.clear();
  for (const double share : target_) inputs.strip_loads.push_back(inputs.strip.load + elastic_load_ * (share - 1));
  const auto above = std::upper_bound(heights_.begin(), heights_.end(), below_tdc);
  const auto next = static_cast<std::size_t>(above - heights_.begin());
  inputs.bore_force = force_[std::min(next, force_.size() - 1)];
  if (next > 0 && next < heights_.size()) {
    const double share = (below_tdc - heights_[next - 1]) / (heights_[next] - heights_[next - 1]);
    for (std::size_t i = 0; i < inputs.bore_force.size(); ++i) {
      inputs.bore_force[i] = (1 - share) * force_[next - 1][i] + share * force_[next][i];
    }
  }
  if (dynamic_.empty()) return;
  const Between now = sections_at(case_.liner.dynamic->crank_angle_deg, crank_angle_deg);
  for (std::size_t i = 0; i < inputs.bore_force.size(); ++i) {
    inputs.bore_force[i] += (1 - now.share) * dynamic_force_[now.first][i] + now.share * dynamic_force_[now.second][i];
  }
}

}  // namespace ringfilm::cycle
