#include "ringfilm/models/conformity/lift_off.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

namespace ringfilm::models {
namespace {

using PanelRule = boost::math::quadrature::gauss<double, 15>;
constexpr double kWidestPanel = 0.1;  // [rad]; 15 points resolve more than 100 periods around the bore

/// Free solutions of c'''' + 2 c'' + c = 0 over x from the state at x = 0.
LiftOffState free_state(const LiftOffState& s, double x) {
  const double cosine = std::cos(x), sine = std::sin(x);
  // sin x - x cos x cancels for small x.
  const double cubic = std::abs(x) < 0.02 ? x * x * x / 3 * (1 - x * x / 10 * (1 - x * x / 28)) : sine - x * cosine;
  return {s.c * cosine + s.slope * sine + s.bending * x * sine / 2 + s.bending_slope * cubic / 2,
          -s.c * sine + s.slope * cosine + s.bending * (sine + x * cosine) / 2 + s.bending_slope * x * sine / 2,
          s.bending * cosine + s.bending_slope * sine, -s.bending * sine + s.bending_slope * cosine};
}

LiftOffState sum(const LiftOffState& a, const LiftOffState& b, double factor) {
  return {a.c + factor * b.c, a.slope + factor * b.slope, a.bending + factor * b.bending,
          a.bending_slope + factor * b.bending_slope};
}

/// The members of a state that an end of the ring prescribes.
struct EndRule {
  double LiftOffState::*first;
  double first_value;
  double LiftOffState::*second;
  double second_value;
};

EndRule end_rule(const RingAtWall& ring, SpanEnd end, double phi) {
  if (end == SpanEnd::kContact) return {&LiftOffState::c, 0, &LiftOffState::slope, 0};
  const double k = ring.beam().stiffness(), bending = -ring.moment_in_contact(phi) / k;
  if (end == SpanEnd::kContactTip) return {&LiftOffState::c, 0, &LiftOffState::bending, bending};
  return {&LiftOffState::bending, bending, &LiftOffState::bending_slope, -ring.moment_slope_in_contact(phi) / k};
}

/// The two unit states that an end leaves open.
std::pair<LiftOffState, LiftOffState> open_states(SpanEnd end) {
  switch (end) {
    case SpanEnd::kContact:
      return {{0, 0, 1, 0}, {0, 0, 0, 1}};
    case SpanEnd::kFreeTip:
      return {{1, 0, 0, 0}, {0, 1, 0, 0}};
    case SpanEnd::kContactTip:
      break;
  }
  return {{0, 1, 0, 0}, {0, 0, 0, 1}};
}

}  // namespace

RingAtWall::RingAtWall(const RingBeam& beam, const FourierSeries& bore, double gas)
    : beam_(beam), bore_(bore), gas_(gas) {
  std::vector<FourierOrder> force = beam.target_force().orders(), bending;
  force.push_back({0, gas, 0});
  const double k = beam.stiffness();
  for (const FourierOrder& one : bore.orders()) {
    const double factor = 1 - static_cast<double>(one.order) * one.order;
    force.push_back({one.order, -k / beam.centroid_radius() * factor * factor * one.amplitude, one.phase});
    bending.push_back({one.order, k * factor * one.amplitude, one.phase});
  }
  force_ = FourierSeries(std::move(force));
  bending_ = FourierSeries(std::move(bending));
}

double RingAtWall::end() const { return 2 * std::numbers::pi - start(); }
double RingAtWall::moment_in_contact(double phi) const { return beam_.target_moment(phi) - bending_(phi); }
double RingAtWall::moment_slope_in_contact(double phi) const {
  return beam_.target_moment_slope(phi) - bending_.derivative(phi, 1);
}
double RingAtWall::roundness_defect() const {
  return bending_.bound() / (beam_.size().tangential_force * beam_.centroid_radius());
}

LiftOffState LiftOff::carried(const LiftOffState& state, double from, double to) const {
  const double per_force = -ring_->beam().centroid_radius() / ring_->beam().stiffness(), width = to - from;
  LiftOffState all = free_state(state, width);
  const auto add = [&](double s, double weight) {
    const LiftOffState kick = free_state({0, 0, 0, 1}, to - s);
    all = sum(all, kick, weight * per_force * ring_->force_in_contact(s));
  };
  const auto& nodes = PanelRule::abscissa();
  const auto& weights = PanelRule::weights();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double middle = (from + to) / 2, half = width / 2;
    add(middle + half * nodes[i], half * weights[i]);
    if (nodes[i] != 0) add(middle - half * nodes[i], half * weights[i]);
  }
  return all;
}

