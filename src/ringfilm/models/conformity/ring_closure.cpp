#include "ringfilm/models/conformity/ring_closure.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "ringfilm/base/error.hpp"
#include "ringfilm/models/conformity/closure_search.hpp"

namespace ringfilm::models {
namespace {

using ArcRule = boost::math::quadrature::gauss<double, 15>;

template <class Function>
double integral(const Function& f, double from, double to) {
  constexpr double kPanel = 0.1;  // [rad]
  const int panels = std::max(1, static_cast<int>(std::ceil((to - from) / kPanel)));
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    sum += ArcRule::integrate(f, from + (to - from) * i / panels, from + (to - from) * (i + 1) / panels);
  }
  return sum;
}

ClosureSearch found(const std::shared_ptr<const RingAtWall>& ring) {
  ClosureSearch search(ring);
  for (const int n_steps : {720, 1440, 360, 2880}) {
    if (search.solve(n_steps)) return search;
  }
  throw ConvergenceError("no set of contact arcs of the ring in this bore meets all conditions of contact");
}

}  // namespace

RingClosure::RingClosure(const RingAtWall& ring) : ring_(std::make_shared<const RingAtWall>(ring)) {
  const ClosureSearch search = found(ring_);
  const auto& contacts = search.contacts();
  const double smallest = 1e-12 * (ring.beam().size().tangential_force + ring.gas());  // rounding
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    (contacts[i].is_arc ? arcs_ : points_).push_back({contacts[i].from, contacts[i].to});
    for (const PointForce& one :
         {PointForce{contacts[i].from, search.force_at_start(i)}, PointForce{contacts[i].to, search.force_at_end(i)}}) {
      if (one.force > smallest) forces_.push_back(one);
    }
  }
  lift_offs_ = search.lift_offs();
}

LiftOff::Extreme RingClosure::largest_clearance() const {
  LiftOff::Extreme best{ring_->start(), 0};
  for (const LiftOff& span : lift_offs_) {
    const LiftOff::Extreme one = span.largest();
    // In a symmetric bore two clearances may be equal: the first is taken, so that rounding does not decide.
    if (one.clearance > best.clearance * (1 + 1e-9)) best = one;
  }
  return best;
}

double RingClosure::clearance_integral() const {
  double sum = 0;
  for (const LiftOff& span : lift_offs_) sum += span.area();
  return sum;
}

double RingClosure::contact_angle() const {
  double sum = 0;
  for (const ContactArc& arc : arcs_) sum += arc.to - arc.from;
  return sum;
}

const LiftOff* RingClosure::lift_off_at(double phi) const {
  for (const LiftOff& span : lift_offs_) {
    if (phi >= span.from() && phi <= span.to()) return &span;
  }
  return nullptr;
}

double RingClosure::clearance(double phi) const {
  const LiftOff* span = lift_off_at(phi);
  return span == nullptr ? 0 : span->at(phi).c;
}

double RingClosure::line_force(double phi) const {
  return lift_off_at(phi) == nullptr ? ring_->force_in_contact(phi) : 0;
}

double RingClosure::moment(double phi) const {
  const LiftOff* span = lift_off_at(phi);
  return span == nullptr ? ring_->moment_in_contact(phi) : span->moment(phi);
}

double RingClosure::line_force_between(double from, double to) const {
  double sum = 0;
  for (const ContactArc& arc : arcs_) {
    const double low = std::max(from, arc.from), high = std::min(to, arc.to);
    if (high > low) sum += integral([&](double phi) { return ring_->force_in_contact(phi); }, low, high);
  }
  return sum;
}

double RingClosure::force_up_to(double phi) const {
  double sum = line_force_between(ring_->start(), phi);
  for (const PointForce& one : forces_) {
    if (one.phi <= phi) sum += one.force;
  }
  return sum;
}

double RingClosure::force_in_points() const {
  double sum = 0;
  for (const PointForce& one : forces_) sum += one.force;
  return sum;
}

double RingClosure::force() const { return line_force_between(ring_->start(), ring_->end()) + force_in_points(); }

double RingClosure::unbalanced_share() const {
  const double gas = ring_->gas(), from = ring_->start(), to = ring_->end();
  double x = -gas * (std::sin(to) - std::sin(from)), y = gas * (std::cos(to) - std::cos(from));
  for (const ContactArc& arc : arcs_) {
    x += integral([&](double phi) { return ring_->force_in_contact(phi) * std::cos(phi); }, arc.from, arc.to);
    y += integral([&](double phi) { return ring_->force_in_contact(phi) * std::sin(phi); }, arc.from, arc.to);
  }
  for (const PointForce& one : forces_) {
    x += one.force * std::cos(one.phi);
    y += one.force * std::sin(one.phi);
  }
  return std::hypot(x, y) / ring_->beam().size().tangential_force;
}

}  // namespace ringfilm::models
