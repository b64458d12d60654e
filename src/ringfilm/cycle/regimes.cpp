#include "ringfilm/cycle/regimes.hpp"

#include <algorithm>
#include <cmath>

#include "ringfilm/cycle/setup/kinematics.hpp"

namespace ringfilm::cycle {
namespace {

/// Load shares below this one are alike [-].
constexpr double kNegligible = 1e-6;

/// Time, sliding distance and friction energy; in units of their own.
struct Extent {
  double time = 0, distance = 0, energy = 0;
};

/// Share of the step from `from` to `to` [-] at which a load share reaches a limit. It is a straight line in its
/// logarithm.
double crossing(double from, double to, double limit) {
  const auto height = [limit](double share) { return std::log(std::max(share, kNegligible) / limit); };
  return std::clamp(height(from) / (height(from) - height(to)), 0.0, 1.0);
}

/// The part of a step in which asperities carry less than `limit` of the load. Speed and power are straight lines.
Extent part_below(double limit, const Sample& from, const Sample& to, double length_deg) {
  const double a = from.asperity_load_share, b = to.asperity_load_share;
  double begin = 0, end = 1;
  if (a >= limit && b >= limit) return {};
  if (a >= limit) begin = crossing(a, b, limit);
  if (b >= limit) end = crossing(a, b, limit);
  const double length = (end - begin) * length_deg, middle = 0.5 * (begin + end);
  const auto amount = [&](double at_begin, double at_end) {
    return length * (at_begin + middle * (at_end - at_begin));
  };
  return {length, amount(std::abs(from.piston_velocity), std::abs(to.piston_velocity)),
          amount(from.power_loss, to.power_loss)};
}

/// The part of the cycle in which asperities carry less than `limit` of the load.
Extent part_below(double limit, const std::vector<Sample>& samples) {
  Extent sum;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const bool is_last = k + 1 == samples.size();
    const Sample &from = samples[k], &to = samples[is_last ? 0 : k + 1];
    const double length = to.crank_angle_deg - from.crank_angle_deg + (is_last ? kCycleDeg : 0);
    const Extent part = part_below(limit, from, to, length);
    sum.time += part.time;
    sum.distance += part.distance;
    sum.energy += part.energy;
  }
  return sum;
}

double share(double part, double whole) { return whole > 0 ? part / whole : 0; }

}  // namespace

std::string_view regime_name(Regime regime) {
  switch (regime) {
    case Regime::kBoundary:
      return "boundary";
    case Regime::kMixed:
      return "mixed";
    case Regime::kFullFilm:
      break;
  }
  return "full film";
}

void put_regime_shares(const std::vector<Sample>& samples, CycleValues& values) {
  constexpr double kAnyShare = 2;
  const Extent full = part_below(kFullFilmBelow, samples), not_boundary = part_below(kBoundaryAbove, samples),
               whole = part_below(kAnyShare, samples);
  const auto put = [&](double Extent::*extent, double& boundary, double& mixed, double& full_film) {
    boundary = share(whole.*extent - not_boundary.*extent, whole.*extent);
    mixed = share(not_boundary.*extent - full.*extent, whole.*extent);
    full_film = share(full.*extent, whole.*extent);
  };
  put(&Extent::time, values.boundary_regime_cycle_share, values.mixed_regime_cycle_share, values.full_film_cycle_share);
  put(&Extent::distance, values.boundary_regime_distance_share, values.mixed_regime_distance_share,
      values.full_film_distance_share);
  put(&Extent::energy, values.boundary_regime_energy_share, values.mixed_regime_energy_share,
      values.full_film_energy_share);
}

Regime predominant_regime(const CycleValues& values) {
  constexpr double kHalf = 0.5;
  if (values.boundary_regime_energy_share > kHalf) return Regime::kBoundary;
  const bool rubs = values.mean_boundary_power > kHalf * values.mean_power_loss;
  return values.full_film_energy_share > kHalf && !rubs ? Regime::kFullFilm : Regime::kMixed;
}

}  // namespace ringfilm::cycle
