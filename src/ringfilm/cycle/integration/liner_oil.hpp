#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/film_state.hpp"
#include "ringfilm/film/wall_transport.hpp"

/// The oil that lies on the liner and what passes of the ring leave of it (docs/theory/oil-supply.md).
namespace ringfilm::cycle {

/// Mass per area along the stroke, in cells. A cell that the edge of the ring divides holds that of its open part.
class LinerFilm {
 public:
  LinerFilm(double length, double mass_per_area);
  LinerFilm(double cell, std::vector<double> mass_per_area);

  /// Oil on the liner between two places that the ring does not cover [kg/m].
  double mass(double begin, double end) const;

  /// Lays oil on a stretch that an edge of the ring sets free. @param mass of it [kg/m]
  /// @param open_below the ring moves towards TDC: the open part of the last cell lies on the crankcase's side
  void lay(double begin, double end, double mass, bool open_below);

  const std::vector<double>& mass_per_area() const { return mass_per_area_; }
  /// Other oil in the same cells [kg/m2].
  void replace(std::vector<double> mass_per_area) { mass_per_area_ = std::move(mass_per_area); }
  double cell() const { return cell_; }
  double length() const { return cell_ * static_cast<double>(mass_per_area_.size()); }

 private:
  static constexpr int kCells = 4000;
  int cell_at(double place) const;

  double cell_;                        ///< [m]
  std::vector<double> mass_per_area_;  ///< [kg/m2]
};

/// Oil that lies elsewhere in one film on a liner than in another, as a share of all that the first one has [-].
/// Scatter from cell to cell, which follows the steps, does not count.
double share_elsewhere(const std::vector<double>& mass_per_area, const std::vector<double>& other);

/// Oil of which a ring notices no more [kg/m]: as thick as the surfaces are rough, over the width of its face.
double least_oil(const Setup& setup);

/// Strokes from firing TDC on: power, exhaust, intake, compression.
inline constexpr std::size_t kStrokes = 4;

/// Above the reach of the oil ring oil comes and goes slowly, over some tens of cycles. This share of what the oil ring
/// leaves is near the end of it in the cases of docs/theory/oil-supply.md [-].
inline constexpr double kFirstAboveReach = 0.1;

/// A liner down to the BDC position of its last ring, with the film that the oil ring leaves.
/// @param below_first_ring distance of that ring's chamber edge from that of the first ring [m]
LinerFilm fresh_liner(const Setup& last_ring, double below_first_ring);

/// Where a ring runs on a liner that it shares with others of its pack.
struct PlaceOnLiner {
  std::shared_ptr<LinerFilm> film;  ///< counted from the TDC position of the first ring; nullptr: the ring's own
  double below_first_ring = 0;      ///< distance of the ring's chamber edge from that of the first ring [m]
  bool is_last = true;              ///< only the oil ring follows
};

/// What the ring meets and leaves: the film on the liner, the beads of scraped oil ahead of its edges, and the
/// account of all oil. Per length of circumference.
class LinerOil {
 public:
  /// @param grid of the face, whose first and last cells are passed by what enters and leaves
  LinerOil(const Setup& setup, const film::FilmGrid& grid, const PlaceOnLiner& place);

  /// Does the ring move the other way than in the step before, or for the first time?
  bool turns(double from_deg, double to_deg) const { return !begun_ || sweep(from_deg, to_deg).up != up_; }

  /// The speed and the supply of a step of first order: what the leading edge sweeps lies ahead of it, and its bead.
  void limit(RingConditions& at, double from_deg, double to_deg) const;
  /// The same of a step of second order, eq-supply-of-step. @param of_flow_before as in pass
  void limit(RingConditions& at, double from_deg, double to_deg, double of_flow_before) const;

  /// Oil that passes the edges in a step, eq-step-flow: what enters ahead, and what leaves behind.
  /// @param at with the time step of the scheme  @param of_flow_before share of what the step before passed; 0 of first
  /// order  @param from_chamber,to_crankcase mass flows in +x from the chamber edge through the edges [kg/(m s)]
  film::PassedOil passed(const RingConditions& at, double of_flow_before, double from_chamber,
                         double to_crankcase) const;
  /// Takes an accepted step into account.
  void pass(const RingConditions& at, double from_deg, double to_deg, const film::PassedOil& passed);
  /// By how much the ring moves [m].
  double way(double from_deg, double to_deg) const { return sweep(from_deg, to_deg).length(); }

  /// Films by distance from the TDC position of the first ring, before and after the last passes of this one.
  struct Pass {
    std::vector<double> before, after;  ///< [kg/m2]
  };
  const std::array<Pass, kStrokes>& passes() const { return passes_; }
  const LinerFilm& film() const { return *film_; }
  double mean_on_liner() const { return film_->mass(0, film_->length()) / film_->length(); }  ///< [kg/m2]
  double bead() const { return std::max(bead_, 0.0); }  ///< ahead of the leading edge [kg/m]

  /// Oil since the start of the integration [kg/m].
  struct Account {
    double replenished = 0;   ///< laid on the liner by the oil ring, less what that took away
    double scraped_up = 0;    ///< left at TDC, or shed on upstrokes
    double scraped_down = 0;  ///< left at BDC, or shed on downstrokes
    double taken = 0;         ///< into the film under the ring
    double left = 0;          ///< out of it, behind the ring
  };
  const Account& account() const { return account_; }
  /// Account over the last whole cycle, from dead centre to dead centre.
  Account of_last_cycle() const;
  /// Mean film over the stretch of liner that the ring passes while it goes from one place below TDC to another.
  /// @param films of Pass [kg/m2]  @param below at the crankcase edge of the ring, else at the chamber edge
  double mean(const std::vector<double>& films, double begin, double end, bool below) const;
  /// Oil on the liner outside the ring at a crank angle, less what the next step owes to it [kg/m].
  double on_liner(double crank_angle_deg) const;

 private:
  struct Sweep {
    double lead_begin, lead_end;    ///< liner that the leading edge covers [m]
    double trail_begin, trail_end;  ///< liner that the other edge sets free [m]
    bool up;
    double length() const { return lead_end - lead_begin; }
  };
  Sweep sweep(double from_deg, double to_deg) const;
  /// Ahead of the ring with what the oil ring leaves there on a downstroke [kg/m].
  double mass_ahead(const Sweep& swept) const;
  void turn(bool up);

  const Setup* setup_;
  /// Where oil passes between liner and film, from the chamber edge: the balance of mass begins and ends halfway along
  /// the first and the last cell of the face [m].
  double begin_, end_;
  double reach_;                     ///< [m]
  double below_first_ring_;          ///< [m]
  std::shared_ptr<LinerFilm> film_;  ///< as all rings have left it
  LinerFilm fresh_;                  ///< as the oil ring leaves it
  LinerFilm left_;                   ///< as this ring leaves it in its present stroke
  double bead_ = 0;                  ///< negative: taken from what the next step sweeps [kg/m]
  double owed_ = 0;                  ///< behind the ring, to be laid by the next step, at most 0 [kg/m]
  film::PassedOil passed_;           ///< in the step before
  bool up_ = true;
  bool begun_ = false;
  std::array<Pass, kStrokes> passes_;
  Account account_;
  std::array<Account, kStrokes + 1> at_turns_;  ///< at the last dead centres, the latest first
};

}  // namespace ringfilm::cycle
