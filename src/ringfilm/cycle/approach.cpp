#include "ringfilm/cycle/approach.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/simulate.hpp"

namespace ringfilm::cycle {
namespace {

/// A film forgets its start within half a stroke, as a rule. Very cold oil on a nearly flat face is squeezed out so
/// slowly that a film of millimetres at the start loses some percent per cycle, and then each cycle leaves up to
/// 0.96 of the difference from the one before. The state is followed as long as that difference halves in so many
/// cycles, and so reaches any tolerance. One that does not is held up by something else: the rounding of the iteration,
/// or steps that differ from cycle to cycle.
constexpr std::size_t kCyclesToHalve = 50;
/// Films next to oil that moves on and on may differ by so much from cycle to cycle, with a note [-].
constexpr double kMaxUnsettled = 0.05;

}  // namespace

double allowed_distance(const Case& c) {
  const double iterated = kPeriodicityFactor * c.solver.tolerance;
  // What the iteration leaves of the forces moves a ring that bends much farther than a rigid one.
  constexpr double kSofterRing = 100;
  if (c.bends()) return kSofterRing * iterated;
  // The film follows from the oil on the liner, which is not known better.
  const bool follows_liner = c.film.supply_at_inlet() == OilSupply::kFilmOnLiner;
  return follows_liner ? std::max(iterated, c.solver.step_error) : iterated;
}

void FilmOfCycle::end_cycle() {
  const std::size_t n = h_m_.size(), n_stroke = n / 4;
  moved_ = 0;
  for (std::size_t stroke = 0; stroke < 4; ++stroke) {
    double sum = 0;
    for (std::size_t i = stroke * n_stroke; i < (stroke + 1) * n_stroke; ++i) {
      sum += h_m_[i] > 0 && before_[i] > 0 ? std::abs(std::log(h_m_[i] / before_[i])) : kUnknown;
    }
    moved_ = std::max(moved_, sum / static_cast<double>(n_stroke));
  }
  before_ = h_m_;
}

void Approach::add(double distance, double of_film, double allowed, double crank_angle_deg) {
  distances_.push_back(distance);
  const std::size_t n = distances_.size();
  if (n <= kCyclesToHalve || distance <= distances_[n - 1 - kCyclesToHalve] / 2) return;
  if (!takes_unsettled_ && follows_liner_) {
    takes_unsettled_ = true;
    distances_.clear();
    return;
  }
  if (takes_unsettled_ && of_film <= kMaxUnsettled) {
    moves_on_ = true;
    return;
  }
  throw ConvergenceError(
      formatted("the cycle does not repeat itself: after %zu cycles its state differs by %.2g from that of one cycle "
                "before, %.2g is allowed, and the difference did not halve in the last %zu cycles; take a larger %s",
                n, distance, allowed, kCyclesToHalve,
                follows_liner_ ? "solver.step_error, or supply.reach that leaves the ring more oil"
                               : "solver.tolerance or a smaller solver.crank_step"),
      crank_angle_deg);
}

}  // namespace ringfilm::cycle
