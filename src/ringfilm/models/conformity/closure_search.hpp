#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ringfilm/models/conformity/lift_off.hpp"

namespace ringfilm::models {

/// A part of the ring that touches, while it is sought.
struct SoughtContact {
  double from = 0, to = 0;  ///< [rad]
  bool is_arc = false;      ///< else a point, from = to
};

/// Finds the contact arcs of a ring: a start on a grid, Newton's method for the edges, and repairs of what contradicts
/// the conditions of contact.
class ClosureSearch {
 public:
  explicit ClosureSearch(std::shared_ptr<const RingAtWall> ring) : ring_(std::move(ring)) {}

  /// @param n_steps of the grid of the start @returns whether all conditions hold
  bool solve(int n_steps);

  const std::vector<SoughtContact>& contacts() const { return contacts_; }
  const std::vector<LiftOff>& lift_offs() const { return spans_; }
  /// The lift-off before and after a contact; nullptr where the ring ends.
  const LiftOff* before(std::size_t contact) const;
  const LiftOff* after(std::size_t contact) const;
  /// Force at the start and the end of a contact, of a point all at its start [N].
  double force_at_start(std::size_t contact) const;
  double force_at_end(std::size_t contact) const;

 private:
  struct Unknown {
    std::size_t contact;
    double SoughtContact::*edge;
  };

  bool starts_at_tip(const SoughtContact& one) const { return one.from <= ring_->start(); }
  bool ends_at_tip(const SoughtContact& one) const { return one.to >= ring_->end(); }
  bool may_touch_at(double tip) const;
  void start_on_grid(int n_steps);
  std::optional<double> edge_of_free_tip(double tip, double from, double to) const;
  void free_tips();
  std::vector<Unknown> unknowns() const;
  void update_spans();
  std::vector<double> residuals(const std::vector<Unknown>& unknown) const;
  void shift(const Unknown& unknown, double by);
  bool find_edges();
  double allowed_share(const std::vector<Unknown>& unknown, const std::vector<double>& step) const;
  bool repaired();
  bool closed_arc_became_point();
  bool joined_contacts();
  bool released_pulled_point();
  bool moved_pulled_tip_edge();
  bool inserted_contact();
  bool inserted_lift_off();
  void touch_in(const LiftOff& span, double phi);
  void lift_off_from(std::size_t contact, double low, double high);

  std::shared_ptr<const RingAtWall> ring_;
  std::vector<SoughtContact> contacts_;
  std::vector<LiftOff> spans_;
};

}  // namespace ringfilm::models
