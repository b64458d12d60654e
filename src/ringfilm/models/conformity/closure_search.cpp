#include "ringfilm/models/conformity/closure_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ringfilm/models/conformity/contact_guess.hpp"

namespace ringfilm::models {
namespace {

constexpr double kMinArc = 1e-7;  // [rad]; a shorter one is a point
constexpr double kForceTolerance = 1e-8;

}  // namespace

bool ClosureSearch::may_touch_at(double tip) const {
  // A lift-off of a tip shorter than a ten-thousandth of a radian is lost in rounding, and without any clearance.
  constexpr double kNoMoment = 1e-9;
  const double scale = (ring_->beam().size().tangential_force + ring_->gas()) * ring_->beam().centroid_radius();
  const double slope = ring_->moment_slope_in_contact(tip);
  return std::abs(ring_->moment_in_contact(tip)) <= kNoMoment * scale &&
         (tip <= ring_->start() ? slope : -slope) >= -kNoMoment * scale;
}

void ClosureSearch::start_on_grid(int n_steps) {
  const std::vector<bool> touches = contact_on_grid(*ring_, n_steps);
  const double step = (ring_->end() - ring_->start()) / n_steps;
  const auto place = [&](int i) { return i == n_steps ? ring_->end() : ring_->start() + i * step; };
  std::vector<std::pair<int, int>> runs;
  for (int i = 0; i <= n_steps; ++i) {
    if (!touches[static_cast<std::size_t>(i)]) continue;
    if (!runs.empty() && i - runs.back().second <= 3) {
      runs.back().second = i;
    } else {
      runs.emplace_back(i, i);
    }
  }
  contacts_.clear();
  for (const auto& [first, last] : runs) {
    if (last - first >= 3) {
      contacts_.push_back({place(first), place(last), true});
    } else {
      const double middle = first == 0        ? ring_->start()
                            : last == n_steps ? ring_->end()
                                              : (place(first) + place(last)) / 2;
      contacts_.push_back({middle, middle, false});
    }
  }
  free_tips();
}

/// A free tip may have two edges at which the moment is continuous; at the nearer one the wall would pull.
std::optional<double> ClosureSearch::edge_of_free_tip(double tip, double from, double to) const {
  constexpr double kStep = 1e-4, kFarthest = 0.5;  // [rad]
  const double way = to > from ? 1 : -1, r_gas = ring_->beam().centroid_radius() * ring_->gas();
  bool was_negative = false;
  for (double x = kStep; x < std::min(kFarthest, std::abs(to - from)); x += kStep) {
    const double phi = from + way * x;
    const double excess = ring_->moment_in_contact(phi) + r_gas * (1 - std::cos(phi - tip));
    if (was_negative && excess > 0) return phi;
    was_negative = was_negative || excess < 0;
  }
  return std::nullopt;
}

/// An arc up to a tip is possible only where the bore does not bend the ring there: the moment of a free end is zero.
void ClosureSearch::free_tips() {
  if (contacts_.empty()) return;
  const RingBeam& beam = ring_->beam();
  const double r_force = beam.centroid_radius() * (beam.size().tangential_force + ring_->gas());
  const auto reach = [&](double defect, const SoughtContact& arc) {
    const double length = std::sqrt((defect > 0 ? 2 : 4) * std::abs(defect) / r_force);
    return std::min(length, 0.4 * (arc.to - arc.from));
  };
  SoughtContact& first = contacts_.front();
  if (first.is_arc && starts_at_tip(first) && !may_touch_at(ring_->start())) {
    const double defect = -ring_->moment_in_contact(ring_->start());
    const std::optional<double> edge = edge_of_free_tip(ring_->start(), first.from, first.to);
    first.from = defect > 0 && edge ? *edge : first.from + reach(defect, first);
    if (defect < 0) contacts_.insert(contacts_.begin(), {ring_->start(), ring_->start(), false});
  }
  SoughtContact& last = contacts_.back();
  if (last.is_arc && ends_at_tip(last) && !may_touch_at(ring_->end())) {
    const double defect = -ring_->moment_in_contact(ring_->end());
    const std::optional<double> edge = edge_of_free_tip(ring_->end(), last.to, last.from);
    last.to = defect > 0 && edge ? *edge : last.to - reach(defect, last);
    if (defect < 0) contacts_.push_back({ring_->end(), ring_->end(), false});
  }
}

std::vector<ClosureSearch::Unknown> ClosureSearch::unknowns() const {
  std::vector<Unknown> all;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const SoughtContact& one = contacts_[i];
    if (!starts_at_tip(one) && !(ends_at_tip(one) && !one.is_arc)) all.push_back({i, &SoughtContact::from});
    if (one.is_arc && !ends_at_tip(one)) all.push_back({i, &SoughtContact::to});
  }
  return all;
}

