#pragma once
#include <cstddef>
#include <limits>
#include <vector>

#include "ringfilm/case/case.hpp"

namespace ringfilm::cycle {

/// By how much the state of a cycle that repeats itself may differ from that of one cycle before [-].
double allowed_distance(const Case& c);

/// What all cycles to come may change the film in the mean of a stroke, over `solver.step_error` [-].
inline constexpr double kFilmAhead = 5;

/// The film of a cycle against that of the one before.
class FilmOfCycle {
 public:
  explicit FilmOfCycle(std::size_t n_angles) : h_m_(n_angles), before_(n_angles) {}

  void add(std::size_t angle, double h_m) { h_m_[angle] = h_m; }
  /// A cycle has ended.
  void end_cycle();
  /// By how much the last cycle has changed the film: the mean over a stroke, of the one that changed most [-].
  double moved() const { return moved_; }

 private:
  std::vector<double> h_m_, before_;  ///< smallest film thickness, by crank angle; 0: not known [m]
  double moved_ = kUnknown;
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();
};

/// How the state of a cycle approaches, from cycle to cycle, the one that repeats itself.
class Approach {
 public:
  explicit Approach(const Case& c) : follows_liner_(c.film.supply_at_inlet() == OilSupply::kFilmOnLiner) {}

  /// A cycle that does not repeat itself has ended. Throws ConvergenceError where states come no closer.
  /// @param distance from the state that repeats itself, as far as it is known  @param of_film that of the film from
  /// one cycle before  @param allowed of it, for the message
  void add(double distance, double of_film, double allowed, double crank_angle_deg);

  /// Are cycles taken that differ little, though what they add up to is not known to be small?
  bool takes_unsettled() const { return takes_unsettled_; }
  /// Settles the oil on the liner no further, and the film as little as it does?
  bool moves_on() const { return moves_on_; }

 private:
  bool follows_liner_;
  bool takes_unsettled_ = false, moves_on_ = false;
  std::vector<double> distances_;  ///< at the end of each cycle
};

}  // namespace ringfilm::cycle
