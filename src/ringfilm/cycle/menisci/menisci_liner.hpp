#pragma once
#include <vector>

#include "ringfilm/cycle/integration/liner_oil.hpp"
#include "ringfilm/cycle/menisci/liner_side.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/menisci/meniscus.hpp"

namespace ringfilm::cycle {

/// What a step moves, per length of circumference. Places on the liner count from the TDC position of the chamber edge.
struct OilOfStep {
  double left_end = 0, right_end = 0;  ///< places of the menisci at its end [m]
  double film_mass = 0;                ///< oil between them at its end [kg/m]
  double bead = 0;                     ///< at its end [kg/m]
  bool bead_bears_error = false;       ///< is the bead large, so that it takes what the step has missed?
  /// Mass per area that each meniscus leaves on the liner at the begin and at the end; 0 where it leaves none [kg/m2].
  film::OnLiner left_at_begin, left_at_end;
};

/// The oil on the liner on both sides of a film, and the account of all oil, which holds to round-off whatever error a
/// step makes (eq-menisci-oil).
class MenisciLiner {
 public:
  /// The fresh liner, for a ring without film. @param place of the throat on the liner [m]
  MenisciLiner(const Setup& setup, double place);

  /// Oil on the liner next to two places. @param left,right of the menisci [m]
  film::OnLiner next_to(double left, double right) const {
    return {left_.mean_beyond(-left), right_.mean_beyond(right)};
  }

  /// What the leading meniscus meets on its way from its place to another one [kg/m2], as a mean, and its mass [kg/m].
  struct Met {
    double mean, mass;
  };
  Met met(bool left_leads, double place) const {
    const LinerSide& side = left_leads ? left_ : right_;
    const double to = left_leads ? -place : place;
    return {side.mean_between(side.end(), to), side.mass_between(side.end(), to)};
  }

  /// What the menisci take up and leave in a step that has been accepted.
  void pass(const OilOfStep& step);
  /// Oil that hung in the gap behind the film when a stroke began, eq-hung-oil, comes to lie as the liner has drained
  /// it.
  /// @param left is it the side of the left meniscus?  @param from place of the meniscus when the stroke began [m]
  /// @param drained oil over the distance from there that the liner has moved [m, kg/m2]
  void drain(bool left, double from, const std::vector<LinerSide::Point>& drained);
  /// The bead, all of it where surplus is lost, goes to what is scraped. @param up in an upstroke
  void scrape(bool up);
  /// The oil ring lays its film beyond its reach: ahead of a downstroke.
  void replenish();

  double bead() const { return bead_; }      ///< [kg/m]
  double length() const { return length_; }  ///< liner from TDC position to BDC position of the ring [m]

  /// Oil since the start [kg/m], of which `taken` and `left` are not counted.
  using Account = LinerOil::Account;
  const Account& account() const { return account_; }
  /// All oil, less what was laid and with what was scraped: it does not change [kg/m].
  double all() const;
  double owed() const { return owed_; }  ///< to be laid by the next step; below 0: too much was laid [kg/m]

  /// Mass per area in equal cells along the liner, as far as the film does not cover it [kg/m2].
  std::vector<double> in_cells(std::size_t n) const;
  /// Other oil in such cells [kg/m2].
  void replace(const std::vector<double>& cells);
  /// Mean between two places that the film does not cover [kg/m2].
  double mean(double begin, double end) const {
    return (left_.mass_between(-end, -begin) + right_.mass_between(begin, end)) / (end - begin);
  }

 private:
  void add_supply(double begin, double end, double share, LinerSide& side, double sign) const;

  const Setup* setup_;
  double face_width_, length_, reach_;  ///< [m]
  LinerSide left_, right_;
  double film_mass_ = 0, bead_ = 0, owed_ = 0;  ///< [kg/m]
  Account account_;
};

}  // namespace ringfilm::cycle