void ClosureSearch::update_spans() {
  spans_.clear();
  for (std::size_t i = 0; i <= contacts_.size(); ++i) {
    const bool has_left = i > 0, has_right = i < contacts_.size();
    const double from = has_left ? contacts_[i - 1].to : ring_->start();
    const double to = has_right ? contacts_[i].from : ring_->end();
    if (to <= from) continue;
    const auto kind = [&](bool has_contact, const SoughtContact* one, bool at_tip) {
      if (!has_contact) return SpanEnd::kFreeTip;
      return at_tip && !one->is_arc ? SpanEnd::kContactTip : SpanEnd::kContact;
    };
    const SoughtContact* left = has_left ? &contacts_[i - 1] : nullptr;
    const SoughtContact* right = has_right ? &contacts_[i] : nullptr;
    spans_.emplace_back(ring_, from, kind(has_left, left, has_left && starts_at_tip(*left)), to,
                        kind(has_right, right, has_right && ends_at_tip(*right)));
  }
}

const LiftOff* ClosureSearch::before(std::size_t contact) const {
  for (const LiftOff& span : spans_) {
    if (span.to() == contacts_[contact].from && span.from() < span.to()) return &span;
  }
  return nullptr;
}

const LiftOff* ClosureSearch::after(std::size_t contact) const {
  for (const LiftOff& span : spans_) {
    if (span.from() == contacts_[contact].to) return &span;
  }
  return nullptr;
}

std::vector<double> ClosureSearch::residuals(const std::vector<Unknown>& unknown) const {
  std::vector<double> all;
  for (const Unknown& one : unknown) {
    const LiftOff *left = before(one.contact), *right = after(one.contact);
    if (!contacts_[one.contact].is_arc) {
      all.push_back(right->first().bending - left->last().bending);
    } else {
      all.push_back(one.edge == &SoughtContact::from ? left->last().bending : right->first().bending);
    }
  }
  return all;
}

void ClosureSearch::shift(const Unknown& unknown, double by) {
  SoughtContact& one = contacts_[unknown.contact];
  one.*unknown.edge += by;
  if (!one.is_arc) one.to = one.from;
}

/// The share of a step that leaves every arc and every lift-off a part of its length.
double ClosureSearch::allowed_share(const std::vector<Unknown>& unknown, const std::vector<double>& step) const {
  constexpr double kLeft = 0.3, kFarthest = 0.2;
  std::vector<SoughtContact> moved = contacts_;
  double share = 1;
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    SoughtContact& one = moved[unknown[i].contact];
    one.*unknown[i].edge += step[i];
    if (!one.is_arc) one.to = one.from;
    share = std::min(share, kFarthest / std::max(kFarthest, std::abs(step[i])));
  }
  double edge = ring_->start(), moved_edge = edge;
  const auto limit = [&](double length, double moved_length) {
    if (length > 0 && moved_length < kLeft * length) {
      share = std::min(share, (1 - kLeft) * length / (length - moved_length));
    }
  };
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    limit(contacts_[i].from - edge, moved[i].from - moved_edge);
    limit(contacts_[i].to - contacts_[i].from, moved[i].to - moved[i].from);
    edge = contacts_[i].to;
    moved_edge = moved[i].to;
  }
  limit(ring_->end() - edge, ring_->end() - moved_edge);
  return share;
}

bool ClosureSearch::find_edges() {
  constexpr int kMaxSteps = 60;
  constexpr double kProbe = 1e-6, kEnough = 1e-11;
  const std::vector<Unknown> unknown = unknowns();
  const std::size_t n = unknown.size();
  update_spans();
  for (int i = 0; i < kMaxSteps && n > 0; ++i) {
    const std::vector<double> miss = residuals(unknown);
    double reach = kProbe;
    for (const LiftOff& span : spans_) reach = std::min(reach, 0.1 * (span.to() - span.from()));
    Eigen::MatrixXd slopes(n, n);
    for (std::size_t j = 0; j < n; ++j) {
      const SoughtContact& one = contacts_[unknown[j].contact];
      // An arc may be shorter than the probe: edges move outwards.
      const double probe = one.is_arc && unknown[j].edge == &SoughtContact::from ? -reach : reach;
      const std::vector<SoughtContact> kept = contacts_;
      shift(unknown[j], probe);
      update_spans();
      const std::vector<double> probed = residuals(unknown);
      for (std::size_t row = 0; row < n; ++row) slopes(row, j) = (probed[row] - miss[row]) / probe;
      contacts_ = kept;
    }
    Eigen::FullPivLU<Eigen::MatrixXd> factors(slopes);
    factors.setThreshold(0.0);  // an unknown that no residual depends on stays, but no other
    std::vector<double> step(n);
    Eigen::VectorXd::Map(step.data(), step.size()) = -factors.solve(Eigen::VectorXd::Map(miss.data(), miss.size()));
    const double share = allowed_share(unknown, step);
    double longest = 0;
    for (std::size_t j = 0; j < n; ++j) {
      shift(unknown[j], share * step[j]);
      longest = std::max(longest, std::abs(step[j]));
    }
    update_spans();
    if (longest < kEnough) return true;
    const bool closed = std::any_of(contacts_.begin(), contacts_.end(),
                                    [](const auto& one) { return one.is_arc && one.to - one.from < kMinArc; });
    const bool joined =
        std::any_of(spans_.begin(), spans_.end(), [](const LiftOff& one) { return one.to() - one.from() < kMinArc; });
    if (closed || joined) return true;  // a repair makes it a point, or an arc
  }
  return n == 0;
}