LiftOff::LiftOff(std::shared_ptr<const RingAtWall> ring, double from, SpanEnd from_end, double to, SpanEnd to_end)
    : ring_(std::move(ring)), from_(from), to_(to) {
  const int panels = std::max(1, static_cast<int>(std::ceil((to - from) / kWidestPanel)));
  for (int i = 0; i <= panels; ++i) ends_.push_back(i < panels ? from + (to - from) * i / panels : to);
  const EndRule known = end_rule(*ring_, from_end, from), sought = end_rule(*ring_, to_end, to);
  LiftOffState base;
  base.*known.first = known.first_value;
  base.*known.second = known.second_value;
  LiftOffState driven = base;
  for (int i = 0; i < panels; ++i) driven = carried(driven, ends_[i], ends_[i + 1]);
  const auto [one, other] = open_states(from_end);
  const LiftOffState a = free_state(one, to - from), b = free_state(other, to - from);
  const double miss_1 = sought.first_value - driven.*sought.first, miss_2 = sought.second_value - driven.*sought.second;
  const double determinant = a.*sought.first * (b.*sought.second) - b.*sought.first * (a.*sought.second);
  const double size_1 = (miss_1 * (b.*sought.second) - miss_2 * (b.*sought.first)) / determinant;
  const double size_2 = (miss_2 * (a.*sought.first) - miss_1 * (a.*sought.second)) / determinant;
  states_.push_back(sum(sum(base, one, size_1), other, size_2));
  for (int i = 0; i < panels; ++i) states_.push_back(carried(states_.back(), ends_[i], ends_[i + 1]));
}

LiftOffState LiftOff::at(double phi) const {
  const auto after = std::upper_bound(ends_.begin(), ends_.end(), phi);
  const std::size_t panel = after == ends_.begin() ? 0 : static_cast<std::size_t>(after - ends_.begin()) - 1;
  return ends_[panel] == phi ? states_[panel] : carried(states_[panel], ends_[panel], phi);
}

double LiftOff::moment(double phi) const {
  return ring_->moment_in_contact(phi) + ring_->beam().stiffness() * at(phi).bending;
}

LiftOff::Extreme LiftOff::extreme(double sign) const {
  constexpr int kSamples = 12;  // samples per panel
  Extreme best{from_, sign * first().c};
  const double step = (to_ - from_) / (kSamples * static_cast<double>(ends_.size() - 1));
  const int n = kSamples * static_cast<int>(ends_.size() - 1);
  for (int i = 1; i <= n; ++i) {
    const double phi = i < n ? from_ + i * step : to_, c = sign * at(phi).c;
    if (c > best.clearance) best = {phi, c};
  }
  const double low = std::max(from_, best.phi - step), high = std::min(to_, best.phi + step);
  const auto negative = [&](double phi) { return -sign * at(phi).c; };
  const auto [phi, value] = boost::math::tools::brent_find_minima(negative, low, high, 40);
  if (-value > best.clearance) best = {phi, -value};
  return {best.phi, sign * best.clearance};
}

LiftOff::Extreme LiftOff::largest() const { return extreme(1); }
LiftOff::Extreme LiftOff::smallest() const { return extreme(-1); }

double LiftOff::area() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
    sum += PanelRule::integrate([&](double phi) { return at(phi).c; }, ends_[i], ends_[i + 1]);
  }
  return sum;
}

}  // namespace ringfilm::models
