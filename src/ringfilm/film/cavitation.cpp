#include "ringfilm/film/cavitation.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {
namespace {

/// How far beyond the kink a node is put, and below which a change of sides does not count; relative to the scale.
constexpr double kBeyond = 1e-10;
/// Fronts that only advanced in this many iterations in a row are helped along.
constexpr int kGrowthAfter = 3;
constexpr int kLargestReach = 1 << 20;
constexpr int kRetreats = 6;
/// One step may not raise a pressure by more than this many scales: the viscosity is exponential in it.
constexpr double kLargestRise = 20;

}  // namespace

void z_from_state(const FilmState& state, double p_c, double scale, std::vector<double>& z) {
  z.resize(state.p.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    z[i] = state.deficit[i] > 0 ? -state.deficit[i] * scale : std::max(state.p[i] - p_c, kBeyond * scale);
  }
}

void state_from_z(const std::vector<double>& z, double p_c, double scale, FilmState& state) {
  for (std::size_t i = 1; i + 1 < z.size(); ++i) {
    state.p[i] = p_c + std::max(z[i], 0.0);
    state.deficit[i] = std::max(-z[i] / scale, 0.0);
  }
}

void KinkedUpdate::start() {
  reach_ = advances_ = 0;
  largest_reach_ = kLargestReach;
  retreats_left_ = kRetreats;
}

KinkedUpdate::Outcome KinkedUpdate::apply(std::vector<double>& z, const std::vector<double>& step, double scale) {
  const double beyond = kBeyond * scale;
  const int n = static_cast<int>(z.size()) - 1;
  Outcome outcome;
  flipped_.clear();
  for (int i = 1; i < n; ++i) {
    const double before = z[i];
    double after = before + (before > 0 ? std::min(step[i - 1], kLargestRise * scale) : step[i - 1]);
    if (before > 0 && after <= 0) {
      outcome.to_cavity += after < -beyond;
      after = -beyond;
    } else if (before <= 0 && after > 0) {
      if (after > beyond) {
        ++outcome.to_film;
        flipped_.push_back(i);
      }
      after = beyond;
    }
    const double change = std::abs(after - before) / std::max(scale, -after);
    if (std::isnan(change) || change > outcome.largest) outcome.largest = change;  // NaN stays
    z[i] = after;
  }
  help_along(z, outcome, beyond);
  return outcome;
}

void KinkedUpdate::help_along(std::vector<double>& z, const Outcome& outcome, double beyond) {
  const int n = static_cast<int>(z.size()) - 1;
  const bool only_advanced = outcome.to_film > 0 && outcome.to_cavity == 0;
  if (!only_advanced) {
    if (reach_ > 0) {  // helped too far: from now on in smaller strides, in the end not at all
      largest_reach_ = --retreats_left_ > 0 ? std::max(reach_ / 2, 1) : 0;
    }
    reach_ = advances_ = 0;
    return;
  }
  if (++advances_ < kGrowthAfter || largest_reach_ == 0) return;
  reach_ = std::min(std::max(2 * reach_, 1), largest_reach_);
  for (const int i : flipped_) {
    for (int k = 1; k <= reach_ && i - k > 0 && z[i - k] <= 0; ++k) z[i - k] = beyond;
    for (int k = 1; k <= reach_ && i + k < n && z[i + k] <= 0; ++k) z[i + k] = beyond;
  }
}

}  // namespace ringfilm::film