double ClosureSearch::force_at_start(std::size_t contact) const {
  const SoughtContact& one = contacts_[contact];
  const double r = ring_->beam().centroid_radius(), k = ring_->beam().stiffness();
  const LiftOff *left = before(contact), *right = after(contact);
  if (starts_at_tip(one)) {
    const double bending = !one.is_arc && right != nullptr ? k * right->first().bending_slope : 0;
    return (ring_->moment_slope_in_contact(one.from) + bending) / r;
  }
  const double from_left = left != nullptr ? left->last().bending_slope : 0;
  if (one.is_arc) return -k * from_left / r;
  if (ends_at_tip(one)) return -(ring_->moment_slope_in_contact(one.to) + k * from_left) / r;
  return k * (right->first().bending_slope - from_left) / r;
}

double ClosureSearch::force_at_end(std::size_t contact) const {
  const SoughtContact& one = contacts_[contact];
  if (!one.is_arc) return 0;
  const double r = ring_->beam().centroid_radius();
  if (ends_at_tip(one)) return -ring_->moment_slope_in_contact(one.to) / r;
  return ring_->beam().stiffness() * after(contact)->first().bending_slope / r;
}

bool ClosureSearch::closed_arc_became_point() {
  for (SoughtContact& one : contacts_) {
    if (!one.is_arc || one.to - one.from >= kMinArc) continue;
    one.is_arc = false;
    one.from = one.to = starts_at_tip(one) ? ring_->start() : ends_at_tip(one) ? ring_->end() : (one.from + one.to) / 2;
    return true;
  }
  return false;
}

/// Contacts in their order, within the ring, with lift-offs between them. @returns whether that was not so
bool ClosureSearch::joined_contacts() {
  bool changed = false;
  std::vector<SoughtContact> joined;
  for (SoughtContact one : contacts_) {
    const SoughtContact as_found = one;
    if (one.from - ring_->start() < kMinArc) one.from = ring_->start();
    if (ring_->end() - one.to < kMinArc) one.to = ring_->end();
    if (!one.is_arc) one.from = one.to = one.to >= ring_->end() ? one.to : one.from;
    changed = changed || one.from != as_found.from || one.to != as_found.to;
    if (joined.empty() || one.from - joined.back().to >= kMinArc) {
      joined.push_back(one);
      continue;
    }
    SoughtContact& last = joined.back();
    last = {std::min(last.from, one.from), std::max(last.to, one.to), true};
    changed = true;
  }
  if (!changed) return false;
  contacts_ = std::move(joined);
  free_tips();
  return true;
}

bool ClosureSearch::released_pulled_point() {
  std::size_t worst = contacts_.size();
  double lowest = -kForceTolerance * (ring_->beam().size().tangential_force + ring_->gas());
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (contacts_[i].is_arc) continue;
    const double force = force_at_start(i);
    if (force < lowest) {
      lowest = force;
      worst = i;
    }
  }
  if (worst == contacts_.size()) return false;
  contacts_.erase(contacts_.begin() + static_cast<std::ptrdiff_t>(worst));
  return true;
}

bool ClosureSearch::moved_pulled_tip_edge() {
  const double lowest = -kForceTolerance * (ring_->beam().size().tangential_force + ring_->gas());
  SoughtContact &first = contacts_.front(), &last = contacts_.back();
  if (first.is_arc && !starts_at_tip(first) && force_at_start(0) < lowest) {
    const std::optional<double> edge = edge_of_free_tip(ring_->start(), first.from, first.to);
    first.from = edge.value_or(first.from);
    if (edge) return true;
  }
  if (!last.is_arc || ends_at_tip(last) || force_at_end(contacts_.size() - 1) >= lowest) return false;
  const std::optional<double> edge = edge_of_free_tip(ring_->end(), last.to, last.from);
  last.to = edge.value_or(last.to);
  return edge.has_value();
}

