#include "ringfilm/film/cavitation.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::film {
namespace {

/// How far beyond the kink a node is put, and below which a change of sides does not count; relative to the scale.
constexpr double kBeyond = 1e-10;
/// Fronts that only advance are helped along from this iteration on.
constexpr int kGrowthFrom = 4;
constexpr int kLargestReach = 1 << 20;
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
  reach_ = 1;
  largest_reach_ = kLargestReach;
}

KinkedUpdate::Outcome KinkedUpdate::apply(std::vector<double>& z, const std::vector<double>& step, double scale,
                                          int iteration) {
  const double beyond = kBeyond * scale;
  const int n = static_cast<int>(z.size()) - 1;
  Outcome outcome;
  flipped_.clear();
  for (int i = 1; i < n; ++i) {
    const double before = z[i];
    double after = before + std::min(step[i - 1], kLargestRise * scale);
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
    outcome.largest = std::max(outcome.largest, std::abs(after - before) / scale);
    z[i] = after;
  }
  if (iteration < kGrowthFrom) return outcome;
  if (outcome.to_cavity > 0) {  // helped too far, or the front is near its place: from now on in smaller strides
    largest_reach_ = reach_ / 8;
    reach_ = 1;
  } else if (largest_reach_ > 0 && outcome.to_film > 0) {
    for (const int i : flipped_) {
      for (int k = 1; k <= reach_ && i - k > 0 && z[i - k] <= 0; ++k) z[i - k] = beyond;
      for (int k = 1; k <= reach_ && i + k < n && z[i + k] <= 0; ++k) z[i + k] = beyond;
    }
    reach_ = std::min(2 * reach_, largest_reach_);
  }
  return outcome;
}

}  // namespace ringfilm::film