void ClosureSearch::touch_in(const LiftOff& span, double phi) {
  const double tiny = 1e-6;
  // Next to a point that touches, the contact is an arc, or there are two points where no arc can be.
  for (SoughtContact& one : contacts_) {
    const double distance = std::abs(phi - one.from);
    if (one.is_arc || (one.from != span.from() && one.from != span.to())) continue;
    if (distance > 0.25 * (span.to() - span.from())) continue;
    if (starts_at_tip(one) || ends_at_tip(one)) {
      one = {phi, phi, false};  // the tip lifts, and the ring touches beside it
      return;
    }
    if (ring_->force_in_contact(one.from) < 0) continue;
    one = {one.from - distance, one.from + distance, true};
    return;
  }
  double place = phi;
  if (phi - ring_->start() < tiny) place = ring_->start();
  if (ring_->end() - phi < tiny) place = ring_->end();
  const auto next = std::find_if(contacts_.begin(), contacts_.end(), [&](const auto& one) { return one.from > place; });
  contacts_.insert(next, {place, place, false});
}

bool ClosureSearch::inserted_contact() {
  double largest = 0;
  for (const LiftOff& span : spans_) largest = std::max(largest, span.largest().clearance);
  const LiftOff* worst = nullptr;
  LiftOff::Extreme lowest{0, -1e-8 * largest};
  for (const LiftOff& span : spans_) {
    const LiftOff::Extreme one = span.smallest();
    if (one.clearance < lowest.clearance) {
      lowest = one;
      worst = &span;
    }
  }
  if (worst == nullptr) return false;
  touch_in(*worst, lowest.phi);
  return true;
}

void ClosureSearch::lift_off_from(std::size_t contact, double low, double high) {
  SoughtContact& one = contacts_[contact];
  const double margin = (high - low) / 2;
  if (low <= one.from && high >= one.to) {
    const SoughtContact end{one.to, one.to, false};
    one = {one.from, one.from, false};
    contacts_.insert(contacts_.begin() + static_cast<std::ptrdiff_t>(contact) + 1, end);
    return;
  }
  // A point stays at the edge, which alone would come back; where the wall would pull at it, it is released.
  if (low <= one.from && !starts_at_tip(one)) {
    const SoughtContact edge{one.from, one.from, false};
    one.from = std::min(high + margin, (high + one.to) / 2);
    contacts_.insert(contacts_.begin() + static_cast<std::ptrdiff_t>(contact), edge);
  } else if (high >= one.to && !ends_at_tip(one)) {
    const SoughtContact edge{one.to, one.to, false};
    one.to = std::max(low - margin, (low + one.from) / 2);
    contacts_.insert(contacts_.begin() + static_cast<std::ptrdiff_t>(contact) + 1, edge);
  } else {
    const SoughtContact rest{std::min(high + margin, (high + one.to) / 2), one.to, true};
    one.to = std::max(low - margin, (low + one.from) / 2);
    contacts_.insert(contacts_.begin() + static_cast<std::ptrdiff_t>(contact) + 1, rest);
  }
}

bool ClosureSearch::inserted_lift_off() {
  constexpr double kSample = 0.004;  // [rad]
  const double lowest = -kForceTolerance * (ring_->beam().size().tangential_force + ring_->gas());
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const SoughtContact& one = contacts_[i];
    if (!one.is_arc) continue;
    const int n = 8 + static_cast<int>((one.to - one.from) / kSample);
    const auto place = [&](int j) { return one.from + (one.to - one.from) * j / n; };
    for (int j = 0; j <= n; ++j) {
      if (ring_->force_in_contact(place(j)) >= lowest) continue;
      int last = j;
      while (last < n && ring_->force_in_contact(place(last + 1)) < 0) ++last;
      lift_off_from(i, place(std::max(0, j - 1)), place(std::min(n, last + 1)));
      return true;
    }
  }
  return false;
}

bool ClosureSearch::repaired() {
  return closed_arc_became_point() || joined_contacts() || released_pulled_point() || moved_pulled_tip_edge() ||
         inserted_lift_off() || inserted_contact();
}

bool ClosureSearch::solve(int n_steps) {
  constexpr int kMaxRepairs = 100;
  start_on_grid(n_steps);
  for (int i = 0; i < kMaxRepairs; ++i) {
    joined_contacts();
    if (contacts_.empty() || !find_edges()) return false;
    if (!repaired()) return true;
  }
  return false;
}

}  // namespace ringfilm::models
